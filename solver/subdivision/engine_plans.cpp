#include "solver/subdivision/subdivision_engine.hpp"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>

// Planning: the numbers of a parent's points and its links, in the order of the parents, once all have their places among the children. A
// point belongs to the first parent that has it; the later ones find its number at the edge or with the parent behind the face.

namespace cleave::subdivision {
namespace {

constexpr std::size_t chunk_size = 256;                ///< parents that one thread takes at a time
constexpr std::size_t together_from = 8 * chunk_size;  ///< parents: fewer are not worth waking threads
constexpr std::size_t alone_at_a_time = 32;            ///< parents: their plans stay in the first-level cache

/// Four ints in a register.
__m128i load_four(const std::array<int, 4>& values) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(values.data())); }
void store_four(std::array<int, 4>& values, __m128i four) { _mm_storeu_si128(reinterpret_cast<__m128i*>(values.data()), four); }
__m128i shuffled(__m128i four, const std::array<std::uint8_t, 16>& bytes) {
    return _mm_shuffle_epi8(four, _mm_load_si128(reinterpret_cast<const __m128i*>(bytes.data())));
}
/// The lanes' signs as bits.
unsigned signs(__m128i four) { return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(four))); }

/// Numbers for the lanes of a set of bits: in lane k, how many lower lanes the set has.
constexpr auto lower_lanes = [] {
    std::array<std::array<int, 4>, 16> table{};
    for (unsigned set = 0; set < 16; ++set) {
        for (unsigned k = 0; k < 4; ++k) table[set][k] = std::popcount(set & ((1U << k) - 1));
    }
    return table;
}();

}  // namespace

/// Two bases conform even where they were cut one after the other: takes the number of the earlier one's barycentre, the one point that
/// the child below its lone tet has beside the cut points, and links both.
void SubdivisionEngine::join_earlier_base(const State& there, ParentPlan& plan) {
    const ChildPattern& earlier = *layouts_[there.layout].pattern;
    const ChildPattern& own = *layouts_[plan.layout].pattern;
    const auto child = static_cast<std::size_t>(there.first_half_face / 4 - canonical_.tets());
    plan.face_point[3] = child_tets_[child + 1][static_cast<std::size_t>(earlier.barycentre)];
    plan.behind[3] = {there.first_half_face + earlier.base[1], there.first_half_face + earlier.base[0]};
    int* links = child_links_[child].data();
    for (int k = 0; k < 3; ++k) links[earlier.base[k]] = plan.first_half_face + own.base[k];
    plan.makes &= static_cast<std::uint16_t>(~(1U << 7));
}

/// What all parents of a cut share. A class of its own, so that it lives in registers: no store to a plan can change it.
struct SubdivisionEngine::Planner {
    int cut, first_point, next_point, next_half_face;
    int* edge_point;
    std::array<int, 4>* face_points;  ///< by place
    const ParentLayout* layouts;
    const FaceTables* faces;
    const State* states;              ///< per tet, and one before the first

    __m128i new_points(unsigned set);
    void number_cut_points(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan);
    void meet_neighbours(const ParentLayout& layout, const CanonicalMesh::Record& record, int place, ParentPlan& plan);
    bool is_earlier_base(int behind) const {
        const State& there = states[behind >> 2];
        return there.cut >= 0 && there.cut != cut && layouts[there.layout].base_face == (behind & 3);
    }
};

/// Numbers for new points among four.
inline __m128i SubdivisionEngine::Planner::new_points(unsigned set) {
    const __m128i numbers = _mm_add_epi32(_mm_set1_epi32(next_point), load_four(lower_lanes[set]));
    next_point += std::popcount(set);
    return numbers;
}

/// The numbers of cut points: known at the edge, or the next ones.
inline void SubdivisionEngine::Planner::number_cut_points(const ParentLayout& layout, const CanonicalMesh::Record& record,
                                                          ParentPlan& plan) {
    static_assert(offsetof(CanonicalMesh::Record, edge) + 32 <= sizeof(CanonicalMesh::Record));  // eight ints, the last two of them rubbish
    const __m256i lanes = _mm256_load_si256(reinterpret_cast<const __m256i*>(layout.edge_lanes.data()));
    const __m256i all_edges = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(record.edge.data()));
    const __m128i edges = _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(all_edges, lanes));
    const __m128i known = _mm_i32gather_epi32(edge_point, edges, 4), is_new = _mm_cmpgt_epi32(_mm_set1_epi32(first_point), known);
    const unsigned makes = signs(is_new) & layout.cut_edges;
    store_four(plan.cut_point, shuffled(_mm_blendv_epi8(known, new_points(makes), is_new), layout.cut_bytes));
    plan.makes = static_cast<std::uint16_t>(makes);
    for (int k = 0; k < 4; ++k) edge_point[record.edge[layout.own[k].edge]] = plan.cut_point[k];
}

