#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cleave::subdivision {
namespace {

using Int4 __attribute__((vector_size(16))) = int;
using Vector2 __attribute__((vector_size(16))) = double;

/// u x v; lane 3 is of no meaning.
Vector4 cross(const Vector4& u, const Vector4& v) {
    const Vector4 u_yzx = __builtin_shufflevector(u, u, 1, 2, 0, 3), v_yzx = __builtin_shufflevector(v, v, 1, 2, 0, 3);
    const Vector4 zxy = u * v_yzx - u_yzx * v;  // z, x, y of the product
    return __builtin_shufflevector(zxy, zxy, 1, 2, 0, 3);
}

/// mesh::signed_volume with the same rounding.
double volume(const Vector4& a, const Vector4& b, const Vector4& c, const Vector4& d) {
    const Vector4 product = cross(b - a, c - a) * (d - a);
    return ((product[0] + product[1]) + product[2]) / 6.0;
}

void store(std::array<double, 3>& out, const Vector4& x) {
    const Vector2 low = __builtin_shufflevector(x, x, 0, 1);
    std::memcpy(out.data(), &low, sizeof low);
    out[2] = x[2];
}

/// plane.distance and plane.raised of four vertices at once: lane i for x[i].
Vector4 raised(const SubdivisionPlane& plane, const Vector4* x) {
    const Vector4 low01 = __builtin_shufflevector(x[0], x[1], 0, 4, 2, 6), high01 = __builtin_shufflevector(x[0], x[1], 1, 5, 3, 7);
    const Vector4 low23 = __builtin_shufflevector(x[2], x[3], 0, 4, 2, 6), high23 = __builtin_shufflevector(x[2], x[3], 1, 5, 3, 7);
    const Vector4 xs = __builtin_shufflevector(low01, low23, 0, 1, 4, 5), zs = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    const Vector4 ys = __builtin_shufflevector(high01, high23, 0, 1, 4, 5), edges = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
    const Vector4 d = (plane.normal[0] * (xs - plane.centre[0]) + plane.normal[1] * (ys - plane.centre[1])) +
                      plane.normal[2] * (zs - plane.centre[2]);
    const Vector4 size = d >= 0 ? d : -d, least = plane.tau * edges;
    const Vector4 up = size > least ? size : least;
    return d >= 0 ? up : -up;
}

constexpr int marked = -2;  ///< a barycentre that is wanted and has no number yet
constexpr int scan_below = 20'000;  ///< tets: smaller meshes are scanned faster than searched

}  // namespace

SubdivisionEngine::SubdivisionEngine(const mesh::TetMesh& mesh, const Options& options)
    : tables_(&piece_tables()), canonical_(mesh), original_(mesh), options_(options), states_(mesh.tets.size()), edge_number_(canonical_.edges()),
      base_number_(canonical_.faces, -1), quad_number_(canonical_.faces, -1), plus_(mesh.vertices.size()), edges_(canonical_.edges()),
      faces_(canonical_.faces), loose_(4 * mesh.tets.size()) {
    require_valid_tau(options.tau);
    if (canonical_.tets() >= scan_below) {
        boxes_ = TetBoxes(canonical_);
        found_ = SparseBits(mesh.tets.size());
    }
    counts_.uncut = canonical_.tets();
}

Counts SubdivisionEngine::cut(const Cut& cut) {
    const Cut valid = checked(cut);
    const SubdivisionPlane plane{{valid.normal[0], valid.normal[1], valid.normal[2]}, {valid.centre[0], valid.centre[1], valid.centre[2]}, options_.tau};
    const Counts before = counts_;
    first_parent_ = parents_.size();
    first_point_ = static_cast<int>(canonical_.vertices.size() + points_.size());
    find_parents(valid, plane);
    mark_points();
    number_points(plane);
    int centre = static_cast<int>(canonical_.vertices.size() + points_.size());
    points_.resize(points_.size() + static_cast<std::size_t>(counts_.two_two - before.two_two));
    for (std::size_t place = first_parent_; place < parents_.size(); ++place) {
        write_parent(plane, place, centre);
        centre += table(parents_[place]).children == 20 ? 1 : 0;
    }
    ++cuts_;
    return {counts_.uncut, counts_.three_one - before.three_one, counts_.two_two - before.two_two};
}

