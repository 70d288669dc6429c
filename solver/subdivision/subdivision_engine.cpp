#include "solver/subdivision/subdivision_engine.hpp"

#include <immintrin.h>

#include <algorithm>
#include <atomic>
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

/// Four vertices turned over: their x, their y, their z, their shortest edges.
struct FourVertices {
    Vector4 x, y, z, edge;
    FourVertices(const Vector4& a, const Vector4& b, const Vector4& c, const Vector4& d) {
        const Vector4 ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_ye = __builtin_shufflevector(a, b, 1, 5, 3, 7);
        const Vector4 cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_ye = __builtin_shufflevector(c, d, 1, 5, 3, 7);
        x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5);
        z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7);
        y = __builtin_shufflevector(ab_ye, cd_ye, 0, 1, 4, 5);
        edge = __builtin_shufflevector(ab_ye, cd_ye, 2, 3, 6, 7);
    }
    /// SubdivisionPlane::distance of each.
    Vector4 distances(const SubdivisionPlane& plane) const {
        return (plane.normal[0] * (x - plane.centre[0]) + plane.normal[1] * (y - plane.centre[1])) +
               plane.normal[2] * (z - plane.centre[2]);
    }
    /// SubdivisionPlane::raised of each.
    Vector4 raised(const SubdivisionPlane& plane) const {
        const Vector4 d = distances(plane), least = plane.tau * edge;
        const Vector4 size = d >= 0 ? d : -d;
        const Vector4 up = size > least ? size : least;
        return d >= 0 ? up : -up;
    }
};

/// Bit i is set where lane i is at least 0 (and not NaN).
unsigned plus_mask(const Vector4& distances) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(distances, _mm256_setzero_pd(), _CMP_GE_OQ)));
}

void fetch_record(const CanonicalMesh::Record& record) {
    __builtin_prefetch(&record);
    __builtin_prefetch(&record.odd);
}

constexpr int scan_below = 20'000;  ///< tets: smaller meshes are scanned faster than searched
constexpr std::size_t chunk_size = 256;  ///< parents, edges or boxes that one thread takes at a time
constexpr std::size_t together_from = 8 * chunk_size;  ///< parents: fewer are not worth waking threads

std::size_t chunks_of(std::size_t count) { return (count + chunk_size - 1) / chunk_size; }

}  // namespace

SubdivisionEngine::SubdivisionEngine(const mesh::TetMesh& mesh, const Options& options)
    : tables_(piece_tables().data()), canonical_(mesh), original_(mesh), options_(options), states_(mesh.tets.size()),
      base_number_(canonical_.faces, -1), edges_(canonical_.edges()),
      faces_(canonical_.faces), workers_(options.threads) {
    require_valid_tau(options.tau);
    if (canonical_.tets() >= scan_below) {
        boxes_ = TetBoxes(canonical_);
        found_ = SparseBits(mesh.tets.size());
    } else {
        plus_.resize(mesh.vertices.size());
        for (const CanonicalMesh::Record& record : canonical_.records) scanned_.push_back(record.sorted);
    }
    counts_.uncut = canonical_.tets();
}

void SubdivisionEngine::reset() {
    for (const int tet : parents_) {
        const int base = states_[tet].pieces->base_face;
        if (base >= 0) base_number_[canonical_.records[tet].face[base]] = -1;
        states_[tet].cut = -1;
    }
    parents_.clear();
    loose_.clear();
    points_.clear();
    child_tets_.clear();
    child_links_.clear();
    child_centroids_.clear();
    child_volumes_.clear();
    child_parents_.clear();
    counts_ = {.uncut = canonical_.tets()};
    cuts_ = 0;
    first_parent_ = 0;
    first_new_child_ = 0;
}

bool SubdivisionEngine::passes_disc(const Cut& cut, const SubdivisionPlane& plane, int tet) const {
    std::array<Eigen::Vector3d, 4> corners;
    std::array<double, 4> distances{};
    for (int i = 0; i < 4; ++i) {
        const Vector4& x = canonical_.vertices[canonical_.records[tet].sorted[i]];
        corners[i] = {x[0], x[1], x[2]};
        distances[i] = plane.raised(x);
    }
    return passes(cut, corners, distances);
}

