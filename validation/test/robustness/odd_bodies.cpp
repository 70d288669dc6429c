#include "validation/test/robustness/odd_bodies.hpp"

#include "solver/mesh/test/test_meshes.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cleave::robustness {

namespace {

std::vector<int> shuffled_numbers(std::size_t count, std::mt19937& generator) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    for (std::size_t i = count; i > 1; --i) std::swap(numbers[i - 1], numbers[generator() % i]);  // std::shuffle's bits are not fixed
    return numbers;
}

/// One of the twelve orders of a tet's vertices that keep its orientation.
std::array<int, 4> reordered(std::array<int, 4> tet, std::mt19937& generator) {
    std::rotate(tet.begin(), tet.begin() + 1, tet.begin() + 3);  // turns three
    for (auto turns = generator() % 3; turns > 0; --turns) std::rotate(tet.begin() + 1, tet.begin() + 2, tet.end());
    if (generator() % 2 == 0) std::swap(tet[0], tet[1]), std::swap(tet[2], tet[3]);
    if (generator() % 2 == 0) std::swap(tet[0], tet[2]), std::swap(tet[1], tet[3]);
    return tet;
}

}  // namespace

mesh::TetMesh scaled(mesh::TetMesh mesh, double unit) {
    for (Eigen::Vector3d& x : mesh.vertices) x *= unit;
    return mesh;
}

Renumbered renumbered(const mesh::TetMesh& mesh, unsigned seed) {
    std::mt19937 generator(seed);
    const std::vector<int> vertex = shuffled_numbers(mesh.vertices.size(), generator);
    Renumbered result{mesh, shuffled_numbers(mesh.tets.size(), generator)};
    for (std::size_t v = 0; v < vertex.size(); ++v) result.mesh.vertices[static_cast<std::size_t>(vertex[v])] = mesh.vertices[v];
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        std::array<int, 4> tet = mesh.tets[t];
        for (int& v : tet) v = vertex[static_cast<std::size_t>(v)];
        const auto to = static_cast<std::size_t>(result.tet[t]);
        result.mesh.tets[to] = reordered(tet, generator);
        result.mesh.regions[to] = mesh.regions[t];
    }
    for (mesh::SurfaceTriangle& triangle : result.mesh.surface)
        for (int& v : triangle.vertices) v = vertex[static_cast<std::size_t>(v)];
    return result;
}

mesh::TetMesh sliver_cube(int cells, double height) {
    mesh::TetMesh mesh = mesh::test::kuhn_cube(cells);
    const int side = cells + 1;
    std::vector<char> moved(mesh.vertices.size(), 0);
    for (int k = 1; k < cells; k += 2)
        for (int j = 1; j < cells; j += 2)
            for (int i = 1; i < cells; i += 2) moved[i + side * (j + side * k)] = 1;
    for (const auto& tet : mesh.tets)
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto vertex = static_cast<std::size_t>(tet[corner]);
            if (moved[vertex] != 1) continue;
            const auto [a, b, c] = mesh::face_of(tet, static_cast<int>(corner));
            const Eigen::Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
            mesh.vertices[vertex] = middle + height * (mesh.vertices[vertex] - middle);
            moved[vertex] = 2;
        }
    elasticity::test::tag_boundary(mesh);
    return mesh;
}

double smallest_dihedral_angle(const mesh::TetMesh& mesh) {
    double smallest = INFINITY;
    for (int tet = 0; tet < static_cast<int>(mesh.tets.size()); ++tet) smallest = std::min(smallest, mesh::smallest_dihedral_angle(mesh, tet));
    return smallest;
}

mesh::TetMesh tagged_block(const std::array<int, 3>& cells, const Eigen::Vector3d& extent) {
    const Eigen::Vector3d n(cells[0], cells[1], cells[2]);
    mesh::TetMesh mesh = particles::test::lattice_mesh(cells, 0.2, [&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return x.cwiseQuotient(n); });
    elasticity::test::tag_boundary(mesh);
    for (Eigen::Vector3d& x : mesh.vertices) x = x.cwiseProduct(extent);
    return mesh;
}

material::Stiffness ill_conditioned(double largest, double condition, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    material::Stiffness random;
    for (int i = 0; i < 36; ++i) random(i) = normal(generator);
    const material::Stiffness basis = Eigen::HouseholderQR<material::Stiffness>(random).householderQ();
    material::Voigt moduli;
    for (int k = 0; k < 6; ++k) moduli[k] = largest * std::pow(condition, k / 5.0 - 1);
    material::Stiffness kelvin = basis * moduli.asDiagonal() * basis.transpose();
    // Kelvin's form has sqrt(2) in front of the shears.
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) kelvin(i, j) /= (i < 3 ? 1 : std::sqrt(2.0)) * (j < 3 ? 1 : std::sqrt(2.0));
    return material::checked_stiffness(0.5 * (kelvin + kelvin.transpose()));
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<Eigen::Matrix<double, 1, 1>> one, other;
    for (const double value : a) one.emplace_back(value);
    for (const double value : b) other.emplace_back(value);
    return difference(one, other);
}

double difference(double a, double b) { return difference(std::vector{a}, std::vector{b}); }

}  // namespace cleave::robustness