void SubdivisionEngine::reset() {
    for (const int tet : parents_) {
        const int base = table(tet).base_face;
        if (base >= 0) base_number_[canonical_.face[tet][base]] = -1;
        states_[tet].cut = -1;
    }
    loose_.drain([](std::size_t) {});
    parents_.clear();
    points_.clear();
    child_tets_.clear();
    child_links_.clear();
    child_centroids_.clear();
    child_volumes_.clear();
    child_parents_.clear();
    counts_ = {.uncut = canonical_.tets()};
    cuts_ = 0;
}

bool SubdivisionEngine::passes_disc(const Cut& cut, const SubdivisionPlane& plane, int tet) const {
    std::array<Eigen::Vector3d, 4> corners;
    std::array<double, 4> distances{};
    for (int i = 0; i < 4; ++i) {
        const Vector4& x = canonical_.vertices[canonical_.sorted[tet][i]];
        corners[i] = {x[0], x[1], x[2]};
        distances[i] = plane.raised(x);
    }
    return passes(cut, corners, distances);
}

void SubdivisionEngine::find_parents(const Cut& cut, const SubdivisionPlane& plane) {
    canonical_.tets() < scan_below ? scan_all(cut, plane) : scan_near(cut, plane);
}

void SubdivisionEngine::add_parent(int tet, unsigned plus_mask) {
    states_[tet] = {.cut = cuts_, .first_child = 0, .variant = static_cast<int>(2 * plus_mask) + canonical_.odd[tet]};
    parents_.push_back(tet);
}

void SubdivisionEngine::scan_all(const Cut& cut, const SubdivisionPlane& plane) {
    const bool disc = std::isfinite(cut.radius);
    for (std::size_t v = 0; v < plus_.size(); ++v) plus_[v] = plane.distance(canonical_.vertices[v]) >= 0 ? 1 : 0;
    const std::uint8_t* plus = plus_.data();
    const std::array<int, 4>* sorted = canonical_.sorted.data();
    for (int tet = 0, tets = canonical_.tets(); tet < tets; ++tet) {
        const auto& [a, b, c, d] = sorted[tet];
        const unsigned mask = plus[a] + 2U * plus[b] + 4U * plus[c] + 8U * plus[d];
        if (mask - 1U >= 14U) continue;  // 0 and 15: all on one side
        if (states_[tet].cut >= 0 || (disc && !passes_disc(cut, plane, tet))) continue;
        add_parent(tet, mask);
    }
}

/// Looks into the boxes at the cut; the set of finds puts them into ascending order.
void SubdivisionEngine::scan_near(const Cut& cut, const SubdivisionPlane& plane) {
    const bool disc = std::isfinite(cut.radius);
    const auto mask_of = [&](int tet) {
        unsigned mask = 0;
        for (unsigned i = 0; i < 4; ++i) mask |= (plane.distance(canonical_.vertices[canonical_.sorted[tet][i]]) >= 0 ? 1U : 0U) << i;
        return mask;
    };
    boxes_.near(cut, [&](int tet) {
        const unsigned mask = mask_of(tet);
        if (mask - 1U >= 14U) return;
        if (states_[tet].cut >= 0 || (disc && !passes_disc(cut, plane, tet))) return;
        states_[tet].variant = static_cast<int>(mask);
        found_.set(static_cast<std::size_t>(tet));
    });
    found_.drain([&](std::size_t tet) { add_parent(static_cast<int>(tet), static_cast<unsigned>(states_[tet].variant)); });
}