void SubdivisionEngine::find_parents(const Cut& cut, const SubdivisionPlane& plane, const Among& among) {
    canonical_.tets() < scan_below ? scan_all(cut, plane, among) : scan_near(cut, plane, among);
}

void SubdivisionEngine::add_parent(int tet, unsigned plus_mask) {
    states_[tet] = {.pieces = &tables_[2 * plus_mask + canonical_.records[tet].odd], .cut = cuts_, .first_child = 0};
    parents_.push_back(tet);
}

void SubdivisionEngine::scan_all(const Cut& cut, const SubdivisionPlane& plane, const Among& among) {
    const bool disc = std::isfinite(cut.radius);
    for (std::size_t v = 0; v < plus_.size(); ++v) plus_[v] = plane.distance(canonical_.vertices[v]) >= 0 ? 1 : 0;
    const std::uint8_t* plus = plus_.data();
    for (int tet = 0, tets = canonical_.tets(); tet < tets; ++tet) {
        const auto& [a, b, c, d] = scanned_[tet];
        const unsigned mask = plus[a] + 2U * plus[b] + 4U * plus[c] + 8U * plus[d];
        if (mask - 1U >= 14U) continue;  // 0 and 15: all on one side
        if (states_[tet].cut >= 0 || !among.has(tet) || (disc && !passes_disc(cut, plane, tet))) continue;
        add_parent(tet, mask);
    }
}

/// Whether the cut divides a tet of a box near it; if so, notes how.
inline bool SubdivisionEngine::test_near(const Cut& cut, const SubdivisionPlane& plane, const Among& among, int tet,
                                         const std::array<int, 4>& corners) {
    const Vector4* x = canonical_.vertices.data();
    const unsigned mask = plus_mask(FourVertices(x[corners[0]], x[corners[1]], x[corners[2]], x[corners[3]]).distances(plane));
    if (mask - 1U >= 14U) return false;
    if (states_[tet].cut >= 0 || !among.has(tet) || (std::isfinite(cut.radius) && !passes_disc(cut, plane, tet))) return false;
    states_[tet].pieces = &tables_[2 * mask + canonical_.records[tet].odd];
    return true;
}

/// Looks into the boxes at the cut; the set of finds puts them into ascending order.
void SubdivisionEngine::scan_near(const Cut& cut, const SubdivisionPlane& plane, const Among& among) {
    if (workers_.alone()) {
        boxes_.near(cut, [&](int tet, const std::array<int, 4>& corners) {
            if (test_near(cut, plane, among, tet, corners)) found_.set(static_cast<std::size_t>(tet));
        });
    } else {
        find_near_together(cut, plane, among);
    }
    found_.drain([&](std::size_t tet) {
        states_[tet].cut = cuts_;
        parents_.push_back(static_cast<int>(tet));
    });
}

void SubdivisionEngine::find_near_together(const Cut& cut, const SubdivisionPlane& plane, const Among& among) {
    constexpr std::size_t boxes_a_chunk = 64;
    std::vector<std::size_t> boxes;
    boxes_.near_boxes(cut, [&](std::size_t box) { boxes.push_back(box); });
    const std::size_t chunks = (boxes.size() + boxes_a_chunk - 1) / boxes_a_chunk;
    std::vector<std::vector<int>> finds(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        for (std::size_t i = chunk * boxes_a_chunk; i < std::min(boxes.size(), (chunk + 1) * boxes_a_chunk); ++i) {
            boxes_.visit_box(boxes[i], [&](int tet, const std::array<int, 4>& corners) {
                if (test_near(cut, plane, among, tet, corners)) finds[chunk].push_back(tet);
            });
        }
    });
    for (const std::vector<int>& found : finds) {
        for (const int tet : found) found_.set(static_cast<std::size_t>(tet));
    }
}

template <int cuts>
void SubdivisionEngine::mark_parent(const PieceTable& pieces, int tet) {
    const CanonicalMesh::Record& record = canonical_.records[tet];
    for (int k = 0; k < cuts; ++k) edges_.set(record.edge[pieces.cut_edges[k]]);
    for (int k = 0; k < cuts; ++k) {
        faces_.set(record.face[pieces.cut_faces[k]]);
    }
    if constexpr (cuts == 3) {
        const int face = record.face[pieces.base_face];
        if (base_number_[face] < 0) faces_.set(face);
    }
}

