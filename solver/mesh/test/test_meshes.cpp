#include "solver/mesh/test/test_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace cleave::mesh::test {
namespace {

/// The six paths from corner 000 to 111 along the axes, each a positive tet.
std::vector<std::array<int, 4>> kuhn_paths() {
    std::vector<std::array<int, 4>> paths;
    std::array<int, 3> axes{0, 1, 2};
    do {
        const int first = 1 << axes[0];
        std::array<int, 4> path{0, first, first | (1 << axes[1]), 7};
        const bool even = ((axes[0] < axes[1]) + (axes[1] < axes[2]) + (axes[0] < axes[2])) % 2 == 1;
        if (!even) std::swap(path[1], path[2]);
        paths.push_back(path);
    } while (std::next_permutation(axes.begin(), axes.end()));
    return paths;
}

}  // namespace

TetMesh kuhn_cube(int cells, double shake) {
    TetMesh mesh;
    const int side = cells + 1;
    const auto inside = [&](int i) { return i > 0 && i < cells; };
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                Eigen::Vector3d point(i, j, k);
                const double phase = 12.9898 * i + 78.233 * j + 37.719 * k;
                if (inside(i) && inside(j) && inside(k)) {
                    point += shake * Eigen::Vector3d(std::sin(phase), std::sin(2 * phase + 1), std::sin(3 * phase + 2));
                }
                mesh.vertices.push_back(point / cells);
            }
        }
    }
    const auto paths = kuhn_paths();
    for (int k = 0; k < cells; ++k) {
        for (int j = 0; j < cells; ++j) {
            for (int i = 0; i < cells; ++i) {
                for (const auto& path : paths) {
                    std::array<int, 4> tet{};
                    for (int v = 0; v < 4; ++v) {
                        const int x = i + (path[v] & 1), y = j + ((path[v] >> 1) & 1), z = k + ((path[v] >> 2) & 1);
                        tet[v] = x + side * (y + side * z);
                    }
                    mesh.tets.push_back(tet);
                }
            }
        }
    }
    mesh.regions.assign(mesh.tets.size(), 1);
    return mesh;
}

TetMesh unit_tet() {
    TetMesh mesh;
    mesh.vertices = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
    mesh.tets = {{0, 1, 2, 3}};
    mesh.regions = {1};
    return mesh;
}

SurfaceMesh cube_surface() {
    SurfaceMesh surface;
    for (int i = 0; i < 8; ++i) surface.vertices.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    const std::array<std::array<int, 4>, 6> sides{{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& [a, b, c, d] : sides) {
        surface.triangles.push_back({{a, b, c}, 0});
        surface.triangles.push_back({{a, c, d}, 0});
    }
    return surface;
}

SurfaceMesh sphere_surface(int rounds) {
    SurfaceMesh surface;
    for (int axis = 0; axis < 3; ++axis) {
        surface.vertices.push_back(Eigen::Vector3d::Unit(axis));
        surface.vertices.push_back(-Eigen::Vector3d::Unit(axis));
    }
    for (int octant = 0; octant < 8; ++octant) {
        std::array<int, 3> corners{octant & 1, 2 + (octant >> 1 & 1), 4 + (octant >> 2 & 1)};
        if ((corners[0] + corners[1] + corners[2]) % 2 == 1) std::swap(corners[0], corners[1]);  // a mirrored octant
        surface.triangles.push_back({corners, 0});
    }
    for (int round = 0; round < rounds; ++round) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(surface.vertices.size()));
            if (is_new) surface.vertices.push_back((surface.vertices[a] + surface.vertices[b]).normalized());
            return found->second;
        };
        std::vector<SurfaceTriangle> finer;
        for (const SurfaceTriangle& triangle : surface.triangles) {
            const auto [a, b, c] = triangle.vertices;
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::array<int, 3>& part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) finer.push_back({part, 0});
        }
        surface.triangles = std::move(finer);
    }
    return surface;
}

}  // namespace cleave::mesh::test
