#pragma once

#include <Eigen/Core>

#include <array>

namespace cleave::subdivision {

/// Mean of a child's corners. Pairs are added first, because many children share a pair.
inline Eigen::Vector3d child_centroid(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
    return 0.25 * ((a + b) + (c + d));
}

// Volumes of children as shares of their parent's. Cut points divide edges, so that every child's volume is the parent's times a
// polynomial of these divisions; each of its terms is positive, hence no child's volume ever rounds to a negative number and
// all keep full relative accuracy, which a determinant of the children's corners does not.
//
// A face with the lone vertex a (at 0), its edges to i and j cut at shares u_i and u_j: in coordinates along the edges P_i = (u_i, 0),
// P_j = (0, u_j), i = (1, 0), j = (0, 1), the quadrilateral's barycentre is ((1 + u_i)/4, (1 + u_j)/4), and the triangles of the ring
// P_i P_j j i with it have, in quarters of the face, with c = 1 - u:
//     u_i c_j + u_j c_i,   c_j (1 + u_i),   c_i + c_j,   c_i (1 + u_j).
// A tet on one of them is the parent's volume by that and by the barycentric coordinate of its apex.

/// The children's volumes of a 3-1 tet of volume `parent`, in the order of its template: u[i] is the share of the edge from the lone
/// vertex to base vertex i at which it is cut, c[i] = 1 - u[i]. The apex of the quadrilaterals, the base's barycentre, has the
/// coordinate 1/3. Lone tet: u0 u1 u2. The one below, whose apex is that barycentre: (u0 u1 c2 + u0 u2 c1 + u1 u2 c0) / 3.
inline std::array<double, 14> three_one_volumes(double parent, const std::array<double, 3>& u, const std::array<double, 3>& c) {
    const double twelfth = parent * (1.0 / 12);
    std::array<double, 14> volumes{parent * ((u[0] * u[1]) * u[2]),
                                   (4 * twelfth) * (((u[0] * u[1]) * c[2] + (u[0] * u[2]) * c[1]) + (u[1] * u[2]) * c[0])};
    constexpr std::array<std::array<int, 2>, 3> quads{{{0, 1}, {0, 2}, {1, 2}}};
    for (int quad = 0; quad < 3; ++quad) {
        const auto& [i, j] = quads[quad];
        volumes[2 + 4 * quad] = twelfth * (u[i] * c[j] + u[j] * c[i]);
        volumes[3 + 4 * quad] = twelfth * (c[j] * (1 + u[i]));
        volumes[4 + 4 * quad] = twelfth * (c[i] + c[j]);
        volumes[5 + 4 * quad] = twelfth * (c[i] * (1 + u[j]));
    }
    return volumes;
}

/// The same of a 2-2 tet: minus[2 * i + j] is the share of the edge from '+' vertex i to '-' vertex j at which it is cut, plus = 1 - minus.
/// The apex, the mean of the four cut points, has at a vertex a quarter of the sum of the shares towards it. An end tet at
/// vertex a with cut points at u_0, u_1: u_0 u_1 by the apex's coordinate at the other vertex of a's side.
inline std::array<double, 20> two_two_volumes(double parent, const std::array<double, 4>& minus, const std::array<double, 4>& plus) {
    const double quarter = 0.25 * parent, sixteenth = 0.0625 * parent;
    // Per quadrilateral, lone vertices -0, -1, +0, +1: shares from the lone vertex to the two others, and what is left of them.
    const std::array<double, 4> ui{plus[0], plus[1], minus[0], minus[2]}, uj{plus[2], plus[3], minus[1], minus[3]};
    const std::array<double, 4> ci{minus[0], minus[1], plus[0], plus[2]}, cj{minus[2], minus[3], plus[1], plus[3]};
    std::array<double, 20> volumes{};
    constexpr std::array<int, 4> first{2, 6, 12, 16}, end{10, 11, 0, 1};
    for (int quad = 0; quad < 4; ++quad) {
        const int other = quad ^ 1;                       // the quadrilateral whose lone vertex is the other one of that side
        const double apex = ci[other] + cj[other];        // four times the coordinate at that vertex
        const double share = sixteenth * apex;
        volumes[first[quad]] = share * (ui[quad] * cj[quad] + uj[quad] * ci[quad]);
        volumes[first[quad] + 1] = share * (cj[quad] * (1 + ui[quad]));
        volumes[first[quad] + 2] = share * (ci[quad] + cj[quad]);
        volumes[first[quad] + 3] = share * (ci[quad] * (1 + uj[quad]));
        volumes[end[quad]] = quarter * ((ui[quad] * uj[quad]) * apex);
    }
    return volumes;
}

}  // namespace cleave::subdivision