/// Gives parents their places among the children and marks the edges and faces that need a point.
void SubdivisionEngine::mark_points() {
    constexpr std::size_t ahead = 12;
    int children = static_cast<int>(child_tets_.size());
    const int two_two_before = counts_.two_two;
    chunk_centres_.clear();
    for (std::size_t place = first_parent_; place < parents_.size(); ++place) {
        if ((place - first_parent_) % chunk_size == 0) chunk_centres_.push_back(counts_.two_two - two_two_before);
        if (place + ahead < parents_.size()) fetch_record(canonical_.records[parents_[place + ahead]]);
        const int tet = parents_[place];
        const PieceTable& pieces = *states_[tet].pieces;
        states_[tet].first_child = children;
        children += pieces.children;
        --counts_.uncut;
        ++(pieces.base_face >= 0 ? counts_.three_one : counts_.two_two);
        pieces.base_face >= 0 ? mark_parent<3>(pieces, tet) : mark_parent<4>(pieces, tet);
    }
    child_tets_.resize(children);
    child_links_.resize(children);
    child_centroids_.resize(children);
    child_volumes_.resize(children);
    child_parents_.resize(children);
}

/// Numbers the marked points in the order of their edges and faces, and writes those on edges.
void SubdivisionEngine::number_points(const SubdivisionPlane& plane, int centres) {
    const int originals = static_cast<int>(canonical_.vertices.size());
    first_edge_point_ = originals + static_cast<int>(points_.size());
    first_face_point_ = first_edge_point_ + edges_.rank_all();
    first_centre_ = first_face_point_ + faces_.rank_all();
    points_.resize(static_cast<std::size_t>(first_centre_ + centres - originals));
    cut_edges_.clear();
    edges_.for_each([&](std::size_t edge) { cut_edges_.push_back(static_cast<int>(edge)); });
    const std::size_t count = cut_edges_.size();
    if (count < together_from) {
        write_edge_points(plane, 0, count);
    } else {
        workers_.for_chunks(chunks_of(count), [&](std::size_t chunk) {
            write_edge_points(plane, chunk * chunk_size, std::min(count, (chunk + 1) * chunk_size));
        });
    }
}

void SubdivisionEngine::write_edge_points(const SubdivisionPlane& plane, std::size_t first, std::size_t last) {
    std::array<double, 3>* points = points_.data() + (first_edge_point_ - static_cast<int>(canonical_.vertices.size()));
    for (std::size_t i = first; i < last; ++i) {
        if (i + 16 < last) __builtin_prefetch(&canonical_.edge_ends[cut_edges_[i + 16]]);
        if (i + 8 < last) {
            for (const int v : canonical_.edge_ends[cut_edges_[i + 8]]) __builtin_prefetch(&canonical_.vertices[v]);
        }
        const auto& [a, b] = canonical_.edge_ends[cut_edges_[i]];
        const Vector4 &xa = canonical_.vertices[a], &xb = canonical_.vertices[b];
        const double da = plane.raised(xa), db = plane.raised(xb);
        store(points[i], xa + da / (da - db) * (xb - xa));
    }
}

/// Asks the memory for what the parents a little further on will need: at millions of tets each is a miss.
void SubdivisionEngine::fetch_ahead(std::size_t place) const {
    constexpr std::size_t far = 8, near = 4;
    if (place + far < parents_.size()) fetch_record(canonical_.records[parents_[place + far]]);
    if (place + near >= parents_.size()) return;
    const int tet = parents_[place + near];
    const CanonicalMesh::Record& record = canonical_.records[tet];
    for (int i = 0; i < 4; ++i) {
        __builtin_prefetch(&canonical_.vertices[record.sorted[i]]);
        if (record.opposite[i] >= 0) __builtin_prefetch(&states_[record.opposite[i] / 4]);
    }
    const int base = states_[tet].pieces->base_face;
    if (base >= 0) __builtin_prefetch(&base_number_[record.face[base]], 1);
}

