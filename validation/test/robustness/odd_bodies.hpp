// Bodies that strain the numerics: turned into other numbers and other units, with slivers, far longer than wide.
#pragma once

#include "solver/elasticity/test/equilibrium_bodies.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <random>
#include <string>
#include <vector>

namespace cleave::robustness {

/// All lengths times `unit`.
mesh::TetMesh scaled(mesh::TetMesh mesh, double unit);

/// A mesh whose vertices and tets stand in another order, and whose tets list their vertices in another (even) order.
struct Renumbered {
    mesh::TetMesh mesh;
    std::vector<int> tet;  ///< the new number of each tet
};
Renumbered renumbered(const mesh::TetMesh& mesh, unsigned seed);

/// The unit cube (Kuhn, `cells` per edge), tagged as tagged_cube, a vertex of every second layer moved to within `height` edges of the middle
/// of a face opposite to it: slivers whose smallest dihedral angle is about `height`, all positive, since a vertex's star is convex.
mesh::TetMesh sliver_cube(int cells, double height);

/// Smallest dihedral angle of a mesh, rad.
double smallest_dihedral_angle(const mesh::TetMesh& mesh);

/// A lattice of cells on [0, extent], irregular inside, sides tagged as tagged_cube.
mesh::TetMesh tagged_block(const std::array<int, 3>& cells, const Eigen::Vector3d& extent);

/// A stiffness (Pa) with all constants different from zero, whose Kelvin moduli run from `largest` / `condition` to `largest`.
material::Stiffness ill_conditioned(double largest, double condition, unsigned seed);

/// max |a_i - b_i| over max |b_i|; infinite where the sizes differ or a number is not finite.
template <class Values>
double difference(const Values& a, const Values& b) {
    if (a.size() != b.size()) return INFINITY;
    double most = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double apart = (a[i] - b[i]).norm();
        if (!std::isfinite(apart)) return INFINITY;
        most = std::max(most, apart);
        size = std::max(size, b[i].norm());
    }
    return size > 0 ? most / size : most;
}

/// The same of plain numbers.
double difference(const std::vector<double>& a, const std::vector<double>& b);

/// Relative difference of two numbers.
double difference(double a, double b);

/// Each times `factor`.
template <class Values>
Values times(double factor, Values values) {
    for (auto& value : values) value *= factor;
    return values;
}

/// values[of[i]] at i: what belongs to the new number of a tet at its old one.
template <class Values>
Values picked(const Values& values, const std::vector<int>& of) {
    Values result;
    for (const int i : of) result.push_back(values[static_cast<std::size_t>(i)]);
    return result;
}

}  // namespace cleave::robustness
