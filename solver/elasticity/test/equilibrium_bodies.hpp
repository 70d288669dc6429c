#pragma once

#include "solver/elasticity/equilibrium.hpp"
#include "solver/material/test/test_materials.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cleave::elasticity::test {

/// Ids of the unit cube's sides: x = 0, x = 1, y = 0, ... ; crack lips have their own.
enum Side { left = 1, right, front, back, bottom, top, crack };

inline int side_of(const Eigen::Vector3d& x) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(x[axis]) < 1e-9) return 2 * axis + 1;
        if (std::abs(x[axis] - 1) < 1e-9) return 2 * axis + 2;
    }
    return crack;
}

/// Tags every boundary face by where its centroid lies.
inline void tag_boundary(mesh::TetMesh& mesh, const std::function<int(const Eigen::Vector3d&)>& id = side_of) {
    mesh.surface.clear();
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    for (int half = 0; half < static_cast<int>(links.opposite.size()); ++half) {
        if (links.opposite[half] >= 0) continue;
        const auto vertices = mesh::face_of(mesh.tets[half / 4], half % 4);
        Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
        for (const int vertex : vertices) centroid += mesh.vertices[vertex] / 3;
        mesh.surface.push_back({vertices, id(centroid)});
    }
}

/// The unit cube with tagged sides, irregular inside.
inline mesh::TetMesh tagged_cube(int n, double jitter = 0.2) {
    mesh::TetMesh mesh = particles::test::box_mesh(n, jitter);
    tag_boundary(mesh);
    return mesh;
}

/// Doubles the vertices of the inner faces whose three vertices are `on` the crack; those of its front stay single: round each vertex
/// the tets that still hang together by other faces keep one copy.
inline void open_crack(mesh::TetMesh& mesh, const std::function<bool(const Eigen::Vector3d&)>& on) {
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    const std::vector<std::array<int, 4>> tets = mesh.tets;
    const auto is_cut = [&](int half) {
        const auto face = mesh::face_of(tets[half / 4], half % 4);
        return std::all_of(face.begin(), face.end(), [&](int vertex) { return on(mesh.vertices[vertex]); });
    };
    std::map<int, std::set<int>> around;
    for (int tet = 0; tet < static_cast<int>(tets.size()); ++tet)
        for (const int vertex : tets[tet])
            if (on(mesh.vertices[vertex])) around[vertex].insert(tet);
    for (auto& [vertex, rest] : around) {
        for (bool first = true; !rest.empty(); first = false) {
            std::vector<int> open{*rest.begin()}, piece;
            rest.erase(rest.begin());
            while (!open.empty()) {
                const int tet = open.back();
                open.pop_back();
                piece.push_back(tet);
                for (int face = 0; face < 4; ++face) {
                    const int half = 4 * tet + face, other = links.opposite[half] / 4;
                    if (links.opposite[half] < 0 || is_cut(half) || rest.erase(other) == 0) continue;
                    open.push_back(other);
                }
            }
            if (first) continue;
            mesh.vertices.push_back(mesh.vertices[vertex]);
            const int copy = static_cast<int>(mesh.vertices.size()) - 1;
            for (const int tet : piece) std::replace(mesh.tets[tet].begin(), mesh.tets[tet].end(), vertex, copy);
        }
    }
}

/// The irregular cube with a crack in its middle plane z = 1/2, |x - 1/2|, |y - 1/2| <= half; n even.
inline mesh::TetMesh cracked_cube(int n, double half) {
    // Vertices near the plane z = 1/2 are put onto it: the crack stays plane.
    mesh::TetMesh mesh = particles::test::box_mesh(n, 0.15);
    for (Eigen::Vector3d& x : mesh.vertices)
        if (std::abs(x.z() - 0.5) < 0.3 / n) x.z() = 0.5;
    open_crack(mesh, [=](const Eigen::Vector3d& x) {
        return x.z() == 0.5 && std::abs(x.x() - 0.5) < half && std::abs(x.y() - 0.5) < half;
    });
    tag_boundary(mesh);
    return mesh;
}

inline material::Stiffness triclinic(unsigned seed = 3) {
    std::mt19937 generator(seed);
    return material::test::random_triclinic(generator);
}

/// u = A x + b with all entries at work, strains of about 1e-3.
struct LinearField {
    Eigen::Matrix3d gradient = (Eigen::Matrix3d() << 1.3, -0.7, 0.4, 0.9, -1.1, 0.6, -0.5, 0.8, 1.7).finished() * 1e-3;
    Eigen::Vector3d offset = Eigen::Vector3d(0.3, -2, 5) * 1e-3;

    Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return gradient * x + offset; }
};

inline Eigen::Matrix3d stress_matrix(const material::Stiffness& stiffness, const Eigen::Matrix3d& gradient) {
    return material::stress_from_voigt(stiffness * strain_of(gradient));
}

/// Largest difference of any displacement over the largest displacement.
inline double worst_displacement(const EquilibriumSolution& solution, const VectorField& exact) {
    double worst = 0, scale = 0;
    for (int i = 0; i < solution.body->particles.size(); ++i) {
        const Eigen::Vector3d u = exact(solution.body->particles.position[i]);
        worst = std::max(worst, (solution.displacement[i] - u).norm());
        scale = std::max(scale, u.norm());
    }
    return worst / scale;
}

/// Random displacements of size one.
inline std::vector<Eigen::Vector3d> random_vectors(int count, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<Eigen::Vector3d> values(count);
    for (Eigen::Vector3d& value : values) value = Eigen::Vector3d(normal(generator), normal(generator), normal(generator));
    return values;
}

}  // namespace cleave::elasticity::test