/// Links the pieces of a face to those behind it, where they are the same; else notes the face as loose.
inline void SubdivisionEngine::link_face(const State& here, int tet, int face, Buffer<int>& loose) {
    const int behind = canonical_.records[tet].opposite[face];
    if (behind < 0) return;
    const State& there = states_[behind / 4];
    if (there.cut != cuts_) {
        link_face_across_cuts(here, tet, face, loose);
        return;
    }
    const FacePieces &pieces = here.pieces->pieces[face], &mirror = there.pieces->pieces[behind % 4];
    int* links = (child_links_.data() + here.first_child)->data();
    const int other = 4 * (canonical_.tets() + there.first_child);
    for (int k = 0; k < 3; ++k) links[pieces.half_face[k]] = other + mirror.half_face[k];
    if (face == here.pieces->base_face) return;
    for (int k = 3; k < 5; ++k) links[pieces.half_face[k]] = other + mirror.half_face[k];
}

/// The tet behind is whole or was cut before: only two bases conform.
void SubdivisionEngine::link_face_across_cuts(const State& here, int tet, int face, Buffer<int>& loose) {
    const int behind = canonical_.records[tet].opposite[face];
    const State& there = states_[behind / 4];
    if (there.cut < 0 || face != here.pieces->base_face || behind % 4 != there.pieces->base_face) {
        loose.push_back(4 * tet + face);
        return;
    }
    // The other side was written when this tet was whole.
    const FacePieces &pieces = here.pieces->pieces[face], &mirror = there.pieces->pieces[behind % 4];
    for (int k = 0; k < 3; ++k) {
        const int half_face = pieces.half_face[k], other = mirror.half_face[k];
        child_links_[here.first_child + half_face / 4][half_face % 4] = child_half_face(behind / 4, other);
        child_links_[there.first_child + other / 4][other % 4] = child_half_face(tet, half_face);
    }
}

/// Writes a face's point. Of two tets of this cut at the face the one with the smaller number does; the other writes the same
/// bits beside the array (a choice of address, because a branch on it cannot be foretold).
void SubdivisionEngine::set_face_point(int tet, int face, int number, const Vector4& x) {
    const int behind = canonical_.records[tet].opposite[face];
    const int other = behind < 0 ? tet : behind / 4;
    const bool writes = (behind < 0) | (states_[other].cut != cuts_) | (tet < other);
    std::array<double, 3> unused;
    store(writes ? points_[static_cast<std::size_t>(number) - canonical_.vertices.size()] : unused, x);
}

template <int cuts>
void SubdivisionEngine::write_parent(const SubdivisionPlane& plane, int tet, int centre, Buffer<int>& loose) {
    const PieceTable& pieces = *states_[tet].pieces;
    const CanonicalMesh::Record& record = canonical_.records[tet];
    std::array<Vector4, 15> corners;
    std::array<int, 60> numbers;  // four places a point, like the corners
    for (int i = 0; i < 4; ++i) {
        numbers[4 * i] = record.sorted[i];
        corners[i] = canonical_.vertices[record.sorted[i]];
    }
    const Vector4 distances = FourVertices(corners[0], corners[1], corners[2], corners[3]).raised(plane);
    for (int k = 0; k < cuts; ++k) {
        const int e = pieces.cut_edges[k];
        const auto& [i, j] = edge_ends[e];
        corners[first_edge_code + e] = corners[i] + distances[i] / (distances[i] - distances[j]) * (corners[j] - corners[i]);
        numbers[4 * (first_edge_code + e)] = first_edge_point_ + edges_.rank(record.edge[e]);
    }
    for (int k = 0; k < cuts; ++k) {
        const int f = pieces.cut_faces[k];
        const auto& quad = pieces.quads[f];
        const Vector4 x = ((corners[quad[0]] + corners[quad[1]]) + (corners[quad[2]] + corners[quad[3]])) / 4;
        const int number = first_face_point_ + faces_.rank(record.face[f]);
        corners[first_face_code + f] = x;
        numbers[4 * (first_face_code + f)] = number;
        set_face_point(tet, f, number, x);
    }
    if constexpr (cuts == 3) {
        const int f = pieces.base_face;
        const Vector4 x = ((corners[f == 0 ? 1 : 0] + corners[f <= 1 ? 2 : 1]) + corners[f <= 2 ? 3 : 2]) / 3;
        // Two tets of this cut may share a base and write the same number at the same time.
        const std::atomic_ref<int> shared(base_number_[record.face[f]]);
        int number = shared.load(std::memory_order_relaxed);
        if (number < 0) shared.store(number = first_face_point_ + faces_.rank(record.face[f]), std::memory_order_relaxed);
        corners[first_face_code + f] = x;
        numbers[4 * (first_face_code + f)] = number;
        if (number >= first_face_point_) set_face_point(tet, f, number, x);
    } else {
        const auto ring = [&](int k) { return corners[first_edge_code + pieces.cut_edges[k]]; };
        corners[centre_code] = (((ring(0) + ring(1)) + ring(2)) + ring(3)) / 4;
        numbers[4 * centre_code] = centre;
        store(points_[static_cast<std::size_t>(centre) - canonical_.vertices.size()], corners[centre_code]);
    }
    write_children<cuts == 3 ? 14 : 20>(pieces, tet, reinterpret_cast<const double*>(corners.data()), numbers.data());
    for (int f = 0; f < 4; ++f) link_face(states_[tet], tet, f, loose);
}

