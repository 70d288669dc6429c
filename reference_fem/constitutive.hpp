#pragma once

#include "reference_fem/problem.hpp"

namespace cleave::fem {

using Tensor = std::array<std::array<double, 3>, 3>;

/// Hooke's law of one material, sigma_ij = C_ijkl u_k,l. Kept as a fourth-order tensor and filled by (i, j, k, l), since
/// deal.II unrolls symmetric tensors in another order (11, 22, 33, 12, 13, 23) than ours.
class Elasticity {
public:
    /// The region's stiffness, turned from its frame into the axes of the mesh. Throws Error if the stiffness is not finite, symmetric (to
    /// 1e-9 of its largest entry) and positive definite, or if the frame is not orthonormal (to 1e-9) and right-handed.
    explicit Elasticity(const Region& region);

    double operator()(int i, int j, int k, int l) const { return tensor_[i][j][k][l]; }

    /// Pa, from the displacement gradient (gradient[i][j] = du_i/dx_j).
    Voigt stress(const Tensor& gradient) const;
    /// Pa, from strain with engineering shear.
    Voigt stress(const Voigt& strain) const;

private:
    Stiffness stiffness_{};
    std::array<std::array<Tensor, 3>, 3> tensor_;
};

/// Engineering strain of a displacement gradient: (u_x,x, ..., u_y,z + u_z,y, ...).
Voigt engineering_strain(const Tensor& gradient);

/// Position in the Voigt order xx, yy, zz, yz, xz, xy of the component (i, j).
constexpr int voigt_index(int i, int j) { return i == j ? i : 6 - i - j; }

}  // namespace cleave::fem
