#include "solver/material/stiffness.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::material {

namespace {

/// Voigt form to the orthonormal (Kelvin) basis, in which shears carry sqrt(2).
Stiffness kelvin_form(const Stiffness& c) {
    Voigt scale;
    scale << 1, 1, 1, std::numbers::sqrt2, std::numbers::sqrt2, std::numbers::sqrt2;
    return scale.asDiagonal() * c * scale.asDiagonal();
}

/// a : S : b for the symmetric dyads of unit vectors; stresses in Voigt form, so no factor of two.
double contract(const Stiffness& s, const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return stress_to_voigt(a).dot(s * stress_to_voigt(b));
}

Eigen::Matrix3d dyad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a * b.transpose(); }

}  // namespace

Stiffness isotropic(double young, double poisson) {
    if (!(young > 0) || !(poisson > -1) || !(poisson < 0.5))
        throw std::invalid_argument(fmt::format("E > 0 and -1 < nu < 0.5 (not E = {:g} Pa, nu = {:g})", young, poisson));
    const double shear = young / (2 * (1 + poisson));
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    return cubic(lambda + 2 * shear, lambda, shear);
}

Stiffness cubic(double C11, double C12, double C44) {
    Stiffness c = Stiffness::Zero();
    c.topLeftCorner<3, 3>().setConstant(C12);
    c.diagonal() << C11, C11, C11, C44, C44, C44;
    return checked_stiffness(c);
}

Stiffness transversely_isotropic(double E1, double E2, double G12, double nu12, double nu23) {
    const double G23 = E2 / (2 * (1 + nu23));
    return orthotropic({E1, E2, E2, G23, G12, G12, nu12, nu12, nu23});
}

Stiffness orthotropic(const EngineeringConstants& k) {
    for (const double modulus : {k.E1, k.E2, k.E3, k.G23, k.G13, k.G12})
        if (!(modulus > 0)) throw std::invalid_argument(fmt::format("moduli above zero (not {:g} Pa)", modulus));
    Eigen::Matrix3d s;
    s << 1 / k.E1, -k.nu12 / k.E1, -k.nu13 / k.E1,  //
        -k.nu12 / k.E1, 1 / k.E2, -k.nu23 / k.E2,   //
        -k.nu13 / k.E1, -k.nu23 / k.E2, 1 / k.E3;
    const Eigen::LLT<Eigen::Matrix3d> factor(s * k.E1);
    if (factor.info() != Eigen::Success)
        throw std::invalid_argument(fmt::format("Poisson's ratios that leave the compliance positive definite (not nu12 = {:g}, "
                                                "nu13 = {:g}, nu23 = {:g})", k.nu12, k.nu13, k.nu23));
    const Eigen::Matrix3d normal = factor.solve(Eigen::Matrix3d::Identity()) * k.E1;
    Stiffness c = Stiffness::Zero();
    c.topLeftCorner<3, 3>() = 0.5 * (normal + normal.transpose());
    c.diagonal().tail<3>() << k.G23, k.G13, k.G12;
    return checked_stiffness(c);
}

Stiffness from_upper_triangle(const std::array<double, 21>& constants) {
    Stiffness c;
    std::size_t at = 0;
    for (int row = 0; row < 6; ++row)
        for (int column = row; column < 6; ++column) c(row, column) = c(column, row) = constants[at++];
    return checked_stiffness(c);
}

Stiffness checked_stiffness(const Stiffness& stiffness) {
    const double scale = stiffness.cwiseAbs().maxCoeff();
    if (!stiffness.allFinite()) throw std::invalid_argument("a stiffness of finite numbers");
    if ((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff() > 1e-9 * scale)
        throw std::invalid_argument("a symmetric stiffness");
    const Stiffness symmetric = 0.5 * (stiffness + stiffness.transpose());
    const double smallest = kelvin_moduli(symmetric)(0);
    // Below 1e-12 of the largest entry an eigenvalue is rounding, and the compliance means nothing.
    if (!(smallest > 1e-12 * scale))
        throw std::invalid_argument(fmt::format("a positive definite stiffness (smallest eigenvalue {:.6g} GPa)", smallest * 1e-9));
    return symmetric;
}

Voigt kelvin_moduli(const Stiffness& stiffness) {
    return Eigen::SelfAdjointEigenSolver<Stiffness>(kelvin_form(stiffness), Eigen::EigenvaluesOnly).eigenvalues();
}

Stiffness compliance(const Stiffness& stiffness) {
    const double scale = stiffness.cwiseAbs().maxCoeff();
    const Eigen::LLT<Stiffness> factor(stiffness / scale);
    if (factor.info() != Eigen::Success) throw std::invalid_argument("a positive definite stiffness");
    const Stiffness s = factor.solve(Stiffness::Identity()) / scale;
    return 0.5 * (s + s.transpose());
}

double youngs_modulus(const Stiffness& stiffness, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d n = direction.normalized();
    return 1 / contract(compliance(stiffness), dyad(n, n), dyad(n, n));
}

double poisson_ratio(const Stiffness& stiffness, const Eigen::Vector3d& load, const Eigen::Vector3d& transverse) {
    const Eigen::Vector3d n = load.normalized();
    const Eigen::Vector3d t = transverse.normalized();
    const Stiffness s = compliance(stiffness);
    return -contract(s, dyad(t, t), dyad(n, n)) / contract(s, dyad(n, n), dyad(n, n));
}

double shear_modulus(const Stiffness& stiffness, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Matrix3d pair = dyad(a.normalized(), b.normalized());
    return 1 / (4 * contract(compliance(stiffness), pair, pair));
}

EngineeringConstants engineering_constants(const Stiffness& stiffness) {
    const Stiffness s = compliance(stiffness);
    return {1 / s(0, 0), 1 / s(1, 1), 1 / s(2, 2), 1 / s(3, 3), 1 / s(4, 4), 1 / s(5, 5),
            -s(0, 1) / s(0, 0), -s(0, 2) / s(0, 0), -s(1, 2) / s(1, 1)};
}

AggregateModuli voigt_moduli(const Stiffness& c) {
    const double diagonal = c(0, 0) + c(1, 1) + c(2, 2);
    const double mixed = c(0, 1) + c(0, 2) + c(1, 2);
    return {(diagonal + 2 * mixed) / 9, (diagonal - mixed + 3 * (c(3, 3) + c(4, 4) + c(5, 5))) / 15};
}

AggregateModuli reuss_moduli(const Stiffness& stiffness) {
    const Stiffness s = compliance(stiffness);
    const double diagonal = s(0, 0) + s(1, 1) + s(2, 2);
    const double mixed = s(0, 1) + s(0, 2) + s(1, 2);
    return {1 / (diagonal + 2 * mixed), 15 / (4 * (diagonal - mixed) + 3 * (s(3, 3) + s(4, 4) + s(5, 5)))};
}

AggregateModuli hill_moduli(const Stiffness& stiffness) {
    const AggregateModuli v = voigt_moduli(stiffness), r = reuss_moduli(stiffness);
    return {0.5 * (v.bulk + r.bulk), 0.5 * (v.shear + r.shear)};
}

double hill_youngs_modulus(const Stiffness& stiffness) { return hill_moduli(stiffness).young(); }

double universal_anisotropy(const Stiffness& stiffness) {
    const AggregateModuli v = voigt_moduli(stiffness), r = reuss_moduli(stiffness);
    return 5 * v.shear / r.shear + v.bulk / r.bulk - 6;
}

}  // namespace cleave::material