/// Gives parents their places among the children and marks the edges and faces that need a point.
void SubdivisionEngine::mark_points() {
    int children = static_cast<int>(child_tets_.size());
    for (std::size_t place = first_parent_; place < parents_.size(); ++place) {
        const int tet = parents_[place];
        const PieceTable& pieces = table(tet);
        states_[tet].first_child = children;
        children += pieces.children;
        --counts_.uncut;
        ++(pieces.base_face >= 0 ? counts_.three_one : counts_.two_two);
        for (int i = 0; i < pieces.cut_edge_count; ++i) edges_.set(canonical_.edge[tet][pieces.cut_edges[i]]);
        for (int f = 0; f < 4; ++f) {
            const int face = canonical_.face[tet][f];
            if (f == pieces.base_face && base_number_[face] >= 0) continue;
            (f == pieces.base_face ? base_number_ : quad_number_)[face] = marked;
            faces_.set(face);
        }
    }
    child_tets_.resize(children);
    child_links_.resize(children);
    child_centroids_.resize(children);
    child_volumes_.resize(children);
    child_parents_.resize(children);
}

/// Numbers the marked points in the order of their edges and faces, and writes those on edges.
void SubdivisionEngine::number_points(const SubdivisionPlane& plane) {
    int number = first_point_;
    edges_.drain([&](std::size_t edge) {
        const auto& [a, b] = canonical_.edge_ends[edge];
        const Vector4 &xa = canonical_.vertices[a], &xb = canonical_.vertices[b];
        const double da = plane.raised(xa), db = plane.raised(xb);
        const Vector4 x = xa + da / (da - db) * (xb - xa);
        points_.resize(points_.size() + 1);
        store(points_[points_.size() - 1], x);
        edge_number_[edge] = number++;
    });
    const int first_face_point = number;
    faces_.drain([&](std::size_t face) { (base_number_[face] == marked ? base_number_ : quad_number_)[face] = number++; });
    points_.resize(points_.size() + static_cast<std::size_t>(number - first_face_point));
}

void SubdivisionEngine::set_point(int number, const Vector4& x) {
    store(points_[static_cast<std::size_t>(number) - canonical_.vertices.size()], x);
}

/// One of the two tets at a face writes its point: the only one of this cut, or the first.
bool SubdivisionEngine::writes_face_point(int tet, int face) const {
    const int behind = canonical_.opposite[tet][face];
    return behind < 0 || states_[behind / 4].cut != cuts_ || tet < behind / 4;
}

void SubdivisionEngine::write_parent(const SubdivisionPlane& plane, std::size_t place, int centre) {
    const int tet = parents_[place];
    const PieceTable& pieces = table(tet);
    std::array<Vector4, 15> corners;
    std::array<int, 60> numbers;  // four places a point, like the corners
    for (int i = 0; i < 4; ++i) {
        numbers[4 * i] = canonical_.sorted[tet][i];
        corners[i] = canonical_.vertices[numbers[4 * i]];
    }
    const Vector4 distances = raised(plane, corners.data());
    for (int k = 0; k < pieces.cut_edge_count; ++k) {
        const int e = pieces.cut_edges[k];
        const auto& [i, j] = edge_ends[e];
        corners[first_edge_code + e] = corners[i] + distances[i] / (distances[i] - distances[j]) * (corners[j] - corners[i]);
        numbers[4 * (first_edge_code + e)] = edge_number_[canonical_.edge[tet][e]];
    }
    for (int f = 0; f < 4; ++f) {
        const int face = canonical_.face[tet][f];
        Vector4& x = corners[first_face_code + f];
        if (f == pieces.base_face) {
            x = ((corners[f == 0 ? 1 : 0] + corners[f <= 1 ? 2 : 1]) + corners[f <= 2 ? 3 : 2]) / 3;
        } else {
            const auto& quad = pieces.quads[f];
            x = ((corners[quad[0]] + corners[quad[1]]) + (corners[quad[2]] + corners[quad[3]])) / 4;
        }
        const int number = (f == pieces.base_face ? base_number_ : quad_number_)[face];
        numbers[4 * (first_face_code + f)] = number;
        if (number >= first_point_ && writes_face_point(tet, f)) set_point(number, x);
    }
    if (pieces.base_face < 0) {
        const auto ring = [&](int k) { return corners[first_edge_code + pieces.cut_edges[k]]; };
        corners[centre_code] = (((ring(0) + ring(1)) + ring(2)) + ring(3)) / 4;
        numbers[4 * centre_code] = centre;
        set_point(centre, corners[centre_code]);
    }
    write_children(pieces, tet, reinterpret_cast<const double*>(corners.data()), numbers.data());
    for (int f = 0; f < 4; ++f) link_face(pieces, tet, f);
}

