#pragma once

#include "solver/input/table_reader.hpp"
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

/// Every material of the catalogue: an isotropic one as it is; a cubic one with (100), (110) and (111) on the surface; others "in surface"
/// (axis 1, the fibre or grain, along x of the surface, axis 3 along its normal) and "normal" (axis 1 along the normal).
std::vector<ContactSurface> contact_surfaces();

/// Those names out of contact_surfaces(), in the order given. Throws std::invalid_argument for an unknown one.
std::vector<ContactSurface> contact_surfaces(const std::vector<std::string>& names);

/// Reads a key with names of surfaces. Throws InputError.
std::vector<ContactSurface> read_surfaces(TableReader& study, const std::string& key = "surfaces");

/// One surface of every material: isotropic, (111) or normal.
std::vector<ContactSurface> one_surface_of_each();

/// Of all surfaces, in their order.
std::vector<material::Stiffness> stiffnesses(const std::vector<ContactSurface>& surfaces);

analytic::Point plain(const Eigen::Vector3d& v);
Eigen::Vector3d eigen(const analytic::Point& p);

/// |a - b| / |b|.
double relative(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace cleave::validation
