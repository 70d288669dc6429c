#include "solver/elasticity/conforming_faces.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace cleave::elasticity {

FaceSet collect_faces(const mesh::TetMesh& mesh) {
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    FaceSet set;
    set.of_half_face.resize(links.opposite.size());
    for (int half = 0; half < static_cast<int>(links.opposite.size()); ++half) {
        const int opposite = links.opposite[half];
        if (opposite >= 0 && opposite < half) {
            set.of_half_face[half] = set.of_half_face[opposite];
            continue;
        }
        const auto [a, b, c] = mesh::face_of(mesh.tets[half / 4], half % 4);
        const Eigen::Vector3d &x = mesh.vertices[a], &y = mesh.vertices[b], &z = mesh.vertices[c];
        set.of_half_face[half] = set.size();
        set.faces.push_back({(x + y + z) / 3, 0.5 * (y - x).cross(z - x), half / 4, opposite < 0 ? -1 : opposite / 4});
    }
    return set;
}

std::vector<int> surface_ids(const mesh::TetMesh& mesh, const FaceSet& faces) {
    std::vector<std::pair<std::array<int, 3>, int>> tagged;
    for (const mesh::SurfaceTriangle& triangle : mesh.surface) {
        std::array<int, 3> vertices = triangle.vertices;
        std::sort(vertices.begin(), vertices.end());
        tagged.emplace_back(vertices, triangle.id);
    }
    std::sort(tagged.begin(), tagged.end());
    std::vector<int> ids(faces.faces.size(), -1);
    for (std::size_t half = 0; half < faces.of_half_face.size(); ++half) {
        const int face = faces.of_half_face[half];
        if (!faces.faces[face].is_boundary()) continue;
        std::array<int, 3> vertices = mesh::face_of(mesh.tets[half / 4], static_cast<int>(half % 4));
        std::sort(vertices.begin(), vertices.end());
        const auto at = std::lower_bound(tagged.begin(), tagged.end(), std::pair{vertices, 0},
                                         [](const auto& x, const auto& y) { return x.first < y.first; });
        if (at != tagged.end() && at->first == vertices) ids[face] = at->second;
    }
    return ids;
}

std::vector<int> connected_pieces(const FaceSet& faces, int tets) {
    std::vector<int> root(tets);
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](int tet) {
        while (root[tet] != tet) tet = root[tet] = root[root[tet]];
        return tet;
    };
    for (const Face& face : faces.faces) {
        if (face.is_boundary()) continue;
        const int a = find(face.inside), b = find(face.outside);
        root[std::max(a, b)] = std::min(a, b);
    }
    std::vector<int> number(tets, -1);
    int pieces = 0;
    for (int tet = 0; tet < tets; ++tet) {
        const int first = find(tet);  // the smallest tet of the piece, hence numbered already
        number[tet] = first == tet ? pieces++ : number[first];
    }
    return number;
}

}  // namespace cleave::elasticity
