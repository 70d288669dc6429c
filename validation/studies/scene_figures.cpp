#include "validation/studies/scene_figures.hpp"

#include "solver/simulation/statistics.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace cleave::validation {

namespace {

using Eigen::Vector3d;
using simulation::Simulation;
using Figures = std::map<std::string, double>;

/// A crack as it was stated, rest coordinates.
struct CrackPlane {
    Vector3d point, normal;
};

std::vector<CrackPlane> planes_of(const Simulation& run, int body) {
    std::vector<CrackPlane> planes;
    for (const simulation::ImpactRecord& impact : run.state().impacts)
        if (impact.body == body)
            for (const Vector3d& normal : impact.normals) planes.push_back({impact.point, normal});
    return planes;
}

double nearest(const std::vector<CrackPlane>& planes, const Vector3d& place) {
    double distance = std::numeric_limits<double>::infinity();
    for (const CrackPlane& plane : planes) distance = std::min(distance, std::abs(plane.normal.dot(place - plane.point)));
    return distance;
}

Vector3d point_of(const simulation::Shape& shape, std::uint32_t i) { return {shape.points[i][0], shape.points[i][1], shape.points[i][2]}; }

double crack_deviation(const Simulation& run) {
    double sum = 0, total = 0;
    for (const simulation::Piece& piece : run.pieces()) {
        const std::vector<CrackPlane> planes = planes_of(run, piece.body);
        if (planes.empty() || piece.track < 0) continue;
        const simulation::Shape& shape = run.state().tracks[static_cast<std::size_t>(piece.track)].shape;
        for (const auto& [a, b, c] : shape.crack) {
            const Vector3d x = point_of(shape, a), y = point_of(shape, b), z = point_of(shape, c);
            const double area = 0.5 * (y - x).cross(z - x).norm(), distance = nearest(planes, (x + y + z) / 3);
            sum += area * distance * distance;
            total += area;
        }
    }
    return total > 0 ? std::sqrt(sum / total) : 0;
}

void add_first_impact(const Simulation& run, Figures& figures) {
    figures["surface_angle"] = figures["hole_radius"] = 0;
    for (const simulation::ImpactRecord& impact : run.state().impacts) {
        if (impact.normals.empty()) continue;
        const double count = static_cast<double>(impact.normals.size());
        for (const Vector3d& normal : impact.normals)
            figures["surface_angle"] += std::acos(std::min(1.0, std::abs(normal.dot(impact.inward)))) / count;
        for (const double radius : impact.inner_radii) figures["hole_radius"] += radius / count;
        return;
    }
}

/// Shares of a body's mass, largest first.
std::vector<double> shares_of(const Simulation& run, int body) {
    std::vector<double> shares;
    double total = 0;
    for (const simulation::Piece& piece : run.pieces())
        if (piece.body == body) total += shares.emplace_back(piece.mass.mass);
    for (double& share : shares) share /= total;
    std::sort(shares.begin(), shares.end(), std::greater<>());
    return shares;
}

/// 0: alike; 1: nothing in common.
double difference(std::vector<double> a, std::vector<double> b) {
    a.resize(std::max(a.size(), b.size()));
    b.resize(a.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += 0.5 * std::abs(a[i] - b[i]);
    return sum;
}

void add_bodies(const Simulation& run, Figures& figures) {
    std::vector<std::vector<double>> shares;
    for (int body = 0; body < static_cast<int>(run.bodies().size()); ++body)
        if (!run.bodies()[static_cast<std::size_t>(body)]->is_ball()) shares.push_back(shares_of(run, body));
    figures["bodies_broken"] = static_cast<double>(std::count_if(shares.begin(), shares.end(), [](const auto& list) { return list.size() > 1; }));
    double least = 1;
    for (std::size_t i = 0; i < shares.size(); ++i)
        for (std::size_t j = i + 1; j < shares.size(); ++j) least = std::min(least, difference(shares[i], shares[j]));
    figures["least_difference"] = least;
}

}  // namespace

std::vector<QuantityInfo> scene_quantities() {
    std::vector<QuantityInfo> list;
    for (const char* name : {"physical", "subdivided", "fragments", "lost_share", "rim_pieces", "bodies_broken", "least_difference", "mass_error",
                             "momentum_error", "angular_momentum_error", "energy_growth", "free_steps"})
        list.push_back({name, dimension::none});
    for (const char* name : {"crack_deviation", "penetration", "hole_radius"}) list.push_back({name, dimension::length});
    list.push_back({"surface_angle", dimension::none, true});
    return list;
}

Figures scene_figures(const Simulation& run) {
    const simulation::Counts counts = simulation::count(run);
    const simulation::Watch& watch = run.state().watch;
    const auto held = [](const simulation::Piece& piece) { return piece.held; };
    Figures figures{{"physical", counts.physical},
                    {"subdivided", counts.subdivided},
                    {"fragments", counts.fragments},
                    {"lost_share", 1 - counts.largest_share},
                    {"rim_pieces", static_cast<double>(std::count_if(run.pieces().begin(), run.pieces().end(), held))},
                    {"crack_deviation", crack_deviation(run)},
                    {"mass_error", watch.mass_error},
                    {"momentum_error", watch.momentum_error},
                    {"angular_momentum_error", watch.angular_momentum_error},
                    {"energy_growth", watch.energy_scale > 0 ? watch.energy_growth / watch.energy_scale : 0},
                    {"free_steps", static_cast<double>(watch.free_steps)},
                    {"penetration", watch.penetration}};
    add_first_impact(run, figures);
    add_bodies(run, figures);
    return figures;
}

}  // namespace cleave::validation
