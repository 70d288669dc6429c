#include "solver/particles/wpca.hpp"

#include "solver/particles/smoothing_tensor.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace cleave::particles {

namespace {

double window_weight(double volume, double distance, double window) {
    const double q = distance / window;
    return volume * (1 - q * q * q);
}

bool is_noise(const Eigen::Vector3d& variances, const WpcaOptions& options) {
    return !(variances(0) >= options.noise * variances(2)) || variances(0) <= 0;
}

/// |A (x_j - x_i)| of all others, ascending, as far as the `count` smallest need: for a tensor A of any size.
std::vector<double> nearest_distances(const Particles& particles, const CellGrid& grid, int i, const Eigen::Matrix3d& shape, int count) {
    const int available = std::min(count, particles.size() - 1);
    for (double reach = particles.support_radius[i];; reach *= 1.5) {
        const std::vector<int> ids = neighbours_of_point(particles, grid, particles.position[i], shape / reach);
        if (static_cast<int>(ids.size()) <= available && static_cast<int>(ids.size()) < particles.size()) continue;
        std::vector<double> distances;
        for (const int j : ids)
            if (j != i) distances.push_back((shape * (particles.position[j] - particles.position[i])).norm());
        std::sort(distances.begin(), distances.end());
        return distances;
    }
}

/// Support radius (m) that holds just `count` others: half-way between the count-th and the next.
double radius_for_count(const Particles& particles, const CellGrid& grid, int i, const Eigen::Matrix3d& shape, int count) {
    const std::vector<double> distances = nearest_distances(particles, grid, i, shape, count + 1);
    if (distances.empty()) return particles.support_radius[i];
    if (static_cast<int>(distances.size()) <= count) return 1.01 * distances.back();
    return 0.5 * (distances[count - 1] + distances[count]);
}

}  // namespace

LocalShape local_shape(const Particles& particles, const CellGrid& grid, int i, double window) {
    const double radius = window * particles.spacing[i];
    const std::vector<int> ids = neighbours_of_point(particles, grid, particles.position[i], isotropic_tensor(radius));
    // About particle i, not about the origin: bodies far from it would lose digits.
    double total = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const int j : ids) {
        const Eigen::Vector3d r = particles.position[j] - particles.position[i];
        const double weight = window_weight(particles.volume[j], r.norm(), radius);
        total += weight;
        mean += weight * r;
        second += weight * r * r.transpose();
    }
    mean /= total;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / total - mean * mean.transpose());
    return {solver.eigenvectors().rowwise().reverse(), solver.eigenvalues().reverse().cwiseMax(0)};
}

Eigen::Vector3d relative_axes(const Eigen::Vector3d& variances, const WpcaOptions& options) {
    if (is_noise(variances, options)) return Eigen::Vector3d::Ones();
    const double least = variances(0) / (options.largest_aspect * options.largest_aspect);
    const Eigen::Vector3d extents = variances.cwiseMax(least).cwiseSqrt();
    return extents / std::cbrt(extents.prod());
}

WpcaReport apply_wpca(Particles& particles, const WpcaOptions& options) {
    const CellGrid grid(particles.position, suitable_cell(particles));
    WpcaReport report;
    for (int i = 0; i < particles.size(); ++i) {
        const LocalShape shape = local_shape(particles, grid, i, options.window);
        const bool noise = is_noise(shape.variances, options);
        report.isotropic += noise;
        report.clamped += !noise && shape.variances(0) > options.largest_aspect * options.largest_aspect * shape.variances(2);
        // The axes of noise are noise too; the user's scale then still follows them, as the least bad normal there is.
        const Eigen::Vector3d axes = relative_axes(shape.variances, options).cwiseProduct(options.scale);
        const Eigen::Matrix3d unit = tensor_from_axes(shape.axes, axes);
        const double h = options.target_neighbours > 0 ? radius_for_count(particles, grid, i, unit, options.target_neighbours)
                                                       : particles.support_radius[i];
        particles.tensor[i] = unit / h;
        particles.support_radius[i] = h * std::cbrt(options.scale.prod());
    }
    return report;
}

}  // namespace cleave::particles
