#pragma once

#include "reference_fem/contact_surface.hpp"

#include <Eigen/Core>

namespace cleave::fem {

/// The body as its contact surface sees it: normal displacement of the nodes w = compliance * f + far_field * P, f the nodal forces along
/// z and P the total force into the body. All of the modelled share.
struct CondensedBody {
    Eigen::MatrixXd compliance;  ///< m/N
    Eigen::VectorXd far_field;   ///< m/N, what the displacement of the outer surface under the unit force adds
};

struct ContactState {
    Eigen::VectorXd forces;  ///< N along z, by node
    double depth = 0;        ///< m
    int iterations = 0;
};

/// A paraboloid of that radius of curvature on the z axis, pressed with `force` (N, of the modelled share) against a penalty (Pa/m).
/// Newton's method with halved steps where the residual would grow. Throws Error after 60 steps.
ContactState press_paraboloid(const CondensedBody& body, const ContactSurface& surface, double radius, double force, double penalty);

/// Pressure on each point of the surface, Pa.
std::vector<double> penalty_pressure(const ContactSurface& surface, const Eigen::VectorXd& displacement, double radius, double depth,
                                     double penalty);

}  // namespace cleave::fem