/// `corners` and `numbers`: of all 15 points, four places a point.
template <int count>
void SubdivisionEngine::write_children(const PieceTable& pieces, int tet, const double* corners, const int* numbers) {
    const std::size_t first = static_cast<std::size_t>(states_[tet].first_child);
    const int first_half_face = 4 * (canonical_.tets() + states_[tet].first_child);
    // Plain pointers: the compiler need not reload the buffers' addresses after each store.
    std::array<int, 4>*__restrict tets = child_tets_.data() + first, *__restrict links = child_links_.data() + first;
    std::array<double, 3>* __restrict centroids = child_centroids_.data() + first;
    double* __restrict volumes = child_volumes_.data() + first;
    int* __restrict parents = child_parents_.data() + first;
    for (int k = 0; k < count; ++k) {
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

void SubdivisionEngine::write_all_parents(const SubdivisionPlane& plane) {
    const std::size_t count = parents_.size() - first_parent_, chunks = chunks_of(count);
    if (workers_.alone() || count < together_from) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) write_parents(plane, chunk, loose_);
        return;
    }
    if (chunk_loose_.size() < chunks) chunk_loose_ = std::vector<Buffer<int>>(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        chunk_loose_[chunk].clear();
        write_parents(plane, chunk, chunk_loose_[chunk]);
    });
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        for (const int face : chunk_loose_[chunk]) loose_.push_back(face);
    }
}

void SubdivisionEngine::write_parents(const SubdivisionPlane& plane, std::size_t chunk, Buffer<int>& loose) {
    int centre = first_centre_ + chunk_centres_[chunk];
    const std::size_t first = first_parent_ + chunk * chunk_size;
    for (std::size_t place = first; place < std::min(parents_.size(), first + chunk_size); ++place) {
        fetch_ahead(place);
        const int tet = parents_[place];
        states_[tet].pieces->base_face >= 0 ? write_parent<3>(plane, tet, -1, loose) : write_parent<4>(plane, tet, centre++, loose);
    }
}

Counts SubdivisionEngine::cut(const Cut& cut, const Among& among) {
    const Cut valid = checked(cut);
    const SubdivisionPlane plane{{valid.normal[0], valid.normal[1], valid.normal[2]},
                                 {valid.centre[0], valid.centre[1], valid.centre[2]}, options_.tau};
    const Counts before = counts_;
    first_parent_ = parents_.size();
    first_new_child_ = static_cast<int>(child_tets_.size());
    find_parents(valid, plane, among);
    mark_points();
    number_points(plane, counts_.two_two - before.two_two);
    write_all_parents(plane);
    edges_.clear();
    faces_.clear();
    ++cuts_;
    return {counts_.uncut, counts_.three_one - before.three_one, counts_.two_two - before.two_two};
}

}  // namespace cleave::subdivision
