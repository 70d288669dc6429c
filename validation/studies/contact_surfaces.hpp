#pragma once

#include "solver/material/stiffness.hpp"
#include "validation/analytic/field.hpp"

#include <string>
#include <vector>

namespace cleave::validation {

/// A material under one direction of its surface, in the axes of the surface: z into the body.
struct ContactSurface {
    std::string name;
    material::Stiffness stiffness;  ///< Pa
    bool isotropic;
};

/// Every material of the catalogue: glass; silicon (100), (110), (111); T300/5208 and spruce with the fibre or grain along x of the
/// surface and along its normal; any further material with its axis 3 and its axis 1 along the normal.
std::vector<ContactSurface> contact_surfaces();

/// Those names out of contact_surfaces(), in the order given. Throws std::invalid_argument for an unknown one.
std::vector<ContactSurface> contact_surfaces(const std::vector<std::string>& names);

analytic::Point plain(const Eigen::Vector3d& v);
Eigen::Vector3d eigen(const analytic::Point& p);

/// |a - b| / |b|.
double relative(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace cleave::validation
