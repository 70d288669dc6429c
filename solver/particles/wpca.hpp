#pragma once

#include "solver/particles/neighbours.hpp"

namespace cleave::particles {

/// Smoothing tensors from the local shape of the body by weighted principal components (Sect. 4.1; Yu and Turk 2013, Sect. 4.1).
struct WpcaOptions {
    double window = 4;         ///< r_w in local spacings: at 4 the normal of a slab 3 s thick is right to 3 degrees, at 2 it is useless
    double largest_aspect = 4; ///< k_r: the half axes of a support differ by at most this factor
    double noise = 1.5;        ///< variances whose largest is less than this times the smallest are noise: an isotropic kernel
    int target_neighbours = 0; ///< every support holds this many others where the body has them; 0 keeps det G = h^-3 instead
    /// Factors of the user on the half axes, from the direction of the largest extent to the surface normal (Fig. 8).
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

struct WpcaReport {
    int isotropic = 0;  ///< particles whose variances are noise
    int clamped = 0;    ///< particles whose aspect was cut to largest_aspect
};

/// The shape of the body around a particle.
struct LocalShape {
    Eigen::Matrix3d axes;       ///< columns: directions of the variances; the last is the surface normal of a thin body
    Eigen::Vector3d variances;  ///< m^2, descending
};

/// Eigenvectors and eigenvalues of the covariance about the weighted mean, weights V_j (1 - (d / r_w)^3) of all particles within
/// r_w = window * s_i, particle i among them.
LocalShape local_shape(const Particles& particles, const CellGrid& grid, int i, double window);

/// Half axes of the support over its support radius, a_k = sqrt(l_k) / (l_1 l_2 l_3)^(1/6) with l_k = max(variance_k, variance_1 / k_r^2):
/// their product is one. Ones where the variances are noise.
Eigen::Vector3d relative_axes(const Eigen::Vector3d& variances, const WpcaOptions& options);

/// Gives every particle the tensor G = R diag(1 / (h a_k scale_k)) R^T: det G = h^-3 for scale one. The direction of least variance,
/// the surface normal, gets the largest entry of G. Sets support_radius to det(G)^(-1/3).
WpcaReport apply_wpca(Particles& particles, const WpcaOptions& options = {});

}  // namespace cleave::particles
