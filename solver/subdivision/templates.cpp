#include "solver/subdivision/templates.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <bit>
#include <utility>

namespace cleave::subdivision {
namespace {

/// Builds one template. Orientation is found with barycentric coordinates at cut points in mid-edge: the sign of a child's
/// determinant does not depend on where on its edge a cut point lies.
class Builder {
public:
    explicit Builder(unsigned plus_mask) : plus_mask_(plus_mask) {
        const int plus = std::popcount(plus_mask);
        if (plus == 0 || plus == 4) return;
        mark_cuts();
        plus == 2 ? build_two_two() : build_three_one(plus == 1 ? 1 : -1);
        list_points();
    }

    CutTemplate result() && { return std::move(template_); }

private:
    bool is_plus(int vertex) const { return (plus_mask_ >> vertex & 1U) != 0; }

    int side_of(int vertex) const { return is_plus(vertex) ? 1 : -1; }

    /// The sides are compared as numbers: from `is_plus(v) == (side > 0)`, a bit against a sign that stays the same in the loop,
    /// g++ 12 at -O1 can lose the sign (its combined instruction "jump by bit" takes any second operand for zero).
    std::vector<int> vertices_on(int side) const {
        std::vector<int> found;
        for (int v = 0; v < 4; ++v) {
            if (side_of(v) == side) found.push_back(v);
        }
        return found;
    }

    void mark_cuts() {
        for (int e = 0; e < 6; ++e) {
            if (is_plus(edge_ends[e][0]) != is_plus(edge_ends[e][1])) template_.edges |= 1U << e;
        }
        for (int f = 0; f < 4; ++f) {
            const unsigned others = plus_mask_ & ~(1U << f);
            if (others != 0 && others != (15U & ~(1U << f))) template_.quad_faces |= 1U << f;
            else template_.base_face = f;
        }
    }

    Eigen::Vector4d barycentric(PointCode code) const {
        Eigen::Vector4d at = Eigen::Vector4d::Zero();
        if (code < first_edge_code) {
            at[code] = 1;
        } else if (code < first_face_code) {
            for (const int end : edge_ends[code - first_edge_code]) at[end] = 0.5;
        } else {
            for (PointCode corner = 0; corner < first_face_code; ++corner) {
                if (is_corner(corner, code)) at += barycentric(corner);
            }
        }
        return at / at.sum();
    }

    /// Whether `code` (a barycentre) is the mean over points that include `corner`.
    bool is_corner(PointCode corner, PointCode code) const {
        const bool cut_point = corner >= first_edge_code && (template_.edges >> (corner - first_edge_code) & 1U) != 0;
        if (code == centre_code) return cut_point;
        const int face = code - first_face_code;
        if ((faces_of(corner) >> face & 1U) == 0) return false;
        if (face == template_.base_face) return corner < first_edge_code;
        return cut_point || (corner < first_edge_code && !is_alone_on_face(corner, face));
    }

    bool is_alone_on_face(int vertex, int face) const {
        for (int other = 0; other < 4; ++other) {
            if (other != vertex && other != face && is_plus(other) == is_plus(vertex)) return false;
        }
        return true;
    }

    void add(std::array<PointCode, 4> points, int side) {
        Eigen::Matrix4d corners;
        for (int i = 0; i < 4; ++i) corners.col(i) = barycentric(points[i]);
        if (corners.determinant() < 0) std::swap(points[2], points[3]);
        template_.children.push_back({points, side});
    }

    /// The quadrilateral P_ai P_aj j i of the face with lone vertex a, in four tets with the given apex; on the side of i and j.
    void add_quad(int a, int i, int j, PointCode apex, int side) {
        const int face = 6 - a - i - j;
        const std::array<PointCode, 4> ring{edge_code(a, i), edge_code(a, j), static_cast<PointCode>(j), static_cast<PointCode>(i)};
        for (int k = 0; k < 4; ++k) {
            add({ring[k], ring[(k + 1) % 4], static_cast<PointCode>(first_face_code + face), apex}, side);
        }
    }

    void set_roles(const std::vector<int>& first, const std::vector<int>& second) {
        std::copy(second.begin(), second.end(), std::copy(first.begin(), first.end(), template_.roles.begin()));
        for (const int i : first) {
            for (const int j : second) template_.points.push_back(edge_code(i, j));
        }
    }

    /// After the cut points: the others, as the children name them.
    void list_points() {
        std::vector<PointCode>& points = template_.points;
        const auto last = template_.centre ? centre_code : static_cast<PointCode>(first_face_code + template_.base_face);
        for (const ChildTemplate& child : template_.children) {
            for (const PointCode code : child.points) {
                if (code >= first_face_code && code != last && std::find(points.begin(), points.end(), code) == points.end()) points.push_back(code);
            }
        }
        points.push_back(last);
    }

    void build_three_one(int apex_side) {
        const int a = vertices_on(apex_side)[0];
        const std::vector<int> base = vertices_on(-apex_side);
        set_roles({a}, base);
        const std::array<PointCode, 3> cut{edge_code(a, base[0]), edge_code(a, base[1]), edge_code(a, base[2])};
        const auto c = static_cast<PointCode>(first_face_code + template_.base_face);
        add({static_cast<PointCode>(a), cut[0], cut[1], cut[2]}, apex_side);
        add({cut[0], cut[1], cut[2], c}, -apex_side);
        add_quad(a, base[0], base[1], c, -apex_side);
        add_quad(a, base[0], base[2], c, -apex_side);
        add_quad(a, base[1], base[2], c, -apex_side);
    }

    void build_two_two() {
        template_.centre = true;
        set_roles(vertices_on(1), vertices_on(-1));
        for (const int side : {1, -1}) {
            const std::vector<int> here = vertices_on(side), there = vertices_on(-side);
            for (const int a : here) add({static_cast<PointCode>(a), edge_code(a, there[0]), edge_code(a, there[1]), centre_code}, side);
            for (const int lone : there) add_quad(lone, here[0], here[1], centre_code, side);
        }
    }

    unsigned plus_mask_;
    CutTemplate template_;
};

std::array<CutTemplate, 16> build_all() {
    std::array<CutTemplate, 16> all;
    for (unsigned mask = 0; mask < 16; ++mask) all[mask] = Builder(mask).result();
    return all;
}

}  // namespace

PointCode edge_code(int i, int j) {
    const auto [low, high] = std::minmax(i, j);
    return static_cast<PointCode>(first_edge_code + (low == 0 ? high - 1 : low + high));
}

unsigned faces_of(PointCode code) {
    if (code < first_edge_code) return 15U & ~(1U << code);
    if (code < first_face_code) {
        const auto& [i, j] = edge_ends[code - first_edge_code];
        return 15U & ~(1U << i) & ~(1U << j);
    }
    return code < centre_code ? 1U << (code - first_face_code) : 0U;
}

const CutTemplate& cut_template(unsigned plus_mask) {
    static const std::array<CutTemplate, 16> all = build_all();
    return all[plus_mask & 15U];
}

}  // namespace cleave::subdivision