/// `corners` and `numbers`: of all 15 points, four places a point.
void SubdivisionEngine::write_children(const PieceTable& pieces, int tet, const double* corners, const int* numbers) {
    const std::size_t first = static_cast<std::size_t>(states_[tet].first_child);
    const int first_half_face = 4 * (canonical_.tets() + states_[tet].first_child);
    // Plain pointers: the compiler need not reload the buffers' addresses after each store.
    std::array<int, 4>*__restrict tets = child_tets_.data() + first, *__restrict links = child_links_.data() + first;
    std::array<double, 3>* __restrict centroids = child_centroids_.data() + first;
    double* __restrict volumes = child_volumes_.data() + first;
    int* __restrict parents = child_parents_.data() + first;
    for (int k = 0, count = pieces.children; k < count; ++k) {
        const auto& [i, j, l, m] = pieces.offsets[k];
        const auto point = [corners](std::uint8_t offset) { return *reinterpret_cast<const Vector4*>(corners + offset); };
        const Vector4 a = point(i), b = point(j), c = point(l), d = point(m);
        store(centroids[k], 0.25 * (((a + b) + c) + d));
        volumes[k] = volume(a, b, c, d);
        const Int4 vertices{numbers[i], numbers[j], numbers[l], numbers[m]};
        std::memcpy(tets[k].data(), &vertices, sizeof vertices);
        Int4 inner;
        std::memcpy(&inner, pieces.inner[k].data(), sizeof inner);
        inner = (inner + first_half_face) | (inner >> 31);  // -1 stays -1
        std::memcpy(links[k].data(), &inner, sizeof inner);
        parents[k] = tet;
    }
}

int SubdivisionEngine::child_half_face(int tet, std::uint8_t relative) const {
    return 4 * (canonical_.tets() + states_[tet].first_child) + relative;
}

/// The smaller of the two original half faces at a face (in the original numbering of faces).
int SubdivisionEngine::half_face_key(int tet, int face) const {
    const int here = 4 * tet + canonical_.position[tet][face];
    const int behind = canonical_.opposite[tet][face];
    return std::min(here, 4 * (behind / 4) + canonical_.position[behind / 4][behind % 4]);
}

/// Links the pieces of a face to those behind it, where they are the same; else notes the face as loose.
void SubdivisionEngine::link_face(const PieceTable& pieces, int tet, int face) {
    const int behind = canonical_.opposite[tet][face];
    if (behind < 0) return;
    const int other = behind / 4, other_face = behind % 4;
    const State& there = states_[other];
    const bool earlier = there.cut != cuts_;
    if (there.cut < 0) {
        loose_.set(half_face_key(tet, face));
        return;
    }
    const PieceTable& other_pieces = table(other);
    if (earlier && (face != pieces.base_face || other_face != other_pieces.base_face)) {
        loose_.set(half_face_key(tet, face));
        return;
    }
    const FacePieces &here = pieces.pieces[face], &mirror = other_pieces.pieces[other_face];
    int* links = child_links_.data()->data();
    const int first = 4 * states_[tet].first_child, other_first = 4 * there.first_child, children = 4 * canonical_.tets();
    for (int k = 0; k < here.count; ++k) links[first + here.half_face[k]] = children + other_first + mirror.half_face[k];
    if (!earlier) return;
    // The other side was written at an earlier cut, when this tet was whole.
    for (int k = 0; k < here.count; ++k) links[other_first + mirror.half_face[k]] = children + first + here.half_face[k];
    loose_.reset(half_face_key(tet, face));
}

}  // namespace cleave::subdivision
