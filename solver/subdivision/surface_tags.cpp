#include "solver/subdivision/surface_tags.hpp"

#include <algorithm>
#include <utility>

namespace cleave::subdivision {

std::vector<mesh::SurfaceTriangle> cut_surface(const mesh::TetMesh& original, const Subdivided& out) {
    std::vector<std::vector<int>> pieces(4 * original.tets.size());  // half faces of children, by original half face
    for (std::size_t h = 0; h < out.parent_face.size(); ++h) {
        if (out.cut[h / 4] < 0 || out.parent_face[h] < 0) continue;
        pieces[4 * out.parent[h / 4] + out.parent_face[h]].push_back(static_cast<int>(h));
    }
    const std::vector<mesh::SortedFace> faces = mesh::sorted_faces(original);
    std::vector<mesh::SurfaceTriangle> surface;
    for (const mesh::SurfaceTriangle& triangle : original.surface) {
        mesh::SortedFace key{triangle.vertices, -1};
        std::sort(key.vertices.begin(), key.vertices.end());
        auto at = std::upper_bound(faces.begin(), faces.end(), key);
        while (at != faces.end() && at->vertices == key.vertices && pieces[at->half_face].empty()) ++at;
        if (at == faces.end() || at->vertices != key.vertices) {
            surface.push_back(triangle);
            continue;
        }
        const auto corners = mesh::face_of(original.tets[at->half_face / 4], at->half_face % 4);
        const auto first = std::find(triangle.vertices.begin(), triangle.vertices.end(), corners[0]) - triangle.vertices.begin();
        const bool outward = triangle.vertices[(first + 1) % 3] == corners[1];
        for (const int piece : pieces[at->half_face]) {
            auto [a, b, c] = mesh::face_of(out.mesh.tets[piece / 4], piece % 4);
            if (!outward) std::swap(b, c);
            surface.push_back({{a, b, c}, triangle.id});
        }
    }
    return surface;
}

}  // namespace cleave::subdivision
