#pragma once

#include "solver/fragments/fragmented_body.hpp"

#include <Eigen/Core>

#include <functional>

namespace cleave::fragments {

/// Of a rigid fragment, in rest coordinates.
struct MassProperties {
    double volume = 0;                                  ///< m^3
    double mass = 0;                                    ///< kg
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< centre of mass, m
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass, kg m^2
};

/// From the fragment's tets, exactly (not from points at their centroids): a tet of mass m with corners x_i about its centroid c has
/// second moments m/20 sum_i (x_i - c)(x_i - c)^T; inertia = trace(M) I - M.
/// `density` gives kg/m^3 of a particle's original tet.
MassProperties mass_properties(const FragmentedBody& body, const Fragment& fragment, const std::function<double(int original_tet)>& density);

}  // namespace cleave::fragments
