#include "solver/fracture/toughness.hpp"

#include "solver/input/read_values.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::fracture {

namespace {

constexpr double right_angle = std::numbers::pi / 2;

/// Linear between the points of an ascending table that spans the argument.
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
    const auto next = std::clamp<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin(), 1, x.size() - 1);
    const double part = (at - x[next - 1]) / (x[next] - x[next - 1]);
    return y[next - 1] + part * (y[next] - y[next - 1]);
}

bool spans_quarter_turn(const std::vector<double>& angle) {
    return angle.size() > 1 && std::abs(angle.front()) < 1e-9 && std::abs(angle.back() - right_angle) < 1e-9 &&
           std::adjacent_find(angle.begin(), angle.end(), std::greater_equal<>()) == angle.end();
}

double read_positive(TableReader& table, const std::string& key, Dimension unit, double known) {
    const double value = !table.has(key) ? known : unit == dimension::none ? table.number(key) : table.quantity(key, unit);
    if (!(value > 0)) table.fail(key, "a value above zero");
    return value;
}

std::vector<double> read_angles(TableReader& table, const std::string& key) {
    std::vector<double> angles;
    for (const std::string& text : table.strings(key)) {
        const Quantity quantity = [&] {
            try {
                return parse_quantity(text);
            } catch (const std::invalid_argument& error) {
                table.fail(key, error.what());
            }
        }();
        if (!quantity.angle) table.fail(key, "angles such as \"45 deg\"");
        angles.push_back(quantity.value);
    }
    return angles;
}

/// The keys of weak_plane or fibre, `make` the maker of the form.
Toughness read_directional(TableReader table, const std::string& axis, double energy,
                           Toughness (*make)(double, const Eigen::Vector3d&, double)) {
    const auto [x, y, z] = read_direction(table, axis);
    const Eigen::Vector3d direction(x, y, z);
    if (!table.has("angle")) {
        const Toughness toughness = make(energy, direction, read_positive(table, "ratio", dimension::none, 0));
        table.finish();
        return toughness;
    }
    const std::vector<double> angle = read_angles(table, "angle"), ratio = table.numbers("ratio");
    table.finish();
    try {
        return make(energy, direction, 1).with_table(angle, ratio);
    } catch (const std::invalid_argument& error) {
        table.fail("angle", error.what());
    }
}

}  // namespace

Toughness Toughness::uniform(double energy) {
    Toughness toughness;
    toughness.energy_ = energy;
    return toughness;
}

Toughness Toughness::weak_plane(double energy, const Eigen::Vector3d& weak_normal, double ratio) {
    Toughness toughness = uniform(energy);
    toughness.kind_ = Axis::weak_normal;
    toughness.axis_ = weak_normal.normalized();
    toughness.ratio_ = ratio;
    return toughness;
}

Toughness Toughness::fibre(double energy, const Eigen::Vector3d& fibre, double ratio) {
    Toughness toughness = weak_plane(energy, fibre, ratio);
    toughness.kind_ = Axis::fibre;
    return toughness;
}

Toughness Toughness::with_table(std::vector<double> angle, std::vector<double> ratio) const {
    if (!spans_quarter_turn(angle) || ratio.size() != angle.size())
        throw std::invalid_argument("angles that ascend from 0 deg to 90 deg, and one ratio for each");
    if (!(*std::min_element(ratio.begin(), ratio.end()) > 0)) throw std::invalid_argument("ratios above zero");
    Toughness toughness = *this;
    toughness.table_angle_ = std::move(angle);
    toughness.table_ratio_ = std::move(ratio);
    return toughness;
}

/// sin^2 of the angle between the crack plane and the weak plane, or the fibre.
double Toughness::squared_sine(const Eigen::Vector3d& crack_normal) const {
    const double along = crack_normal.dot(axis_), across = crack_normal.cross(axis_).squaredNorm();
    return kind_ == Axis::weak_normal ? across : along * along;
}

double Toughness::intensity_ratio(const Eigen::Vector3d& crack_normal) const {
    if (kind_ == Axis::none) return 1;
    const double sine2 = std::min(squared_sine(crack_normal), 1.0);
    if (!table_angle_.empty()) return interpolate(table_angle_, table_ratio_, std::asin(std::sqrt(sine2)));
    return 1 - sine2 + ratio_ * sine2;
}

double Toughness::energy(const Eigen::Vector3d& crack_normal) const {
    const double ratio = intensity_ratio(crack_normal);
    return energy_ * ratio * ratio;
}

Brittleness uniform_brittleness(double strength, double toughness, const material::Stiffness& stiffness) {
    return {strength, strength / material::hill_youngs_modulus(stiffness), Toughness::uniform(toughness)};
}

Brittleness read_brittleness(TableReader& table, double strength, double toughness, const material::Stiffness& stiffness) {
    const double known_strength = read_positive(table, "strength", dimension::pressure, strength);
    const double energy = read_positive(table, "toughness", dimension::energy_per_area, toughness);
    Brittleness result = uniform_brittleness(known_strength, energy, stiffness);
    if (table.has("strain_limit")) result.strain_limit = read_positive(table, "strain_limit", dimension::none, 0);
    if (table.has("weak_plane") && table.has("fibre")) table.fail("fibre", "weak_plane or fibre, not both");
    if (auto plane = table.table_if("weak_plane")) result.toughness = read_directional(*plane, "normal", energy, Toughness::weak_plane);
    if (auto fibre = table.table_if("fibre")) result.toughness = read_directional(*fibre, "direction", energy, Toughness::fibre);
    return result;
}

}  // namespace cleave::fracture
