#include "reference_fem/mesh.hpp"

#include "reference_fem/vector3.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace cleave::fem {
namespace {

std::array<int, 3> face_vertices(const std::array<int, 4>& cell, int opposite) {
    std::array<int, 3> face{};
    for (int vertex = 0, next = 0; vertex < 4; ++vertex)
        if (vertex != opposite) face[next++] = cell[vertex];
    std::sort(face.begin(), face.end());
    return face;
}

/// Union-find root, with path halving.
int root_of(std::vector<int>& parent, int node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
}

}  // namespace

double signed_volume(const Mesh& mesh, int cell) {
    const auto& [a, b, c, d] = mesh.cells[cell];
    const Point& origin = mesh.vertices[a];
    return dot(cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin), mesh.vertices[d] - origin) / 6;
}

double diameter(const Mesh& mesh, int cell) {
    double longest = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j)
            longest = std::max(longest, norm(mesh.vertices[mesh.cells[cell][i]] - mesh.vertices[mesh.cells[cell][j]]));
    return longest;
}

void check_cells(const Mesh& mesh) {
    if (mesh.cells.empty()) throw Error(fmt::format("{}: the mesh has no tets (element type 4)", mesh.file));
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
        const double volume = signed_volume(mesh, cell);
        const double size = diameter(mesh, cell);
        if (!(volume > 1e-12 * size * size * size))
            throw Error(fmt::format("{}: tet {} is inverted or flat (volume {:.3g} m^3)", mesh.file, mesh.cell_elements[cell], volume));
    }
}

FaceTable::FaceTable(const Mesh& mesh) : mesh_(mesh) {
    entries_.reserve(4 * mesh.cells.size());
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
        for (int opposite = 0; opposite < 4; ++opposite) entries_.push_back({face_vertices(mesh.cells[cell], opposite), {cell, opposite}});
    std::stable_sort(entries_.begin(), entries_.end());
    for (std::size_t i = 2; i < entries_.size(); ++i)
        if (entries_[i - 2].vertices == entries_[i].vertices)
            throw Error(fmt::format("{}: tets {}, {} and {} share one face", mesh.file, mesh.cell_elements[entries_[i - 2].face.cell],
                                    mesh.cell_elements[entries_[i - 1].face.cell], mesh.cell_elements[entries_[i].face.cell]));
}

std::span<const FaceTable::Entry> FaceTable::find(std::array<int, 3> vertices) const {
    std::sort(vertices.begin(), vertices.end());
    const auto [first, last] = std::equal_range(entries_.begin(), entries_.end(), Entry{vertices, {}});
    return {first, last};
}

std::vector<BoundaryFace> FaceTable::surface(int id) const {
    std::vector<BoundaryFace> faces;
    std::set<int> known;
    for (const SurfaceTriangle& triangle : mesh_.triangles) {
        known.insert(triangle.surface);
        if (triangle.surface != id) continue;
        const auto cells = find(triangle.vertices);
        if (cells.size() != 1)
            throw Error(fmt::format("{}: surface {}: triangle {} {}; only faces of the body's surface can be loaded or held", mesh_.file,
                                    id, triangle.element, cells.empty() ? "is no face of a tet" : "lies inside the body"));
        faces.push_back(cells.front().face);
    }
    if (faces.empty()) throw Error(fmt::format("{}: no physical surface {} (the mesh has: {})", mesh_.file, id, fmt::join(known, ", ")));
    return faces;
}

std::vector<BoundaryEdge> FaceTable::line(const Line& line) const {
    const auto edges_of = [&](int id) {
        std::map<std::array<int, 2>, BoundaryEdge> edges;
        for (const BoundaryFace& face : surface(id))
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < i; ++j) {
                    if (i == face.opposite || j == face.opposite) continue;
                    const int a = mesh_.cells[face.cell][i], b = mesh_.cells[face.cell][j];
                    edges.try_emplace({std::min(a, b), std::max(a, b)}, BoundaryEdge{face.cell, {i, j}});
                }
        return edges;
    };
    const auto first = edges_of(line.first), second = edges_of(line.second);
    std::vector<BoundaryEdge> shared;
    for (const auto& [vertices, edge] : first)
        if (second.contains(vertices)) shared.push_back(edge);
    if (shared.empty()) throw Error(fmt::format("{}: the surfaces {} and {} do not meet in a line", mesh_.file, line.first, line.second));
    return shared;
}

std::vector<int> connected_parts(const Mesh& mesh) {
    std::vector<int> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const auto& cell : mesh.cells)
        for (int i = 1; i < 4; ++i) parent[root_of(parent, cell[i])] = root_of(parent, cell[0]);
    std::vector<int> number(mesh.vertices.size(), -1);
    std::vector<int> parts;
    int next = 0;
    for (const auto& cell : mesh.cells) {
        int& part = number[root_of(parent, cell[0])];
        if (part < 0) part = next++;
        parts.push_back(part);
    }
    return parts;
}

}  // namespace cleave::fem