/// The numbers of face points, and the links to parents of the same cut. Without branches, which could not be foretold.
inline void SubdivisionEngine::Planner::meet_neighbours(const ParentLayout& layout, const CanonicalMesh::Record& record, int place,
                                                        ParentPlan& plan) {
    std::array<int, 4> half_faces;
    const __m128i behind = shuffled(load_four(record.opposite), layout.face_bytes);
    store_four(half_faces, behind);
    const auto state_behind = [&](int k) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(&states[half_faces[k] >> 2])); };
    // Four states turned over.
    const __m128i a = state_behind(0), b = state_behind(1), c = state_behind(2), d = state_behind(3);
    const __m128i ab_low = _mm_unpacklo_epi32(a, b), ab_high = _mm_unpackhi_epi32(a, b);
    const __m128i cd_low = _mm_unpacklo_epi32(c, d), cd_high = _mm_unpackhi_epi32(c, d);
    const __m128i cuts = _mm_unpacklo_epi64(ab_low, cd_low), first_half_faces = _mm_unpackhi_epi64(ab_low, cd_low);
    const __m128i places = _mm_unpacklo_epi64(ab_high, cd_high), numbers = _mm_unpackhi_epi64(ab_high, cd_high);

    const __m128i linked = _mm_cmpeq_epi32(cuts, _mm_set1_epi32(cut));
    const __m128i earlier = _mm_and_si128(linked, _mm_cmpgt_epi32(_mm_set1_epi32(place), places));  // a later one has numbered nothing
    const __m128i other_face = _mm_or_si128(_mm_slli_epi32(numbers, 2), _mm_and_si128(behind, _mm_set1_epi32(3)));
    const unsigned makes = ~signs(earlier) & 15U;
    const __m128i places_there = _mm_i32gather_epi32(faces->place.data(), other_face, 4);
    const __m128i points_there = _mm_add_epi32(_mm_slli_epi32(places, 2), places_there);
    const __m128i points = _mm_mask_i32gather_epi32(new_points(makes), face_points->data(), points_there, earlier, 4);
    store_four(plan.face_point, points);
    store_four(face_points[place], points);

    const __m256i pairs = _mm256_setr_epi32(0, 0, 1, 1, 2, 2, 3, 3);
    const auto twice = [&](__m128i four) { return _mm256_permutevar8x32_epi32(_mm256_castsi128_si256(four), pairs); };
    const __m256i ends_there = _mm256_i32gather_epi64(reinterpret_cast<const long long*>(faces->ends.data()), other_face, 8);
    const __m256i ends = _mm256_add_epi32(ends_there, twice(first_half_faces)), none = _mm256_set1_epi32(LinkEnds::none().ring);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(plan.behind.data()), _mm256_blendv_epi8(none, ends, twice(linked)));
    plan.makes = static_cast<std::uint16_t>(plan.makes | makes << 4);
    plan.inner_faces = static_cast<std::uint8_t>(~signs(behind) & 15U);
}

SubdivisionEngine::Planner SubdivisionEngine::planner() {
    const int first_point = static_cast<int>(canonical_.vertices.size() + points_.size());
    const int first_half_face = 4 * (canonical_.tets() + first_new_child_);
    return {cuts_,    first_point,    first_point, first_half_face, edge_point_.data(), face_points_.data(),
            layouts_, &face_tables(), &states_[1]};
}

/// The parents that were found get their places, and the children room.
void SubdivisionEngine::place_parents() {
    const std::size_t count = found_.size();
    int* parents = parents_.grow_by(count);
    State* states = &states_[1];
    int first_half_face = 4 * (canonical_.tets() + first_new_child_), two_two = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int tet = parents[i] = static_cast<int>(found_[i] / 32);
        const unsigned number = found_[i] % 32;
        states[tet] = {cuts_, first_half_face, static_cast<int>(i) + 1, number};
        first_half_face += 4 * layouts_[number].children;
        two_two += layouts_[number].kind == ParentLayout::two_two;
    }
    counts_.uncut -= static_cast<int>(count);
    counts_.two_two += two_two;
    counts_.three_one += static_cast<int>(count) - two_two;
    const auto children = static_cast<std::size_t>(first_half_face / 4 - canonical_.tets());
    child_tets_.resize(children);
    child_links_.resize(children);
    child_centroids_.resize(children);
    child_volumes_.resize(children);
    child_parents_.resize(children);
    face_points_.resize(count + 1);
    // Room for the points of most cuts at once (a parent makes about 3.4): growing while parents are planned would copy them over and over.
    const std::size_t points = points_.size();
    points_.resize(points + 4 * count);
    points_.resize(points);
}

