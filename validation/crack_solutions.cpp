#include "validation/crack_solutions.hpp"

#include "validation/adapters/crack_station.hpp"
#include "validation/analytic/barnett_lothe.hpp"
#include "validation/analytic/finite_width.hpp"
#include "validation/analytic/kink.hpp"
#include "validation/analytic/lekhnitskii_crack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::validation {

namespace {

using analytic::CrackAxes;
using analytic::Field;
using analytic::Point;

double quantity(const SolutionCall& call, const std::string& key) {
    const auto found = call.numbers.find(key);
    if (found == call.numbers.end()) throw std::invalid_argument("the key '" + key + "' in [solution." + call.name + "]");
    return found->second;
}

Point vector_or_zero(const SolutionCall& call, const std::string& key) {
    const auto found = call.vectors.find(key);
    return found == call.vectors.end() ? Point{} : found->second;
}

/// Stress intensities at the station nearest to a point.
using FrontIntensities = std::function<Point(const CrackStation&)>;

/// Quantities of the front of a field, from its stress intensities.
void set_front(Field& field, const Case& of, const analytic::Stiffness& stiffness, const FrontIntensities& intensities) {
    field.at_front = [shape = of.shape, stiffness, intensities](const std::string& quantity, const std::string& component, const Point& place) {
        const CrackStation station = station_near(*shape, place);
        const Point k = intensities(station);
        if (quantity == "stress_intensity") return k[component == "II" ? 0 : component == "I" ? 1 : 2];
        if (quantity == "energy_release_rate_at" || quantity == "energy_release_rate_from_k")
            return analytic::energy_release(stiffness, station.place.axes, k);
        if (quantity == "energy_release_gap") return 0.0;
        if (component == "hoop") return analytic::hoop_kink_angle(k[1], k[0]);
        if (component == "energy") return analytic::energy_kink_angle(k[1], k[0]);
        throw std::invalid_argument("a reference value for this direction");
    };
}

Field straight_crack(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness) {
    const double a = of.shape->length("crack_half_length");
    const CrackStation station = station_near(*of.shape, {a, 0, 0});
    const CrackAxes axes = station.place.axes;
    const Point in_plane = vector_or_zero(call, "remote"), out_of_plane = vector_or_zero(call, "antiplane");
    const analytic::Matrix remote{Point{in_plane[0], in_plane[2], out_of_plane[0]}, Point{in_plane[2], in_plane[1], out_of_plane[1]},
                                  Point{out_of_plane[0], out_of_plane[1], 0}};
    const auto on = [&](std::size_t i, std::size_t j) { return analytic::product(axes[i], analytic::times(remote, axes[j])); };
    const Point traction{on(0, 1), on(1, 1), on(2, 1)};
    Field field = analytic::straight_crack(stiffness, axes, a, traction, {on(0, 0), on(2, 0)});
    set_front(field, of, stiffness, [traction, a, axes](const CrackStation& at) {
        const double sign = analytic::product(at.place.axes[0], axes[0]) > 0 ? 1 : -1, factor = std::sqrt(std::numbers::pi * a);
        return Point{sign * factor * traction[0], factor * traction[1], sign * factor * traction[2]};
    });
    return field;
}

/// A crack whose opening intensity is known: `at` gives K_I over the tension.
Field opened(const Case& of, const analytic::Stiffness& stiffness, double tension, const std::function<double(const CrackStation&)>& at,
             const std::string& source) {
    Field field;
    set_front(field, of, stiffness, [tension, at](const CrackStation& station) { return Point{0, tension * at(station), 0}; });
    field.source = source;
    return field;
}

Field finite_plate(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness) {
    const bool centre = call.name == "centre_crack_plate";
    // A half of the plate with a centre crack is a plate with an edge crack whose side x = 0 is a plane of symmetry.
    const double a = of.shape->length("crack_length"), width = of.shape->length("width");
    const double factor = std::sqrt(std::numbers::pi * a) * (centre ? analytic::centre_crack_factor(a / width) : analytic::edge_crack_factor(a / width));
    return opened(of, stiffness, quantity(call, "tension"), [factor](const CrackStation&) { return factor; },
                  centre ? "Tada, centre crack in a plate of finite width" : "Tada, edge crack in a plate of finite width");
}

Field elliptical(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness) {
    const double a = of.shape->length("half_axis_x"), b = of.shape->length("half_axis_y"), factor = std::sqrt(std::numbers::pi * b);
    const auto at = [=](const CrackStation& station) {
        const double y = station.place.position[1];  // the shorter axis, which the crack's angle leaves
        return factor * analytic::elliptical_crack_factor(a, b, std::asin(std::clamp(y / b, -1.0, 1.0)));
    };
    return opened(of, stiffness, quantity(call, "pressure"), at, "Irwin 1962, elliptical crack");
}

Field penny(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness) {
    const double a = of.shape->length("crack_radius"), pressure = quantity(call, "pressure");
    const Point normal = station_near(*of.shape, {}).place.axes[1];
    const auto any = std::make_shared<const analytic::AnisotropicPenny>(stiffness, normal, a, Point{pressure * normal[0], pressure * normal[1], pressure * normal[2]});
    Field field;
    set_front(field, of, stiffness, [any](const CrackStation& station) { return any->intensities(station.place.axes); });
    field.scalars["energy_release_rate"] = field.scalars["energy_release_rate_domain"] = any->mean_energy_release();
    field.source = "Willis 1968, penny crack in any material (Barnett-Lothe tensor, mean over directions)";
    return field;
}

}  // namespace

const std::vector<SolutionInfo>& crack_solutions() {
    using Kind = SolutionInfo::Key::Kind;
    static const std::vector<SolutionInfo> list{
        {"straight_crack",
         "crack in an infinite plane, any material, remote stress (xx, yy, xy) and antiplane (xz, yz, 0) (through_crack_block)",
         {{"remote", Kind::vector, {}, dimension::pressure}, {"antiplane", Kind::vector, {}, dimension::pressure}}},
        {"centre_crack_plate", "half of a plate with a centre crack under tension (edge_crack_block, left side held in x; Tada)", {{"tension", Kind::quantity, {}, dimension::pressure}}},
        {"edge_crack_plate", "plate with an edge crack under tension, ends free to turn (edge_crack_block; Tada)", {{"tension", Kind::quantity, {}, dimension::pressure}}},
        {"elliptical_crack", "elliptical crack under pressure in infinite isotropic space (Irwin 1962)", {{"pressure", Kind::quantity, {}, dimension::pressure}}},
        {"anisotropic_penny", "penny crack under pressure in infinite space of any material (Willis 1968)", {{"pressure", Kind::quantity, {}, dimension::pressure}}}};
    return list;
}

bool is_crack_solution(const std::string& name) {
    for (const SolutionInfo& info : crack_solutions())
        if (info.name == name) return true;
    return false;
}

analytic::Field make_crack_field(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness) {
    if (call.name == "straight_crack") return straight_crack(call, of, stiffness);
    if (call.name == "elliptical_crack") return elliptical(call, of, stiffness);
    if (call.name == "anisotropic_penny") return penny(call, of, stiffness);
    return finite_plate(call, of, stiffness);
}

}  // namespace cleave::validation
