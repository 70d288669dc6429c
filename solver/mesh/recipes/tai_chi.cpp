#include "solver/mesh/recipes/tai_chi.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <array>
#include <numbers>

namespace cleave::mesh {
namespace {

namespace occ = gmsh::model::occ;

/// The circle arc about (0, y) between two points.
int arc(double y, int first, int last) {
    const int centre = occ::addPoint(0, y, 0);
    const int curve = occ::addCircleArc(first, centre, last);
    occ::remove({{0, centre}});
    return curve;
}

/// Curves of the disc in the plane z = 0, upwards from the lowest point of the rim.
struct Curves {
    std::vector<int> right_rim, s_curve, left_rim;
};

Curves add_curves(const TaiChiShape& s) {
    const double diameter = s.radius - s.neck, middle = diameter / 2;  // of the S-curve's two half circles
    const auto point = [](double x, double y) { return occ::addPoint(x, y, 0); };
    const int bottom = point(0, -s.radius), top = point(0, s.radius), right = point(s.radius, 0), left = point(-s.radius, 0);
    const int low = point(0, -diameter), high = point(0, diameter), centre = point(0, 0);
    const int lower = point(-middle, -middle), upper = point(middle, middle);
    Curves curves;
    curves.right_rim = {arc(0, bottom, right), arc(0, right, top)};
    curves.left_rim = {arc(0, bottom, left), arc(0, left, top)};
    curves.s_curve = {occ::addLine(bottom, low),       arc(-middle, low, lower), arc(-middle, lower, centre),
                      arc(middle, centre, upper), arc(middle, upper, high), occ::addLine(high, top)};
    return curves;
}

int loop(std::vector<int> up, const std::vector<int>& down) {
    for (auto curve = down.rbegin(); curve != down.rend(); ++curve) up.push_back(-*curve);
    return occ::addCurveLoop(up);
}

/// Faces of yin's half, yang's half, the upper and the lower dot. The S-curve bulges right above the centre, so the upper dot lies in yang.
std::array<int, 4> add_faces(const TaiChiShape& s) {
    const Curves curves = add_curves(s);
    const double middle = (s.radius - s.neck) / 2;
    const auto dot = [&](double y) { return occ::addCurveLoop({occ::addCircle(0, y, 0, s.dot_radius)}); };
    const int upper = dot(middle), lower = dot(-middle);
    return {occ::addPlaneSurface({loop(curves.right_rim, curves.s_curve), lower}),
            occ::addPlaneSurface({loop(curves.s_curve, curves.left_rim), upper}), occ::addPlaneSurface({upper}), occ::addPlaneSurface({lower})};
}

std::vector<Region> build(const TaiChiShape& s) {
    const auto [yin, yang, upper, lower] = add_faces(s);
    gmsh::vectorpair swept;  // one call, so that neighbours share their side faces
    occ::extrude({{2, yin}, {2, yang}, {2, upper}, {2, lower}}, 0, 0, s.thickness, swept);
    std::vector<int> volumes;
    for (const auto& [dimension, tag] : swept) {
        if (dimension == 3) volumes.push_back(tag);
    }
    return {{"yin", {volumes.at(0), volumes.at(2)}}, {"yang", {volumes.at(1), volumes.at(3)}}};
}

}  // namespace

OccBody tai_chi_body(const TaiChiShape& s) {
    return {"tai_chi",
            fmt::format("1 radius {:.17g} thickness {:.17g} neck {:.17g} dot {:.17g}", s.radius, s.thickness, s.neck, s.dot_radius),
            [s] { return build(s); }, s.neck / 2, 0};
}

}  // namespace cleave::mesh
