#include "reference_fem/inertia_relief.hpp"

#include "reference_fem/vector3.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cleave::fem {
namespace {

using Vector = Eigen::VectorXd;

/// Three translations, and three rotations about `centre` by 1 / size.
std::array<Point, 6> rigid_motions(const Point& x, const Point& centre, double size) {
    std::array<Point, 6> motions{};
    for (int axis = 0; axis < 3; ++axis) {
        Point unit{};
        unit[axis] = 1;
        motions[axis] = unit;
        motions[3 + axis] = cross(1 / size * unit, x - centre);
    }
    return motions;
}

std::vector<double> density_by_cell(const Mesh& mesh, const std::vector<Region>& regions) {
    std::map<int, double> of_region;
    for (const Region& region : regions) {
        if (!(region.density > 0)) throw Error(fmt::format("region {}: a free body needs a density", region.id));
        of_region[region.id] = region.density;
    }
    std::vector<double> densities;
    for (const int region : mesh.cell_regions) densities.push_back(of_region.at(region));
    return densities;
}

int farthest(const std::vector<Point>& points, const auto& distance) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(points.size()); ++i)
        if (distance(points[i]) > distance(points[best])) best = i;
    return best;
}

int largest_component(const Point& v) {
    int best = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(v[i]) > std::abs(v[best])) best = i;
    return best;
}

Eigen::Map<Vector> as_vector(std::vector<double>& values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }

}  // namespace

InertiaRelief::InertiaRelief(const Solution::Data& data, const std::vector<Region>& regions)
    : data_(data), motions_(Motions::Zero(data.space.dofs(), 6)), momentum_(Motions::Zero(data.space.dofs(), 6)) {
    const Mesh& mesh = data.mesh;
    const std::vector<int> parts = connected_parts(mesh);
    if (*std::max_element(parts.begin(), parts.end()) > 0) throw Error(fmt::format("{}: a free body must be in one part", mesh.file));
    const std::vector<double> density = density_by_cell(mesh, regions);
    const Point& centre = mesh.vertices.front();
    const double size = norm(mesh.vertices[farthest(mesh.vertices, [&](const Point& p) { return norm(p - centre); })] - centre);

    const ShapeTable table(data.space, 3);
    const int nodes = data.space.nodes_per_cell();
    const double reference_volume = 1.0 / 6;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
        const auto at = [&](const std::array<double, 4>& barycentric) {
            Point x{};
            for (int i = 0; i < 4; ++i) x = x + barycentric[i] * mesh.vertices[mesh.cells[cell][i]];
            return rigid_motions(x, centre, size);
        };
        for (int node = 0; node < nodes; ++node) {
            const auto motions = at(data.space.node_barycentrics()[node]);
            for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 6; ++k) motions_(data.space.dof(cell, node, i), k) = motions[k][i];
        }
        for (std::size_t q = 0; q < table.rule.points.size(); ++q) {
            const Point& unit = table.rule.points[q];
            const auto motions = at({1 - unit[0] - unit[1] - unit[2], unit[0], unit[1], unit[2]});
            const double weight = density[cell] * signed_volume(mesh, cell) / reference_volume * table.rule.weights[q];
            for (int node = 0; node < nodes; ++node)
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 6; ++k) momentum_(data.space.dof(cell, node, i), k) += weight * table.values[q][node] * motions[k][i];
        }
    }
    mass_ = momentum_.transpose() * motions_;  // nodal values represent rigid motions exactly
}

void InertiaRelief::balance(std::vector<double>& load) const {
    const Vector work = motions_.transpose() * as_vector(load);
    as_vector(load) -= momentum_ * mass_.llt().solve(work);
}

std::vector<Support> InertiaRelief::supports() const {
    const std::vector<Point>& vertices = data_.mesh.vertices;
    const Point& first = vertices.front();
    const Point& second = vertices[farthest(vertices, [&](const Point& p) { return norm(p - first); })];
    const Point axis = second - first;
    const Point& third = vertices[farthest(vertices, [&](const Point& p) { return norm(cross(axis, p - first)); })];
    Support two{.point = second, .components = {true, true, true}, .value = {}}, one{.point = third, .components = {}, .value = {}};
    two.components[largest_component(axis)] = false;
    one.components[largest_component(cross(axis, third - first))] = true;
    return {{.point = first, .components = {true, true, true}, .value = {}}, two, one};
}

void InertiaRelief::remove_rigid_motion(std::vector<double>& displacement) const {
    const Vector momentum = momentum_.transpose() * as_vector(displacement);
    as_vector(displacement) -= motions_ * mass_.llt().solve(momentum);
}

}  // namespace cleave::fem
