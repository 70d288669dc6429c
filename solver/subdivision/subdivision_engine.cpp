#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cleave::subdivision {
namespace {

using Int4 __attribute__((vector_size(16))) = int;

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

void store(std::array<double, 3>& out, const Vector4& x) { std::memcpy(out.data(), &x, sizeof out); }

constexpr int marked = -2;  ///< a barycentre that is wanted and has no number yet

}  // namespace

SubdivisionEngine::SubdivisionEngine(const mesh::TetMesh& mesh, const Options& options)
    : canonical_(mesh), original_(mesh), options_(options), states_(mesh.tets.size()), edge_number_(canonical_.edges()),
      base_number_(canonical_.faces, -1), quad_number_(canonical_.faces, -1), plus_(mesh.vertices.size()), edges_(canonical_.edges()),
      faces_(canonical_.faces), loose_(4 * mesh.tets.size()) {
    require_valid_tau(options.tau);
    counts_.uncut = canonical_.tets();
}

Counts SubdivisionEngine::cut(const Cut& cut) {
    const Cut valid = checked(cut);
    const Plane plane{{valid.normal[0], valid.normal[1], valid.normal[2]}, {valid.centre[0], valid.centre[1], valid.centre[2]}, options_.tau};
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

bool SubdivisionEngine::passes_disc(const Cut& cut, const Plane& plane, int tet) const {
    std::array<Eigen::Vector3d, 4> corners;
    std::array<double, 4> distances{};
    for (int i = 0; i < 4; ++i) {
        const Vector4& x = canonical_.vertices[canonical_.sorted[tet][i]];
        corners[i] = {x[0], x[1], x[2]};
        distances[i] = plane.raised(x);
    }
    return passes(cut, corners, distances);
}

void SubdivisionEngine::find_parents(const Cut& cut, const Plane& plane) {
    const bool disc = std::isfinite(cut.radius);
    for (std::size_t v = 0; v < plus_.size(); ++v) plus_[v] = plane.distance(canonical_.vertices[v]) >= 0 ? 1 : 0;
    for (int tet = 0; tet < canonical_.tets(); ++tet) {
        const auto& [a, b, c, d] = canonical_.sorted[tet];
        const int mask = plus_[a] + 2 * plus_[b] + 4 * plus_[c] + 8 * plus_[d];
        if (mask == 0 || mask == 15 || states_[tet].cut >= 0) continue;
        if (disc && !passes_disc(cut, plane, tet)) continue;
        states_[tet] = {.cut = cuts_, .first_child = 0, .variant = 2 * mask + canonical_.odd[tet]};
        parents_.push_back(tet);
    }
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
void SubdivisionEngine::number_points(const Plane& plane) {
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

void SubdivisionEngine::write_parent(const Plane& plane, std::size_t place, int centre) {
    const int tet = parents_[place];
    const PieceTable& pieces = table(tet);
    std::array<Vector4, 15> corners;
    std::array<int, 15> numbers;
    std::array<double, 4> distances;
    for (int i = 0; i < 4; ++i) {
        numbers[i] = canonical_.sorted[tet][i];
        corners[i] = canonical_.vertices[numbers[i]];
        distances[i] = plane.raised(corners[i]);
    }
    for (int k = 0; k < pieces.cut_edge_count; ++k) {
        const int e = pieces.cut_edges[k];
        const auto& [i, j] = edge_ends[e];
        corners[first_edge_code + e] = corners[i] + distances[i] / (distances[i] - distances[j]) * (corners[j] - corners[i]);
        numbers[first_edge_code + e] = edge_number_[canonical_.edge[tet][e]];
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
        numbers[first_face_code + f] = number;
        if (number >= first_point_ && writes_face_point(tet, f)) set_point(number, x);
    }
    if (pieces.base_face < 0) {
        const auto ring = [&](int k) { return corners[first_edge_code + pieces.cut_edges[k]]; };
        corners[centre_code] = (((ring(0) + ring(1)) + ring(2)) + ring(3)) / 4;
        numbers[centre_code] = centre;
        set_point(centre, corners[centre_code]);
    }
    write_children(pieces, tet, corners.data(), numbers.data());
    for (int f = 0; f < 4; ++f) link_face(pieces, tet, f);
}

void SubdivisionEngine::write_children(const PieceTable& pieces, int tet, const Vector4* corners, const int* numbers) {
    const std::size_t first = states_[tet].first_child;
    const int first_half_face = 4 * (canonical_.tets() + states_[tet].first_child);
    for (int k = 0; k < pieces.children; ++k) {
        const auto& codes = pieces.codes[k];
        const Vector4 &a = corners[codes[0]], &b = corners[codes[1]], &c = corners[codes[2]], &d = corners[codes[3]];
        store(child_centroids_[first + k], 0.25 * (((a + b) + c) + d));
        child_volumes_[first + k] = volume(a, b, c, d);
        child_tets_[first + k] = {numbers[codes[0]], numbers[codes[1]], numbers[codes[2]], numbers[codes[3]]};
        Int4 inner;
        std::memcpy(&inner, pieces.inner[k].data(), sizeof inner);
        const Int4 links = (inner + first_half_face) | (inner >> 31);  // -1 stays -1
        std::memcpy(child_links_[first + k].data(), &links, sizeof links);
        child_parents_[first + k] = tet;
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
    const std::size_t first = states_[tet].first_child;
    for (int k = 0; k < here.count; ++k) {
        const int relative = here.half_face[k];
        child_links_[first + relative / 4][relative % 4] = child_half_face(other, mirror.half_face[k]);
    }
    if (!earlier) return;
    // The other side was written at an earlier cut, when this tet was whole.
    for (int k = 0; k < here.count; ++k) {
        const int relative = mirror.half_face[k];
        child_links_[static_cast<std::size_t>(there.first_child + relative / 4)][relative % 4] = child_half_face(tet, here.half_face[k]);
    }
    loose_.reset(half_face_key(tet, face));
}

}  // namespace cleave::subdivision
