#pragma once

#include "solver/contact/stroh_table.hpp"

#include <Eigen/Core>

#include <memory>

namespace cleave::contact {

/// A load at the origin of surface axes (z into the body).
struct StrohLoad {
    Eigen::Vector3d force;          ///< N
    double radius = 0;              ///< m, 0: a point force
    double other_radius = 0;        ///< m, across `axis`; equals `radius` for a circle
    Eigen::Vector2d axis{1, 0};     ///< unit, along which `radius` is measured
};

/// Displacement and its gradient in a half-space of any stiffness, for z >= 0:
///
///   u = -(1/4 pi^2) integral over a turn of A diag[g(s_alpha)/l] B^-1 f dphi,   s_alpha = (m . x + p_alpha z)/l
///
/// with g(s)/l = 1/(m . x + p z) for a point force, patch_kernel.hpp's g for Hertz's pressure, l the patch's half width along m
/// (sqrt(a^2 c^2 + b^2 s^2) for an ellipse). By the midpoint rule, whose error falls like exp(-N delta), N the directions of a turn and
/// delta the distance of the nearest singular direction from the real ones: that sets N for each place (StrohTable's levels). Point forces
/// and distant patches so close to the surface that even the finest level is too coarse are extrapolated along the normal, by a cubic.
class StrohField {
public:
    StrohField(std::shared_ptr<const StrohTable> table, const StrohLoad& load, double accuracy);

    Eigen::Vector3d displacement(const Eigen::Vector3d& position) const;
    Eigen::Matrix3d gradient(const Eigen::Vector3d& position) const;

    /// Of a point force: column k is -(1/4 pi^2) integral over a turn of A diag[1/s_alpha^(2k+1)] B^-1 f dphi, m^-2k times a displacement
    /// (column 0 is the displacement itself): what Hertz's pressure adds at a distance (patch_kernel.hpp's series).
    using Multipoles = Eigen::Matrix<double, 3, 4>;
    Multipoles multipoles(const Eigen::Vector3d& position) const;

    /// Directions of a turn that the place takes, of the displacement or gradient there.
    int directions_at(const Eigen::Vector3d& position) const;

private:
    struct Prepared;
    struct Choice {
        int level;
        double least_z;  ///< m, the depth from which on the level suffices; below it, extrapolate from there
    };
    /// `poles`: by how many orders the integrand's poles exceed those of displacements and gradients.
    Choice choose(const Eigen::Vector3d& position, int poles = 0) const;
    double decay(double distance, double z) const;
    const Prepared& prepared(int level) const;
    Eigen::Vector3d sum_displacement(const Eigen::Vector3d& position, const Prepared& level) const;
    Multipoles sum_multipoles(const Eigen::Vector3d& position, const Prepared& level) const;
    Eigen::Matrix3d sum_gradient(const Eigen::Vector3d& position, const Prepared& level) const;

    std::shared_ptr<const StrohTable> table_;
    StrohLoad load_;
    StrohTable::Bounds bounds_;
    double digits_;  // N delta that the accuracy takes
    std::shared_ptr<std::vector<std::unique_ptr<Prepared>>> levels_;
};

}  // namespace cleave::contact
