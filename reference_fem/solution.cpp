#include "reference_fem/recovery.hpp"
#include "reference_fem/solution_data.hpp"
#include "reference_fem/vector3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cleave::fem {
namespace {

/// One address per cell into `elasticities`, which stand in the order of `regions`.
std::vector<const Elasticity*> by_cell(const Mesh& mesh, const std::vector<Region>& regions, const std::vector<Elasticity>& elasticities) {
    std::map<int, const Elasticity*> of_region;
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (!of_region.emplace(regions[i].id, &elasticities[i]).second)
            throw Error(fmt::format("region {} has two stiffnesses", regions[i].id));
    std::vector<const Elasticity*> materials;
    for (const int region : mesh.cell_regions) {
        const auto found = of_region.find(region);
        if (found == of_region.end()) throw Error(fmt::format("{}: region {} has no stiffness", mesh.file, region));
        materials.push_back(found->second);
    }
    for (const auto& [region, elasticity] : of_region)
        if (std::find(materials.begin(), materials.end(), elasticity) == materials.end())
            throw Error(fmt::format("{}: the mesh has no region {}", mesh.file, region));
    return materials;
}

std::vector<Elasticity> elasticities_of(const std::vector<Region>& regions) {
    std::vector<Elasticity> elasticities;
    for (const Region& region : regions) elasticities.emplace_back(region);
    return elasticities;
}

}  // namespace

ShapeTable::ShapeTable(const Discretization& space, int order) : rule(Discretization::quadrature(order)) {
    for (const Point& point : rule.points) {
        values.emplace_back(space.nodes_per_cell());
        gradients.emplace_back(space.nodes_per_cell());
        space.shape(point, values.back(), gradients.back());
    }
}

Solution::Data::Data(Mesh read, const Options& chosen, std::vector<Region> regions)
    : mesh(std::move(read)),
      options(chosen),
      elasticities(elasticities_of(regions)),
      materials(by_cell(mesh, regions, elasticities)),
      space(mesh, options.degree),
      locator(mesh, options.outside_tolerance) {}

Solution::Data::Local Solution::Data::evaluate(int cell, const std::vector<double>& values, const std::vector<Point>& unit_gradients,
                                               const Point& unit) const {
    const auto& vertices = mesh.cells[cell];
    const Point& origin = mesh.vertices[vertices[0]];
    const std::array<Point, 3> edges{mesh.vertices[vertices[1]] - origin, mesh.vertices[vertices[2]] - origin,
                                     mesh.vertices[vertices[3]] - origin};
    Local local;
    local.position = origin + unit[0] * edges[0] + unit[1] * edges[1] + unit[2] * edges[2];
    local.volume_factor = dot(edges[0], cross(edges[1], edges[2]));
    // Gradients of the barycentric coordinates 1 to 3: the rows of the inverse of the map x = origin + edges * unit.
    const std::array<Point, 3> inverse{1 / local.volume_factor * cross(edges[1], edges[2]),
                                       1 / local.volume_factor * cross(edges[2], edges[0]),
                                       1 / local.volume_factor * cross(edges[0], edges[1])};
    for (int node = 0; node < space.nodes_per_cell(); ++node) {
        const Point& g = unit_gradients[node];
        const Point gradient = g[0] * inverse[0] + g[1] * inverse[1] + g[2] * inverse[2];
        for (int i = 0; i < 3; ++i) {
            const double component = displacement[space.dof(cell, node, i)];
            local.displacement[i] += values[node] * component;
            for (int j = 0; j < 3; ++j) local.gradient[i][j] += component * gradient[j];
        }
        local.shape_gradients.push_back(gradient);
    }
    return local;
}

FieldSample Solution::Data::sample(int cell, const Local& local) const {
    return {.position = local.position,
            .weight = 0,
            .region = mesh.cell_regions[cell],
            .displacement = local.displacement,
            .gradient = local.gradient,
            .strain = engineering_strain(local.gradient),
            .stress = materials[cell]->stress(local.gradient),
            .cell = cell};
}

FieldSample Solution::Data::sample(const PointLocator::Place& place) const {
    std::vector<double> values(space.nodes_per_cell());
    std::vector<Point> gradients(space.nodes_per_cell());
    space.shape(place.unit, values, gradients);
    return sample(place.cell, evaluate(place.cell, values, gradients, place.unit));
}

PointLocator::Place Solution::Data::locate(const Point& point) const {
    if (const auto place = locator.find(point)) return *place;
    throw Error(fmt::format("{}: the point ({:g}, {:g}, {:g}) lies outside the body", mesh.file, point[0], point[1], point[2]));
}

Solution::Solution(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

const SolveRecord& Solution::record() const { return data_->record; }

std::vector<FieldSample> Solution::quadrature_samples(int order) const {
    const ShapeTable table(data_->space, order);
    std::vector<FieldSample> samples;
    samples.reserve(data_->mesh.cells.size() * table.rule.points.size());
    for (int cell = 0; cell < static_cast<int>(data_->mesh.cells.size()); ++cell)
        for (std::size_t q = 0; q < table.rule.points.size(); ++q) {
            const auto local = data_->evaluate(cell, table.values[q], table.gradients[q], table.rule.points[q]);
            samples.push_back(data_->sample(cell, local));
            samples.back().weight = local.volume_factor * table.rule.weights[q];
        }
    return samples;
}

FieldSample Solution::at(const Point& point) const { return data_->sample(data_->locate(point)); }

std::vector<FieldSample> Solution::at(const std::vector<Point>& points) const {
    std::vector<FieldSample> samples;
    for (const Point& point : points) samples.push_back(at(point));
    return samples;
}

std::vector<FieldSample> Solution::recovered_at(const std::vector<Point>& points) const {
    PatchRecovery recovery(*data_);
    std::vector<FieldSample> samples;
    for (const Point& point : points) samples.push_back(recovery.sample(data_->locate(point)));
    return samples;
}

std::vector<Point> Solution::vertices() const { return data_->mesh.vertices; }

std::vector<Point> Solution::vertex_displacements() const {
    std::vector<Point> displacements(data_->mesh.vertices.size());
    for (int cell = 0; cell < static_cast<int>(data_->mesh.cells.size()); ++cell)
        for (int vertex = 0; vertex < 4; ++vertex)
            for (int i = 0; i < 3; ++i)
                displacements[data_->mesh.cells[cell][vertex]][i] = data_->displacement[data_->space.dof(cell, vertex, i)];
    return displacements;
}

double Solution::energy() const { return data_->energy; }

double Solution::external_work() const { return data_->external_work; }

}  // namespace cleave::fem
