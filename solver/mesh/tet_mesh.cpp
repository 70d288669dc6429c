#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::mesh {
double signed_volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
    const Eigen::Vector3d normal = (b - a).cross(c - a), height = d - a;
    // Written out, so that the order of rounding is fixed: a vectorised form has to give the same bits.
    return ((normal[0] * height[0] + normal[1] * height[1]) + normal[2] * height[2]) / 6.0;
}

double tet_volume(const TetMesh& mesh, int tet) {
    const auto& [a, b, c, d] = mesh.tets[static_cast<std::size_t>(tet)];
    return signed_volume(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.vertices[d]);
}

Eigen::Vector3d tet_centroid(const TetMesh& mesh, int tet) {
    const auto& [a, b, c, d] = mesh.tets[static_cast<std::size_t>(tet)];
    return 0.25 * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c] + mesh.vertices[d]);
}

double total_volume(const TetMesh& mesh) {
    double sum = 0;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) sum += tet_volume(mesh, static_cast<int>(tet));
    return sum;
}

double smallest_dihedral_angle(const TetMesh& mesh, int tet) {
    const auto& corners = mesh.tets[static_cast<std::size_t>(tet)];
    std::array<Eigen::Vector3d, 4> normal;
    for (int face = 0; face < 4; ++face) {
        const auto [a, b, c] = face_of(corners, face);
        normal[face] = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    }
    double smallest = 4;
    for (int f = 0; f < 4; ++f) {
        for (int g = f + 1; g < 4; ++g) {
            // Outward normals enclose pi minus the dihedral angle; atan2 stays accurate where acos does not.
            smallest = std::min(smallest, std::atan2(normal[f].cross(normal[g]).norm(), -normal[f].dot(normal[g])));
        }
    }
    return smallest;
}

std::array<int, 3> face_of(const std::array<int, 4>& tet, int face) {
    const auto& local = face_vertices[static_cast<std::size_t>(face)];
    return {tet[local[0]], tet[local[1]], tet[local[2]]};
}

std::vector<SortedFace> sorted_faces(const TetMesh& mesh) {
    std::vector<SortedFace> faces;
    faces.reserve(4 * mesh.tets.size());
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        for (int face = 0; face < 4; ++face) {
            std::array<int, 3> vertices = face_of(mesh.tets[tet], face);
            std::sort(vertices.begin(), vertices.end());
            faces.push_back({vertices, static_cast<int>(4 * tet) + face});
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

HalfFaceLinks link_half_faces(const TetMesh& mesh) {
    HalfFaceLinks links;
    links.opposite.assign(4 * mesh.tets.size(), -1);
    const std::vector<SortedFace> faces = sorted_faces(mesh);
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        if (faces[i].vertices != faces[i + 1].vertices) continue;
        if (i + 2 < faces.size() && faces[i + 2].vertices == faces[i].vertices) {
            throw std::invalid_argument("link_half_faces: three tets share a face");
        }
        links.opposite[faces[i].half_face] = faces[i + 1].half_face;
        links.opposite[faces[i + 1].half_face] = faces[i].half_face;
        ++i;
    }
    return links;
}

}  // namespace cleave::mesh
