#pragma once

#include "solver/contact/hertz.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <array>

namespace cleave::contact {

using Tet = std::array<Eigen::Vector3d, 4>;  ///< corners, m, either orientation

/// The tet of a mesh, by its corners.
Tet corners_of(const mesh::TetMesh& mesh, int tet);

/// Area of contact as the paper's Eq. 11 weighs it ("we check the contact area of two tetrahedra"; how, it does not say): the overlap of
/// the two tets' shadows on the plane across `normal`, m^2.
double shadow_overlap_area(const Tet& first, const Tet& second, const Eigen::Vector3d& normal);

/// pi a^2 (m^2).
double hertz_contact_area(const HertzContact& contact);

/// pi a b (m^2).
double hertz_contact_area(const EllipticalContact& contact);

}  // namespace cleave::contact
