#include "solver/fracture/criterion.hpp"

#include <Eigen/Eigenvalues>

namespace cleave::fracture {

namespace {

/// A crack has no front and back: of n and -n the one whose largest component is positive.
Eigen::Vector3d one_of_both(const Eigen::Vector3d& direction) {
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    return direction(largest) < 0 ? Eigen::Vector3d(-direction) : direction;
}

}  // namespace

Principal largest_principal(const Eigen::Matrix3d& tensor) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    const Eigen::Vector3d& values = solver.eigenvalues();  // ascending
    const double norm = tensor.norm();
    return {values(2), one_of_both(solver.eigenvectors().col(2)), norm > 0 ? (values(2) - values(1)) / norm : 0};
}

Principal rankine(const material::Voigt& stress, const material::Voigt& strain, Criterion criterion) {
    return largest_principal(criterion == Criterion::stress ? material::stress_from_voigt(stress) : material::strain_from_voigt(strain));
}

}  // namespace cleave::fracture
