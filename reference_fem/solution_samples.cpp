#include "reference_fem/solution_data.hpp"
#include "reference_fem/vector3.hpp"

#include <set>

namespace cleave::fem {
namespace {

/// A point of a triangle, barycentric coordinates, and its share of the area.
struct TrianglePoint {
    std::array<double, 3> barycentric{};
    double weight = 0;
};

/// The triangle in three, each over one edge and up to the centroid; along the edge Gauss and Legendre's four points, across it six in
/// t, the distance from the edge going with t^2: the inverse square root of that distance, which fields at a crack front have, becomes
/// a polynomial.
std::vector<TrianglePoint> triangle_rule() {
    constexpr std::array<double, 4> along{0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263};
    constexpr std::array<double, 4> along_weight{0.17392742256872692, 0.32607257743127307, 0.32607257743127307, 0.17392742256872692};
    constexpr std::array<double, 6> across{0.03376524289842399, 0.16939530676686774, 0.3806904069584015,
                                           0.6193095930415985,  0.8306046932331322,  0.966234757101576};
    constexpr std::array<double, 6> across_weight{0.08566224618958517, 0.1803807865240693, 0.2339569672863455,
                                                  0.2339569672863455,  0.1803807865240693, 0.08566224618958517};
    std::vector<TrianglePoint> rule;
    for (int edge = 0; edge < 3; ++edge)
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 6; ++j) {
                const double height = across[j] * across[j];
                TrianglePoint point{{height / 3, height / 3, height / 3}, 2.0 / 3 * (1 - height) * 2 * across[j] * along_weight[i] * across_weight[j]};
                point.barycentric[edge] += (1 - height) * (1 - along[i]);
                point.barycentric[(edge + 1) % 3] += (1 - height) * along[i];
                rule.push_back(point);
            }
    return rule;
}

/// The face's vertices by their number in the cell, so that cross(b - a, c - a) points out of the cell.
std::array<int, 3> outward_face(int opposite) {
    constexpr std::array<std::array<int, 3>, 4> faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    return faces[opposite];
}

}  // namespace

std::vector<FieldSample> Solution::cell_samples(const std::vector<int>& cells, int order) const {
    const ShapeTable table(data_->space, order);
    std::vector<FieldSample> samples;
    samples.reserve(cells.size() * table.rule.points.size());
    for (const int cell : cells)
        for (std::size_t q = 0; q < table.rule.points.size(); ++q) {
            const auto local = data_->evaluate(cell, table.values[q], table.gradients[q], table.rule.points[q]);
            samples.push_back(data_->sample(cell, local));
            samples.back().weight = local.volume_factor * table.rule.weights[q];
        }
    return samples;
}

std::vector<SurfaceSample> Solution::surface_samples(int surface, const std::function<bool(int)>& wanted) const {
    const std::vector<TrianglePoint> rule = triangle_rule();
    std::vector<SurfaceSample> samples;
    for (const BoundaryFace& face : FaceTable(data_->mesh).surface(surface)) {
        if (wanted && !wanted(face.cell)) continue;
        const std::array<int, 3> corners = outward_face(face.opposite);
        const auto at = [&](int k) { return data_->mesh.vertices[data_->mesh.cells[face.cell][corners[k]]]; };
        const Point area = 0.5 * cross(at(1) - at(0), at(2) - at(0));
        for (const TrianglePoint& point : rule) {
            Point unit{};
            for (int k = 0; k < 3; ++k)
                if (corners[k] > 0) unit[corners[k] - 1] = point.barycentric[k];
            SurfaceSample sample{data_->sample(PointLocator::Place{face.cell, unit}), 1 / norm(area) * area};
            sample.weight = point.weight * norm(area);
            samples.push_back(sample);
        }
    }
    return samples;
}

std::vector<int> Solution::surfaces() const {
    std::set<int> tags;
    for (const SurfaceTriangle& triangle : data_->mesh.triangles) tags.insert(triangle.surface);
    return {tags.begin(), tags.end()};
}

const Elasticity& Solution::material(int cell) const { return *data_->materials[cell]; }

std::vector<std::array<int, 4>> Solution::cells() const { return data_->mesh.cells; }

}  // namespace cleave::fem
