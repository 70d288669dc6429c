#include "solver/subdivision/child_writer.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

// The formulas are those of child_geometry.hpp, PlainSubdivision::make_points and mesh::signed_volume, each in the same order of
// rounding, four lanes at a time: lanes are x, y, z of a point, or the quadrilaterals of a parent, or half of eight numbers.

namespace cleave::subdivision {
namespace {

using Vector2 __attribute__((vector_size(16))) = double;
using Int4 __attribute__((vector_size(16))) = int;
using Int8 __attribute__((vector_size(32))) = int;

template <int... lanes>
Vector4 pick(const Vector4& v) {
    return __builtin_shufflevector(v, v, lanes...);
}

/// Writes three doubles, and one more that the next point will overwrite.
void store_over(std::array<double, 3>* out, const Vector4& x) { std::memcpy(out, &x, sizeof x); }
/// Writes three doubles.
void store(std::array<double, 3>* out, const Vector4& x) {
    const Vector2 low = __builtin_shufflevector(x, x, 0, 1);
    std::memcpy(out, &low, sizeof low);
    (*out)[2] = x[2];
}

template <class Value>
Value load(const void* from) {
    Value value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

/// u x v; lane 3 is of no meaning.
Vector4 cross(const Vector4& u, const Vector4& v) {
    const Vector4 zxy = u * pick<1, 2, 0, 3>(v) - pick<1, 2, 0, 3>(u) * v;  // z, x, y of the product
    return pick<1, 2, 0, 3>(zxy);
}

/// | mesh::signed_volume |
double volume(const Vector4& a, const Vector4& b, const Vector4& c, const Vector4& d) {
    const Vector4 product = cross(b - a, c - a) * (d - a);
    return __builtin_fabs(((product[0] + product[1]) + product[2]) / 6.0);
}

/// Turns four vectors over, out[i][j] = in[j][i], and writes each to its place.
void store_turned(double* out, const Vector4& a, const Vector4& b, const Vector4& c, const Vector4& d, double* second, double* third,
                  double* fourth) {
    const Vector4 ab_02 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Vector4 cd_02 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    const auto put = [](double* to, const Vector4& x) { std::memcpy(to, &x, sizeof x); };
    put(out, __builtin_shufflevector(ab_02, cd_02, 0, 1, 4, 5));
    put(second, __builtin_shufflevector(ab_13, cd_13, 0, 1, 4, 5));
    put(third, __builtin_shufflevector(ab_02, cd_02, 2, 3, 6, 7));
    if (fourth != nullptr) put(fourth, __builtin_shufflevector(ab_13, cd_13, 2, 3, 6, 7));
}

/// The points that a parent makes go to their places; those it shares with one before it, to nowhere (a choice of address, because a
/// branch on it cannot be foretold).
void store_point(const ParentPlan& plan, int bit, int number, const Vector4& x, std::array<double, 3>* points) {
    std::array<double, 3> nowhere;
    store((plan.makes >> bit & 1) != 0 ? points + number : &nowhere, x);
    asm("" : : "r"(&nowhere) : "memory");
}

/// Corners and links of two children at a time.
template <int pairs>
inline void write_numbers(const ParentPlan& plan, const ChildPattern& pattern, const ChildArrays& out) {
    std::array<int, 4>*__restrict tets = out.tets, *__restrict links = out.links;
    const __m256i corners = load<__m256i>(&plan.corner), faces = load<__m256i>(&plan.face_point);
    const Int8 first = Int8{} + plan.first_half_face, unlinked = Int8{} - 1;
    const auto write = [&]<std::size_t pair>() {
        constexpr bool in_ring = pairs == 7 ? pair > 0 : pair % 5 != 0;
        constexpr std::size_t ring = pairs == 7 ? (pair - 1) / 2 : 2 * (pair / 5) + (pair % 5 - 1) / 2;
        constexpr std::size_t first_of_ring = pairs == 7 ? 1 + 2 * ring : 1 + 2 * ring + ring / 2;
        const __m256i from_corners = _mm256_permutevar8x32_epi32(corners, load<__m256i>(&pattern.from_corners[pair]));
        // The barycentre and the apex stand at the same corners all around a ring.
        const __m256i from_faces = _mm256_permutevar8x32_epi32(faces, load<__m256i>(&pattern.from_faces[in_ring ? first_of_ring : pair]));
        Int8 behind = first + load<Int8>(&pattern.inner[pair]);
        __m256i numbers;
        if constexpr (in_ring) {
            numbers = _mm256_blend_epi32(from_corners, from_faces, 0b11001100);
            const Int8 outer = plan.behind[ring].ring + load<Int8>(&pattern.outer[pair]);
            behind = (Int8)_mm256_blendv_epi8((__m256i)behind, (__m256i)(outer > unlinked ? outer : unlinked),
                                              load<__m256i>(&pattern.is_outer[in_ring ? first_of_ring : pair]));
        } else {
            numbers = _mm256_blendv_epi8(from_corners, from_faces, load<__m256i>(&pattern.takes_face[pair]));
        }
        std::memcpy(tets + 2 * pair, &numbers, sizeof numbers);
        std::memcpy(links + 2 * pair, &behind, sizeof behind);
    };
    [&]<std::size_t... pair>(std::index_sequence<pair...>) { (write.template operator()<pair>(), ...); }(std::make_index_sequence<pairs>());
    int* half_faces = links->data();
    constexpr int cuts = pairs == 7 ? 3 : 4;
    for (int k = 0; k < cuts; ++k) half_faces[pattern.lone[k]] = std::max(plan.behind[k].lone, -1);
    if constexpr (cuts == 3) {
        const auto [second, first_piece] = plan.behind[3];
        half_faces[pattern.base[0]] = std::max(first_piece, -1);
        half_faces[pattern.base[1]] = std::max(second, -1);
        half_faces[pattern.base[2]] = std::max(first_piece + ParentLayout::third_piece, -1);
    }
    const Int8 parent = Int8{} + plan.tet;
    std::memcpy(out.parents, &parent, 32);
    std::memcpy(out.parents + (pairs == 7 ? 6 : 8), &parent, 32);
    if constexpr (pairs == 10) std::memcpy(out.parents + 16, &parent, 16);
}

/// Of three_one_volumes.
void write_volumes_of_three_one(double parent, const Vector4& u, const Vector4& c, double* out) {
    const Vector4 ui = pick<0, 0, 1, 1>(u), uj = pick<1, 2, 2, 2>(u), ci = pick<0, 0, 1, 1>(c), cj = pick<1, 2, 2, 2>(c);
    const Vector4 product = ui * uj;  // u0 u1, u0 u2, u1 u2
    const Vector4 below = product * pick<2, 1, 0, 0>(c);
    const double twelfth = parent * (1.0 / 12);
    out[0] = parent * (product[0] * u[2]);
    out[1] = (4 * twelfth) * ((below[0] + below[1]) + below[2]);
    store_turned(out + 2, twelfth * (ui * cj + uj * ci), twelfth * (cj * (1 + ui)), twelfth * (ci + cj), twelfth * (ci * (1 + uj)), out + 6,
                 out + 10, nullptr);
}

/// Of two_two_volumes.
void write_volumes_of_two_two(double parent, const Vector4& minus, const Vector4& plus, double* out) {
    const Vector4 ui = __builtin_shufflevector(plus, minus, 0, 1, 4, 6), uj = __builtin_shufflevector(plus, minus, 2, 3, 5, 7);
    const Vector4 ci = __builtin_shufflevector(plus, minus, 4, 5, 0, 2), cj = __builtin_shufflevector(plus, minus, 6, 7, 1, 3);
    const Vector4 ends = ci + cj, apex = pick<1, 0, 3, 2>(ends);
    const Vector4 end = (0.25 * parent) * ((ui * uj) * apex), share = (0.0625 * parent) * apex;
    const Vector2 at_minus = __builtin_shufflevector(end, end, 0, 1), at_plus = __builtin_shufflevector(end, end, 2, 3);
    std::memcpy(out, &at_plus, sizeof at_plus);
    std::memcpy(out + 10, &at_minus, sizeof at_minus);
    store_turned(out + 2, share * (ui * cj + uj * ci), share * (cj * (1 + ui)), share * ends, share * (ci * (1 + uj)), out + 6, out + 12, out + 16);
}

/// The faces of a parent that have a tet behind them and no links.
unsigned loose_faces(const ParentPlan& plan) {
    // The sign of each pair's upper half.
    return static_cast<unsigned>(_mm256_movemask_pd(load<__m256d>(&plan.behind))) & plan.inner_faces;
}

/// A base of these corners, with what its extra links need while the tet behind it is whole.
void note_base(const ParentPlan& plan, const ParentLayout& layout, const Vector4& a, const Vector4& b, const Vector4& c, LooseFace& added) {
    const Vector4 normal = cross(b - a, c - a), squares = normal * normal;  // triangle_area
    added.face = 4 * plan.tet + layout.base_face;
    added.behind = plan.behind_base;
    for (int k = 0; k < 3; ++k) added.pieces[k] = plan.first_half_face + layout.pattern->base[k];
    added.third = 0.5 * __builtin_sqrt((squares[0] + squares[1]) + squares[2]) / 3;
}

/// Lists loose faces in the order of the sorted vertices opposite.
void note_loose_faces(const ParentPlan& plan, const ParentLayout& layout, const Vector4* vertices, unsigned loose_faces, Buffer<LooseFace>& loose) {
    for (int face = 0; face < 4; ++face) {
        if ((loose_faces >> layout.place[face] & 1U) == 0) continue;
        LooseFace& added = *loose.grow_by(1);
        added.face = 4 * plan.tet + face;
        added.behind = -1;
        if (face != layout.base_face) continue;
        note_base(plan, layout, vertices[plan.corner[1]], vertices[plan.corner[2]], vertices[plan.corner[3]], added);
    }
}

template <bool lone_plus>
inline void write_three_one(const CuttingPlane& plane, const ParentPlan& plan, const Vector4* vertices, const ChildArrays& out) {
    const Vector4 a = vertices[plan.corner[0]], b0 = vertices[plan.corner[1]], b1 = vertices[plan.corner[2]], b2 = vertices[plan.corner[3]];
    const Vector4 size = plane.sizes(FourVertices(a, b0, b1, b2));
    const Vector4 lone = pick<0, 0, 0, 0>(size), base = pick<1, 2, 3, 3>(size);
    const Vector4 from_plus = lone_plus ? lone / (lone + base) : base / (base + lone), from_minus = 1 - from_plus;
    write_volumes_of_three_one(volume(a, b0, b1, b2), lone_plus ? from_plus : from_minus, lone_plus ? from_minus : from_plus, out.volumes);

    const auto cut_point = [&](const Vector4& b, double share) { return lone_plus ? a + share * (b - a) : b + share * (a - b); };
    const Vector4 p0 = cut_point(b0, from_plus[0]), p1 = cut_point(b1, from_plus[1]), p2 = cut_point(b2, from_plus[2]);
    const Vector4 c = ((b0 + b1) + b2) / 3;
    // Quarters from here on: they scale no rounding.
    const Vector4 qa = 0.25 * a, qb0 = 0.25 * b0, qb1 = 0.25 * b1, qb2 = 0.25 * b2, qp0 = 0.25 * p0, qp1 = 0.25 * p1, qp2 = 0.25 * p2, qc = 0.25 * c;
    const Vector4 ends01 = qb0 + qb1, ends02 = qb0 + qb2, ends12 = qb1 + qb2, cuts01 = qp0 + qp1, cuts02 = qp0 + qp2, cuts12 = qp1 + qp2;
    const Vector4 side0 = qp0 + qb0, side1 = qp1 + qb1, side2 = qp2 + qb2;
    const Vector4 face01 = ends01 + cuts01, face02 = ends02 + cuts02, face12 = ends12 + cuts12;
    store_over(out.centroids, (qa + qp0) + cuts12);
    store_over(out.centroids + 1, cuts01 + (qp2 + qc));
    const auto ring = [&](int first, const Vector4& cuts, const Vector4& right, const Vector4& ends, const Vector4& left, const Vector4& face) {
        const Vector4 apex = 0.25 * face + qc;
        store_over(out.centroids + first, cuts + apex);
        store_over(out.centroids + first + 1, right + apex);
        store_over(out.centroids + first + 2, ends + apex);
        first == 10 ? store(out.centroids + first + 3, left + apex) : store_over(out.centroids + first + 3, left + apex);
    };
    ring(2, cuts01, side1, ends01, side0, face01);
    ring(6, cuts02, side2, ends02, side0, face02);
    ring(10, cuts12, side2, ends12, side1, face12);
    store_point(plan, 0, plan.cut_point[0], p0, out.points);
    store_point(plan, 1, plan.cut_point[1], p1, out.points);
    store_point(plan, 2, plan.cut_point[2], p2, out.points);
    store_point(plan, 4, plan.face_point[0], face01, out.points);
    store_point(plan, 5, plan.face_point[1], face02, out.points);
    store_point(plan, 6, plan.face_point[2], face12, out.points);
    store_point(plan, 7, plan.face_point[3], c, out.points);
}

inline void write_two_two(const CuttingPlane& plane, const ParentPlan& plan, const Vector4* vertices, const ChildArrays& out) {
    const Vector4 h0 = vertices[plan.corner[0]], h1 = vertices[plan.corner[1]], t0 = vertices[plan.corner[2]], t1 = vertices[plan.corner[3]];
    const Vector4 size = plane.sizes(FourVertices(h0, h1, t0, t1));
    const Vector4 plus = pick<0, 0, 1, 1>(size), minus = pick<2, 3, 2, 3>(size);
    const Vector4 share = plus / (plus + minus);  // of the edges +0 -0, +0 -1, +1 -0, +1 -1, from the '+' vertex
    write_volumes_of_two_two(volume(h0, h1, t0, t1), share, 1 - share, out.volumes);

    const Vector4 p00 = h0 + share[0] * (t0 - h0), p01 = h0 + share[1] * (t1 - h0), p10 = h1 + share[2] * (t0 - h1), p11 = h1 + share[3] * (t1 - h1);
    const Vector4 qh0 = 0.25 * h0, qh1 = 0.25 * h1, qt0 = 0.25 * t0, qt1 = 0.25 * t1;
    const Vector4 q00 = 0.25 * p00, q01 = 0.25 * p01, q10 = 0.25 * p10, q11 = 0.25 * p11;
    const Vector4 at_plus0 = q00 + q01, at_plus1 = q10 + q11, at_minus0 = q00 + q10, at_minus1 = q01 + q11;
    const Vector4 centre = at_plus0 + at_plus1, qc = 0.25 * centre, plus_ends = qh0 + qh1, minus_ends = qt0 + qt1;
    const Vector4 face_minus0 = plus_ends + at_minus0, face_minus1 = plus_ends + at_minus1;
    const Vector4 face_plus0 = minus_ends + at_plus0, face_plus1 = minus_ends + at_plus1;
    const auto ring = [&](int first, const Vector4& cuts, const Vector4& right, const Vector4& ends, const Vector4& left, const Vector4& face) {
        const Vector4 apex = 0.25 * face + qc;
        store_over(out.centroids + first, cuts + apex);
        store_over(out.centroids + first + 1, right + apex);
        store_over(out.centroids + first + 2, ends + apex);
        first == 16 ? store(out.centroids + first + 3, left + apex) : store_over(out.centroids + first + 3, left + apex);
    };
    store_over(out.centroids, (qh0 + q00) + (q01 + qc));
    store_over(out.centroids + 1, (qh1 + q10) + (q11 + qc));
    ring(2, at_minus0, q10 + qh1, plus_ends, q00 + qh0, face_minus0);
    ring(6, at_minus1, q11 + qh1, plus_ends, q01 + qh0, face_minus1);
    store_over(out.centroids + 10, (qt0 + q00) + (q10 + qc));
    store_over(out.centroids + 11, (qt1 + q01) + (q11 + qc));
    ring(12, at_plus0, q01 + qt1, minus_ends, q00 + qt0, face_plus0);
    ring(16, at_plus1, q11 + qt1, minus_ends, q10 + qt0, face_plus1);
    store_point(plan, 0, plan.cut_point[0], p00, out.points);
    store_point(plan, 1, plan.cut_point[1], p01, out.points);
    store_point(plan, 2, plan.cut_point[2], p10, out.points);
    store_point(plan, 3, plan.cut_point[3], p11, out.points);
    store_point(plan, 4, plan.face_point[0], face_minus0, out.points);
    store_point(plan, 5, plan.face_point[1], face_minus1, out.points);
    store_point(plan, 6, plan.face_point[2], face_plus0, out.points);
    store_point(plan, 7, plan.face_point[3], face_plus1, out.points);
    store(out.points + plan.centre, centre);
}

}  // namespace

std::size_t write_children(const CuttingPlane& plane, const ParentPlan* first, const ParentPlan* last, const ParentLayout* layouts,
                           const Vector4* vertices, ChildArrays out, Buffer<LooseFace>& loose) {
    constexpr int ahead = 6;
    const CuttingPlane own_plane = plane;  // no store can change it
    const double* first_volume = out.volumes;
    for (const ParentPlan* plan = first; plan != last; ++plan) {
        for (const int vertex : plan[last - plan > ahead ? ahead : 0].corner) __builtin_prefetch(&vertices[vertex]);
        const ParentLayout& layout = layouts[plan->layout];
        const unsigned unlinked = loose_faces(*plan);
        if (layout.kind == ParentLayout::two_two) {
            write_two_two(own_plane, *plan, vertices, out);
            write_numbers<10>(*plan, *layout.pattern, out);
            if (unlinked != 0) note_loose_faces(*plan, layout, vertices, unlinked, loose);
        } else {
            layout.kind == ParentLayout::lone_plus ? write_three_one<true>(own_plane, *plan, vertices, out)
                                                   : write_three_one<false>(own_plane, *plan, vertices, out);
            write_numbers<7>(*plan, *layout.pattern, out);
            const int* base = plan->corner.data() + 1;
            if (unlinked == 8) note_base(*plan, layout, vertices[base[0]], vertices[base[1]], vertices[base[2]], *loose.grow_by(1));
            else if (unlinked != 0) note_loose_faces(*plan, layout, vertices, unlinked, loose);
        }
        out.tets += layout.children;
        out.links += layout.children;
        out.centroids += layout.children;
        out.volumes += layout.children;
        out.parents += layout.children;
    }
    return static_cast<std::size_t>(out.volumes - first_volume);
}

}  // namespace cleave::subdivision
