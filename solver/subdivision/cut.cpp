#include "solver/subdivision/cut.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::subdivision {
namespace {

using Eigen::Vector3d;

/// The cut polygon of a tet in order around it: 3 points (one vertex alone) or 4.
struct CutPolygon {
    std::array<Vector3d, 4> points;
    int count = 0;
};

CutPolygon cut_polygon(const std::array<Vector3d, 4>& corners, const std::array<double, 4>& distances) {
    std::array<int, 4> plus{}, minus{};
    int plus_count = 0, minus_count = 0;
    for (int i = 0; i < 4; ++i) (distances[i] >= 0 ? plus[plus_count++] : minus[minus_count++]) = i;
    CutPolygon polygon;
    const auto add = [&](int i, int j) {
        polygon.points[polygon.count++] = edge_point(corners[i], corners[j], distances[i], distances[j]);
    };
    if (plus_count == 2) {
        add(plus[0], minus[0]), add(plus[0], minus[1]), add(plus[1], minus[1]), add(plus[1], minus[0]);
    } else {
        for (int i = 0; i < plus_count; ++i) {
            for (int j = 0; j < minus_count; ++j) add(plus[i], minus[j]);
        }
    }
    return polygon;
}

}  // namespace

Cut checked(const Cut& cut) {
    const double length = cut.normal.norm();
    if (!(length > 0) || !std::isfinite(length)) throw std::invalid_argument("Cut: the normal must have a finite length above 0");
    if (!cut.centre.allFinite()) throw std::invalid_argument("Cut: the centre must be finite");
    if (!(cut.radius > 0)) throw std::invalid_argument("Cut: the radius must be positive");
    return {.centre = cut.centre, .normal = cut.normal / length, .radius = cut.radius};
}

void require_valid_tau(double tau) {
    if (!(tau >= 0 && tau < 0.5)) throw std::invalid_argument("tau must lie in [0, 0.5)");
}

std::vector<double> shortest_incident_edges(const mesh::TetMesh& mesh) {
    std::vector<double> shortest(mesh.vertices.size(), std::numeric_limits<double>::infinity());
    for (const auto& tet : mesh.tets) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                // Shared edges come once per tet: subtract in one order, so that each gives the same bits.
                const auto [low, high] = std::minmax(tet[i], tet[j]);
                const Vector3d along = mesh.vertices[high] - mesh.vertices[low];
                const double square = (along[0] * along[0] + along[1] * along[1]) + along[2] * along[2];
                shortest[low] = std::min(shortest[low], square);
                shortest[high] = std::min(shortest[high], square);
            }
        }
    }
    for (double& length : shortest) length = std::sqrt(length);
    return shortest;
}

std::vector<double> vertex_distances(const std::vector<Vector3d>& vertices, const std::vector<double>& shortest_edges, const Cut& cut,
                                     double tau) {
    require_valid_tau(tau);
    const Cut plane = checked(cut);
    std::vector<double> distances(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double distance = plane_distance(plane.normal, plane.centre, vertices[v]);
        const double raised = std::max(std::abs(distance), tau * shortest_edges[v]);
        distances[v] = distance >= 0 ? raised : -raised;
    }
    return distances;
}

double distance_to_triangle(const Vector3d& point, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0) return ap.norm();
    if (d3 >= 0 && d4 <= d3) return bp.norm();
    if (d6 >= 0 && d5 <= d6) return cp.norm();
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).norm();
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).norm();
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).norm();
    return std::abs(ab.cross(ac).normalized().dot(ap));
}

bool passes(const Cut& cut, const std::array<Vector3d, 4>& corners, const std::array<double, 4>& distances) {
    const int plus = static_cast<int>(std::count_if(distances.begin(), distances.end(), [](double d) { return d >= 0; }));
    if (plus == 0 || plus == 4) return false;
    if (std::isinf(cut.radius)) return true;
    const CutPolygon polygon = cut_polygon(corners, distances);
    double nearest = distance_to_triangle(cut.centre, polygon.points[0], polygon.points[1], polygon.points[2]);
    if (polygon.count == 4) {
        nearest = std::min(nearest, distance_to_triangle(cut.centre, polygon.points[0], polygon.points[2], polygon.points[3]));
    }
    return nearest <= cut.radius;
}

}  // namespace cleave::subdivision