/// Plans the parents first .. last-1 of the cut, those before them having been planned.
void SubdivisionEngine::plan_parents(std::size_t first, std::size_t last, Planner& planner) {
    constexpr std::size_t far = 12, near = 6;
    Planner all = planner;
    const std::size_t count = found_.size();
    const std::uint64_t* found = found_.data();
    const CanonicalMesh::Record* records = canonical_.records.data();
    ParentPlan* plans = plans_.data() - first;
    for (std::size_t i = first; i < last; ++i) {
        if (i + far < count) __builtin_prefetch(&records[found[i + far] / 32]);
        if (i + near < count) {
            const CanonicalMesh::Record& record = records[found[i + near] / 32];
            // Edges of the same lower vertex stand together.
            for (const int edge : {0, 3, 5}) __builtin_prefetch(all.edge_point + record.edge[edge], 1);
            for (const int behind : record.opposite) __builtin_prefetch(&all.states[behind >> 2]);
        }
        const int tet = static_cast<int>(found[i] / 32);
        const unsigned number = found[i] % 32;
        const CanonicalMesh::Record& record = records[tet];
        const ParentLayout& layout = all.layouts[number];
        ParentPlan& plan = plans[i];
        store_four(plan.corner, shuffled(load_four(record.sorted), layout.role_bytes));
        plan.tet = tet;
        plan.layout = static_cast<std::uint8_t>(number);
        plan.first_half_face = all.next_half_face;
        all.next_half_face += 4 * layout.children;
        all.number_cut_points(layout, record, plan);
        all.meet_neighbours(layout, record, static_cast<int>(i) + 1, plan);
        const bool has_centre = layout.kind == ParentLayout::two_two;
        const int base = layout.own[3].face, behind = record.opposite[base];
        plan.behind_base = (behind & ~3) | record.position_behind(base);
        if (!has_centre && all.is_earlier_base(behind)) {
            join_earlier_base(all.states[behind >> 2], plan);
            --all.next_point;
        }
        plan.centre = all.next_point;
        all.next_point += has_centre;
    }
    points_.resize(static_cast<std::size_t>(all.next_point) - canonical_.vertices.size());
    planner = all;
}

/// The place of the point with number 0: before the first one that is kept.
std::array<double, 3>* SubdivisionEngine::points_from_zero() { return points_.data() - canonical_.vertices.size(); }

ChildArrays SubdivisionEngine::children_from(int child) {
    return {child_tets_.data() + child,    child_links_.data() + child,   child_centroids_.data() + child,
            child_volumes_.data() + child, child_parents_.data() + child, points_from_zero()};
}

/// Writes the children of these plans.
void SubdivisionEngine::write_parents(const ParentPlan* first, const ParentPlan* last, const CuttingPlane& plane,
                                      Buffer<LooseFace>& loose) {
    const int child = first->first_half_face / 4 - canonical_.tets();
    write_children(plane, first, last, layouts_, canonical_.vertices.data(), children_from(child), loose);
}

/// The same by way of a stream.
void SubdivisionEngine::stream_parents(const ParentPlan* first, const ParentPlan* last, const CuttingPlane& plane, StreamedChildren& out,
                                       Buffer<LooseFace>& loose) {
    constexpr std::ptrdiff_t most = StreamedChildren::parents_at_a_time;
    for (const ParentPlan* end; first != last; first = end) {
        end = first + std::min(last - first, most);
        out.pass_on(write_children(plane, first, end, layouts_, canonical_.vertices.data(), out.next(points_from_zero()), loose));
    }
}

/// Plans a few parents at a time and writes them.
void SubdivisionEngine::divide_alone(const CuttingPlane& plane) {
    const std::size_t count = found_.size();
    Planner planner = this->planner();
    plans_.resize(std::min(count, alone_at_a_time));
    std::optional<StreamedChildren> stream;
    if (streams(count)) stream.emplace(children_from(first_new_child_));
    for (std::size_t first = 0; first < count; first += alone_at_a_time) {
        const std::size_t last = std::min(count, first + alone_at_a_time);
        plan_parents(first, last, planner);
        const ParentPlan* plans = plans_.data();
        if (stream) stream_parents(plans, plans + (last - first), plane, *stream, loose_);
        else write_parents(plans, plans + (last - first), plane, loose_);
    }
    if (stream) stream->finish();
}

/// Plans all parents and shares out the writing.
void SubdivisionEngine::divide_together(const CuttingPlane& plane) {
    const std::size_t count = found_.size(), chunks = (count + chunk_size - 1) / chunk_size;
    Planner planner = this->planner();
    plans_.resize(count);
    plan_parents(0, count, planner);
    if (chunk_loose_.size() < chunks) chunk_loose_ = std::vector<Buffer<LooseFace>>(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        chunk_loose_[chunk].clear();
        const ParentPlan *first = plans_.data() + chunk * chunk_size, *last = plans_.data() + std::min(count, (chunk + 1) * chunk_size);
        if (!streams(count)) return write_parents(first, last, plane, chunk_loose_[chunk]);
        StreamedChildren stream(children_from(first->first_half_face / 4 - canonical_.tets()));
        stream_parents(first, last, plane, stream, chunk_loose_[chunk]);
        stream.finish();
    });
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const Buffer<LooseFace>& part = chunk_loose_[chunk];
        std::copy(part.begin(), part.end(), loose_.grow_by(part.size()));
    }
}

void SubdivisionEngine::divide_parents(const CuttingPlane& plane) {
    if (workers_.alone() || found_.size() < together_from) divide_alone(plane);
    else divide_together(plane);
}

}  // namespace cleave::subdivision
