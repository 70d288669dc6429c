#include "reference_fem/point_locator.hpp"

#include "reference_fem/vector3.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::fem {
namespace {

/// A point seen from a tet.
struct Local {
    std::array<double, 4> barycentric;
    double slack;     ///< largest of -barycentric: positive outside
    double distance;  ///< how far beyond the farthest face plane, in diameters of the tet; negative inside
};

/// Barycentric coordinates by volume ratios: lambda_i = V(point in place of vertex i) / V.
Local see_from(const Mesh& mesh, int cell, const Point& point) {
    const auto& vertices = mesh.cells[cell];
    const Point& origin = mesh.vertices[vertices[0]];
    const Point a = mesh.vertices[vertices[1]] - origin, b = mesh.vertices[vertices[2]] - origin, c = mesh.vertices[vertices[3]] - origin;
    const Point p = point - origin;
    const double determinant = dot(cross(a, b), c);
    const std::array<Point, 3> normals{cross(b, c), cross(c, a), cross(a, b)};  // of the faces opposite vertices 1, 2, 3; length 2 area
    Local local{};
    local.barycentric[0] = 1;
    for (int i = 0; i < 3; ++i) {
        local.barycentric[i + 1] = dot(normals[i], p) / determinant;
        local.barycentric[0] -= local.barycentric[i + 1];
    }
    const Point slanted = cross(b - a, c - a);
    const double size = diameter(mesh, cell);
    local.slack = -*std::min_element(local.barycentric.begin(), local.barycentric.end());
    local.distance = -INFINITY;
    for (int i = 0; i < 4; ++i) {
        const double height = determinant / norm(i == 0 ? slanted : normals[i - 1]);
        local.distance = std::max(local.distance, -local.barycentric[i] * height / size);
    }
    return local;
}

constexpr double inside_slack = 1e-9;

}  // namespace

template <class Visit>
void PointLocator::visit_bins(int cell, const Visit& visit) const {
    // A hair more than asked, so that a point exactly on the limit cannot be lost to rounding.
    const double margin = (outside_tolerance_ + 1e-6) * diameter(mesh_, cell);
    Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    for (const int vertex : mesh_.cells[cell])
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], mesh_.vertices[vertex][i] - margin);
            high[i] = std::max(high[i], mesh_.vertices[vertex][i] + margin);
        }
    const auto first = bin_of(low), last = bin_of(high);
    for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i) visit(bin_index(i, j, k));
}

PointLocator::PointLocator(const Mesh& mesh, double outside_tolerance) : mesh_(mesh), outside_tolerance_(outside_tolerance) {
    const int cells = static_cast<int>(mesh.cells.size());
    double largest = 0;
    for (int cell = 0; cell < cells; ++cell) largest = std::max(largest, diameter(mesh, cell));
    const double margin = (outside_tolerance + 1e-6) * largest;
    low_ = high_ = mesh.vertices.front();
    for (const Point& vertex : mesh.vertices)
        for (int i = 0; i < 3; ++i) {
            low_[i] = std::min(low_[i], vertex[i] - margin);
            high_[i] = std::max(high_[i], vertex[i] + margin);
        }
    // About two bins per tet, as near to cubes as whole numbers allow.
    const Point extent = high_ - low_;
    const double edge = std::cbrt(extent[0] * extent[1] * extent[2] / (2.0 * cells));
    for (int i = 0; i < 3; ++i) counts_[i] = std::clamp(static_cast<int>(extent[i] / edge), 1, 1000);

    bin_start_.assign(bin_index(0, 0, counts_[2]) + 1, 0);
    for (int cell = 0; cell < cells; ++cell) visit_bins(cell, [&](std::size_t bin) { ++bin_start_[bin + 1]; });
    for (std::size_t bin = 1; bin < bin_start_.size(); ++bin) bin_start_[bin] += bin_start_[bin - 1];
    bin_cells_.resize(bin_start_.back());
    std::vector<int> next(bin_start_.begin(), bin_start_.end() - 1);
    for (int cell = 0; cell < cells; ++cell) visit_bins(cell, [&](std::size_t bin) { bin_cells_[next[bin]++] = cell; });
}

std::array<int, 3> PointLocator::bin_of(const Point& point) const {
    std::array<int, 3> bin{};
    for (int i = 0; i < 3; ++i)
        bin[i] = std::clamp(static_cast<int>(counts_[i] * (point[i] - low_[i]) / (high_[i] - low_[i])), 0, counts_[i] - 1);
    return bin;
}

std::optional<PointLocator::Place> PointLocator::find(const Point& point) const {
    for (int i = 0; i < 3; ++i)
        if (!(point[i] >= low_[i] && point[i] <= high_[i])) return std::nullopt;
    const auto [i, j, k] = bin_of(point);
    const std::size_t bin = bin_index(i, j, k);
    std::optional<Place> nearest;
    double best = outside_tolerance_;
    for (int entry = bin_start_[bin]; entry < bin_start_[bin + 1]; ++entry) {  // cells ascend within a bin
        const int cell = bin_cells_[entry];
        const Local local = see_from(mesh_, cell, point);
        const Place place{cell, {local.barycentric[1], local.barycentric[2], local.barycentric[3]}};
        if (local.slack <= inside_slack) return place;
        if (local.distance <= best && (!nearest || local.distance < best)) best = local.distance, nearest = place;
    }
    return nearest;
}

}  // namespace cleave::fem
