#include "reference_fem/recovery.hpp"

#include "reference_fem/vector3.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace cleave::fem {
namespace {

/// Quadratic strain elements have linear strain, which these four points of equal weight represent fully; constant strain needs one.
/// Coordinates of the 4-point rule of degree 2, (5 -+ sqrt 5) / 20 (Hammer and Stroud 1956).
std::vector<Point> sampling_points(int degree) {
    if (degree == 1) return {{0.25, 0.25, 0.25}};
    const double near = (5 - std::sqrt(5.0)) / 20, far = 1 - 3 * near;
    return {{near, near, near}, {far, near, near}, {near, far, near}, {near, near, far}};
}

/// Fewest cells of a patch: four samples for each coefficient of the fit. With fewer, fits at the boundary extrapolate badly.
std::size_t least_cells(int degree) { return degree == 1 ? 16 : 10; }

Eigen::VectorXd monomials(const Point& p, int degree) {
    Eigen::VectorXd terms(degree == 1 ? 4 : 10);
    terms.head<4>() << 1, p[0], p[1], p[2];
    if (degree == 2) terms.tail<6>() << p[0] * p[0], p[1] * p[1], p[2] * p[2], p[1] * p[2], p[0] * p[2], p[0] * p[1];
    return terms;
}

}  // namespace

PatchRecovery::PatchRecovery(const Solution::Data& data) : data_(data), first_(data.mesh.vertices.size() + 1, 0) {
    for (const auto& cell : data.mesh.cells)
        for (const int vertex : cell) ++first_[vertex + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    cells_of_vertex_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (int cell = 0; cell < static_cast<int>(data.mesh.cells.size()); ++cell)
        for (const int vertex : data.mesh.cells[cell]) cells_of_vertex_[next[vertex]++] = cell;
}

FieldSample PatchRecovery::sample(const PointLocator::Place& place) {
    FieldSample sample = data_.sample(place);
    sample.strain = {};
    const std::array<double, 4> barycentric{1 - place.unit[0] - place.unit[1] - place.unit[2], place.unit[0], place.unit[1], place.unit[2]};
    for (int i = 0; i < 4; ++i) {
        const Fit& around = fit(data_.mesh.cells[place.cell][i], sample.region);
        const Point local = 1 / around.size * (sample.position - around.centre);
        const Eigen::Matrix<double, 6, 1> strain = around.coefficients.transpose() * monomials(local, data_.options.degree);
        for (int j = 0; j < 6; ++j) sample.strain[j] += barycentric[i] * strain[j];
    }
    sample.stress = data_.materials[place.cell]->stress(sample.strain);
    return sample;
}

const PatchRecovery::Fit& PatchRecovery::fit(int vertex, int region) {
    const auto found = fits_.find({vertex, region});
    if (found != fits_.end()) return found->second;
    return fits_.emplace(std::pair{vertex, region}, make_fit(vertex, region)).first->second;
}

/// Cells of the region around the vertex; ring after ring is added while there are too few.
std::vector<int> PatchRecovery::patch(int vertex, int region) const {
    std::vector<int> vertices{vertex}, cells;
    while (true) {
        std::vector<int> grown;
        for (const int v : vertices)
            for (int entry = first_[v]; entry < first_[v + 1]; ++entry)
                if (data_.mesh.cell_regions[cells_of_vertex_[entry]] == region) grown.push_back(cells_of_vertex_[entry]);
        std::sort(grown.begin(), grown.end());
        grown.erase(std::unique(grown.begin(), grown.end()), grown.end());
        if (grown.size() >= least_cells(data_.options.degree) || grown.size() == cells.size()) return grown;
        cells = std::move(grown);
        vertices.clear();
        for (const int cell : cells) vertices.insert(vertices.end(), data_.mesh.cells[cell].begin(), data_.mesh.cells[cell].end());
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
}

PatchRecovery::Fit PatchRecovery::make_fit(int vertex, int region) const {
    const int degree = data_.options.degree;
    const std::vector<int> cells = patch(vertex, region);
    const std::vector<Point> points = sampling_points(degree);
    std::vector<FieldSample> samples;
    for (const int cell : cells)
        for (const Point& point : points) samples.push_back(data_.sample({cell, point}));
    Fit fit{.centre = data_.mesh.vertices[vertex], .size = 0, .coefficients = {}};
    for (const FieldSample& sample : samples) fit.size = std::max(fit.size, norm(sample.position - fit.centre));

    const auto rows = static_cast<Eigen::Index>(samples.size());
    Eigen::MatrixXd terms(rows, degree == 1 ? 4 : 10);
    Eigen::Matrix<double, Eigen::Dynamic, 6> strains(rows, 6);
    for (Eigen::Index row = 0; row < rows; ++row) {
        terms.row(row) = monomials(1 / fit.size * (samples[row].position - fit.centre), degree);
        strains.row(row) = Eigen::Map<const Eigen::Matrix<double, 1, 6>>(samples[row].strain.data());
    }
    // Minimum norm where a small region has too few cells for all terms.
    fit.coefficients = terms.completeOrthogonalDecomposition().solve(strains);
    return fit;
}

}  // namespace cleave::fem
