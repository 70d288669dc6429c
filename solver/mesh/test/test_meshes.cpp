#include "solver/mesh/test/test_meshes.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace cleave::mesh::test
