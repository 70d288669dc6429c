#include "solver/mesh/recipes/pot.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace cleave::mesh {
namespace {

namespace occ = gmsh::model::occ;

/// A point of the profile in the half plane r >= 0.
struct ProfilePoint {
    double r, z;
};

/// The outer profile from foot to rim.
std::array<ProfilePoint, 5> outer_profile(const PotShape& s) {
    return {{{s.foot_radius, 0},
             {0.88 * s.belly_radius, 0.22 * s.height},
             {s.belly_radius, 0.48 * s.height},
             {s.neck_radius, 0.86 * s.height},
             {s.rim_radius, s.height}}};
}

/// The inner profile: each outer point moved inwards by the wall, the lowest one also up by it, the rim level.
std::array<ProfilePoint, 5> inner_profile(const PotShape& s) {
    std::array<ProfilePoint, 5> points = outer_profile(s);
    for (ProfilePoint& point : points) point.r -= s.wall;
    points[0].z += s.wall;
    return points;
}

template <std::size_t count>
std::vector<int> add_points(const std::array<ProfilePoint, count>& profile) {
    std::vector<int> points;
    for (const ProfilePoint& point : profile) points.push_back(occ::addPoint(point.r, 0, point.z));
    return points;
}

std::vector<Region> build(const PotShape& shape) {
    const int profile = add_pot_profile(shape);
    gmsh::vectorpair swept;
    occ::revolve({{2, profile}}, 0, 0, 0, 0, 0, 1, 2 * std::numbers::pi, swept);
    occ::remove({{2, profile}});
    const auto volume = std::find_if(swept.begin(), swept.end(), [](const auto& entity) { return entity.first == 3; });
    return {{"pot", {volume->second}}};
}

}  // namespace

int add_pot_profile(const PotShape& shape) {
    const std::vector<int> outer = add_points(outer_profile(shape));
    const std::vector<int> inner = add_points(inner_profile(shape));
    const int axis_bottom = occ::addPoint(0, 0, 0);
    const int axis_top = occ::addPoint(0, 0, shape.wall);
    const std::vector<int> curves{occ::addLine(axis_bottom, outer.front()), occ::addSpline(outer),
                                  occ::addLine(outer.back(), inner.back()), occ::addSpline({inner.rbegin(), inner.rend()}),
                                  occ::addLine(inner.front(), axis_top),    occ::addLine(axis_top, axis_bottom)};
    return occ::addPlaneSurface({occ::addCurveLoop(curves)});
}

OccBody pot_body(const PotShape& s) {
    return {"pot", fmt::format("2 height {:.17g} foot {:.17g} belly {:.17g} neck {:.17g} rim {:.17g} wall {:.17g}", s.height, s.foot_radius,
                               s.belly_radius, s.neck_radius, s.rim_radius, s.wall),
            [s] { return build(s); }, s.wall, s.wall};
}

Body pot(int target_count, const std::filesystem::path& cache, const PotShape& shape, Mesher mesher) {
    return mesh_occ_body(pot_body(shape), {target_count, mesher}, cache);
}

}  // namespace cleave::mesh
