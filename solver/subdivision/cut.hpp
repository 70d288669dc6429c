#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <vector>

namespace cleave::subdivision {

/// A crack: a plane, or a disc in it.
struct Cut {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< a point of the plane; the disc's centre, m
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the '+' side, any length but zero
    double radius = std::numeric_limits<double>::infinity();  ///< m; infinite: the whole plane
};

/// Length of the shortest edge at each vertex, m; infinite at vertices that no tet uses.
std::vector<double> shortest_incident_edges(const mesh::TetMesh& mesh);

/// Signed distance of each vertex to the cut's plane, m: d >= 0 is the '+' side, and |d| is raised to at least
/// tau * shortest_edge. A rule per VERTEX, so that all tets around it agree and the cut stays conforming: it runs along the plane,
/// but passes vertices at a distance. tau = 0.1 keeps children above 3e-4 of their parent; tau = 0 does not bound them.
/// Throws std::invalid_argument for a bad cut or tau (see checked and require_valid_tau).
std::vector<double> vertex_distances(const std::vector<Eigen::Vector3d>& vertices, const std::vector<double>& shortest_edges,
                                     const Cut& cut, double tau);

/// normal . (x - centre), the order of rounding fixed.
inline double plane_distance(const Eigen::Vector3d& normal, const Eigen::Vector3d& centre, const Eigen::Vector3d& x) {
    return (normal[0] * (x[0] - centre[0]) + normal[1] * (x[1] - centre[1])) + normal[2] * (x[2] - centre[2]);
}

/// The cut with its normal made a unit vector. Throws std::invalid_argument for a normal of length zero or not finite, a centre
/// that is not finite, a radius that is not positive.
Cut checked(const Cut& cut);

/// Throws std::invalid_argument for tau outside [0, 0.5).
void require_valid_tau(double tau);

/// Where the cut passes the edge from a (distance da) to b (db, of the other sign), as a share of the edge.
inline double edge_share(double da, double db) { return da / (da - db); }

/// The point there: a + da/(da-db) (b-a), m. Evaluated from the vertex on the '+' side, so that every tet around the edge gets the
/// same bits.
inline Eigen::Vector3d edge_point(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double da, double db) {
    return a + edge_share(da, db) * (b - a);
}

/// Distance from a point to a triangle, m (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
double distance_to_triangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Whether the cut passes a tet with these corners and distances: signs differ, and the cut polygon comes as near to the
/// disc's centre as its radius.
bool passes(const Cut& cut, const std::array<Eigen::Vector3d, 4>& corners, const std::array<double, 4>& distances);

}  // namespace cleave::subdivision
