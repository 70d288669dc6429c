#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/particles/particles.hpp"
#include "solver/particles/smoothing_tensor.hpp"

#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <random>

namespace cleave::particles::test {

/// Where a vertex of the unit cube's lattice goes: keeps faces on faces.
using Grading = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Edge lengths grow about `ratio` times from one end to the other, along each axis.
inline Grading graded(double ratio) {
    return [ratio](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return ((x * std::log(ratio)).array().exp() - 1) / (ratio - 1);
    };
}

/// A lattice of n[0] x n[1] x n[2] unit cells in six tets each (Kuhn), inner vertices moved at random by up to `jitter`: irregular,
/// all positive for jitter <= 0.2. Then every vertex goes where `place` says.
inline mesh::TetMesh lattice_mesh(const std::array<int, 3>& n, double jitter, const Grading& place, unsigned seed = 1) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-jitter, jitter);
    mesh::TetMesh mesh{};
    const auto vertex = [&n](const std::array<int, 3>& at) { return (at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0]; };
    for (int k = 0; k <= n[2]; ++k)
        for (int j = 0; j <= n[1]; ++j)
            for (int i = 0; i <= n[0]; ++i) {
                const std::array<int, 3> at{i, j, k};
                Eigen::Vector3d x(i, j, k);
                for (int a = 0; a < 3; ++a) {
                    const double moved = uniform(generator);
                    if (at[a] > 0 && at[a] < n[a]) x[a] += moved;
                }
                mesh.vertices.push_back(place(x));
            }
    constexpr std::array<std::array<int, 3>, 6> paths{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                for (const auto& path : paths) {
                    std::array<int, 3> at{i, j, k};
                    std::array<int, 4> tet{};
                    for (int step = 0; step < 4; ++step) {
                        tet[step] = vertex(at);
                        if (step < 3) ++at[path[step]];
                    }
                    mesh.tets.push_back(tet);
                    mesh.regions.push_back(0);
                    const int last = static_cast<int>(mesh.tets.size()) - 1;
                    if (mesh::tet_volume(mesh, last) < 0) std::swap(mesh.tets[last][2], mesh.tets[last][3]);
                }
    return mesh;
}

/// The unit cube in 6 n^3 tets; `jitter` in cells.
inline mesh::TetMesh box_mesh(int n, double jitter = 0.2, const Grading& grading = {}, unsigned seed = 1) {
    const auto place = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return grading ? grading(x / n) : Eigen::Vector3d(x / n); };
    return lattice_mesh({n, n, n}, jitter, place, seed);
}

inline Eigen::Matrix3d random_rotation(std::mt19937& generator) {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q(normal(generator), normal(generator), normal(generator), normal(generator));
    return q.normalized().toRotationMatrix();
}

/// Stretches every kernel by `aspect` (largest over smallest half axis) in its own random direction, det G kept.
inline void stretch_kernels(Particles& particles, double aspect, std::mt19937& generator) {
    const Eigen::Vector3d radii(std::pow(aspect, 2.0 / 3), std::pow(aspect, -1.0 / 3), std::pow(aspect, -1.0 / 3));
    for (int i = 0; i < particles.size(); ++i)
        particles.tensor[i] = tensor_from_axes(random_rotation(generator), particles.support_radius[i] * radii);
}

/// True for particles further than `depth` from the faces of the unit cube.
inline bool is_inner(const Eigen::Vector3d& x, double depth) { return x.minCoeff() > depth && x.maxCoeff() < 1 - depth; }

}  // namespace cleave::particles::test
