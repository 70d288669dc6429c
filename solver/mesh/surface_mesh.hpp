#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace cleave::mesh {

/// The surface of a body: triangles, counter-clockwise seen from outside; `id` of a triangle is its patch (0: none).
struct SurfaceMesh {
    std::vector<Eigen::Vector3d> vertices;  ///< m
    std::vector<SurfaceTriangle> triangles;
    std::map<int, std::string> names;  ///< patch -> name, where the file names it
};

/// Volume enclosed by a closed surface, m^3: sum over triangles of a . (b x c) / 6 (divergence theorem). Negative where it is inside out.
double enclosed_volume(const SurfaceMesh& surface);

/// Half the cross product of two edges: the triangle's area times its outward normal, m^2.
Eigen::Vector3d area_vector(const SurfaceMesh& surface, int triangle);

/// Sum of the triangles' areas, m^2.
double total_area(const SurfaceMesh& surface);

}  // namespace cleave::mesh
