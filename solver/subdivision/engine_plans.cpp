#include "solver/subdivision/subdivision_engine.hpp"

#include <immintrin.h>

// Planning: each parent's place among the children, the numbers of its points and its links, in one pass in the order of the parents. A
// point belongs to the first parent that has it; the later ones find its number at the edge or in the plan of the tet behind the face,
// and complete that plan's links.

namespace cleave::subdivision {
namespace {

std::array<int, 4> shuffled(const std::array<int, 4>& values, const std::array<std::uint8_t, 16>& bytes) {
    const __m128i in = _mm_loadu_si128(reinterpret_cast<const __m128i*>(values.data()));
    const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(bytes.data()));
    std::array<int, 4> out;
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out.data()), _mm_shuffle_epi8(in, order));
    return out;
}

}  // namespace

/// Two bases conform even where they were cut one after the other: takes the number of the earlier one's barycentre, the one point that
/// the child below its lone tet has beside the cut points, and links both.
void SubdivisionEngine::join_earlier_base(const State& there, ParentPlan& plan) {
    const ChildPattern& earlier = *layouts_[there.layout].pattern;
    const ChildPattern& own = *layouts_[plan.layout].pattern;
    const auto child = static_cast<std::size_t>(there.first_half_face / 4 - canonical_.tets());
    plan.face_point[3] = child_tets_[child + 1][static_cast<std::size_t>(earlier.barycentre)];
    plan.lone[3] = there.first_half_face + earlier.base[0];
    plan.ring[3] = there.first_half_face + earlier.base[1];
    int* links = child_links_[child].data();
    for (int k = 0; k < 3; ++k) links[earlier.base[k]] = plan.first_half_face + own.base[k];
}

/// Numbers of a parent's points, and links both ways to the parents before it in this cut. Without branches, which could not be
/// foretold: choices of values and addresses. plans_[0] takes what belongs to no plan.
inline void SubdivisionEngine::plan_points(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan, int& next_point) {
    unsigned makes = 0, inner_faces = 0;
    int next = next_point;
    for (int k = 0; k < 4; ++k) {
        int& number = edge_point_[static_cast<std::size_t>(record.edge[layout.own[k].edge])];
        const bool is_new = number < first_point_;
        number = is_new ? next : number;
        plan.cut_point[k] = number;
        next += is_new;
        makes |= static_cast<unsigned>(is_new) << k;
    }
    const State* states = &states_[1];
    for (int k = 0; k < 4; ++k) {
        const ParentLayout::Own own = layout.own[k];
        const int behind = record.opposite[own.face];
        const State& there = states[behind >> 2];
        const ParentLayout::Seen seen = layouts_[there.layout].seen[behind & 3];
        const bool known = there.cut == cuts_;  // planned before: a parent after this one is still whole
        ParentPlan& before = plans_[known ? static_cast<std::size_t>(there.place) : 0];
        plan.face_point[k] = known ? before.face_point[seen.place] : next;
        plan.ring[k] = known ? there.first_half_face + seen.ring : ParentPlan::unlinked;
        plan.lone[k] = known ? there.first_half_face + seen.lone : -1;
        before.ring[seen.place] = plan.first_half_face + own.ring;
        before.lone[seen.place] = plan.first_half_face + own.lone;
        next += !known;
        makes |= static_cast<unsigned>(!known) << (4 + k);
        inner_faces |= static_cast<unsigned>(behind >= 0) << k;
    }
    const int behind = record.opposite[layout.own[3].face];
    plan.behind_base = (behind & ~3) | record.position_behind(layout.own[3].face);
    const bool has_centre = layout.kind == ParentLayout::two_two;
    const State& there = states[behind >> 2];
    if (there.cut >= 0 && there.cut != cuts_ && !has_centre && layouts_[there.layout].base_face == (behind & 3)) {
        join_earlier_base(there, plan);
        --next;
        makes &= ~(1U << 7);
    }
    plan.centre = next;
    next_point = next + has_centre;
    plan.makes = static_cast<std::uint16_t>(makes | static_cast<unsigned>(has_centre) << 8);
    plan.inner_faces = static_cast<std::uint8_t>(inner_faces);
}

void SubdivisionEngine::plan_parents() {
    constexpr std::size_t far = 12, near = 6;
    const std::size_t count = found_.size();
    plans_.resize(count + 1);
    const int originals = static_cast<int>(canonical_.vertices.size()), tets = canonical_.tets();
    int next_point = first_point_ = originals + static_cast<int>(points_.size());
    int children = static_cast<int>(child_tets_.size()), two_two = 0;
    int* parents = parents_.grow_by(count);
    const std::uint64_t* found = found_.data();
    State* states = &states_[1];
    for (std::size_t i = 0; i < count; ++i) {
        if (i + far < count) __builtin_prefetch(&canonical_.records[found[i + far] / 16]);
        if (i + near < count) {
            const CanonicalMesh::Record& record = canonical_.records[found[i + near] / 16];
            // Edges of the same lower vertex stand together.
            for (const int edge : {0, 3, 5}) __builtin_prefetch(&edge_point_[static_cast<std::size_t>(record.edge[edge])], 1);
            for (const int behind : record.opposite) __builtin_prefetch(&states[behind >> 2]);
        }
        const int tet = static_cast<int>(found[i] / 16);
        const CanonicalMesh::Record& record = canonical_.records[static_cast<std::size_t>(tet)];
        const unsigned number = 2 * static_cast<unsigned>(found[i] % 16) + record.odd;
        const ParentLayout& layout = layouts_[number];
        parents[i] = tet;
        ParentPlan& plan = plans_[i + 1];
        plan.corner = shuffled(record.sorted, layout.role_bytes);
        plan.tet = tet;
        plan.layout = static_cast<std::uint8_t>(number);
        plan.first_half_face = 4 * (tets + children);
        plan_points(layout, record, plan, next_point);
        states[tet] = {cuts_, plan.first_half_face, static_cast<int>(i) + 1, number};
        children += layout.children;
        two_two += layout.kind == ParentLayout::two_two;
    }
    counts_.uncut -= static_cast<int>(count);
    counts_.two_two += two_two;
    counts_.three_one += static_cast<int>(count) - two_two;
    points_.resize(static_cast<std::size_t>(next_point - originals));
    const auto all = static_cast<std::size_t>(children);
    child_tets_.resize(all);
    child_links_.resize(all);
    child_centroids_.resize(all);
    child_volumes_.resize(all);
    child_parents_.resize(all);
}

}  // namespace cleave::subdivision
