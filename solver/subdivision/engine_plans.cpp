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
    plan.behind[3] = {there.first_half_face + earlier.base[1], there.first_half_face + earlier.base[0]};
    int* links = child_links_[child].data();
    for (int k = 0; k < 3; ++k) links[earlier.base[k]] = plan.first_half_face + own.base[k];
    plan.makes &= static_cast<std::uint16_t>(~(1U << 7));
}

/// What all parents of a cut share. A class of its own, so that it lives in registers: no store to a plan can change it.
struct SubdivisionEngine::Planner {
    int cut, first_point, next_point;
    int* edge_point;
    ParentPlan* plans;  ///< plans[0] takes what belongs to no plan
    const ParentLayout* layouts;
    State* states;      ///< per tet, and one before the first

    void number_cut_points(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan);
    void meet_neighbours(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan);
    bool is_earlier_base(int behind) const {
        const State& there = states[behind >> 2];
        return there.cut >= 0 && there.cut != cut && layouts[there.layout].base_face == (behind & 3);
    }
};

/// The numbers of cut points: known at the edge, or the next ones.
inline void SubdivisionEngine::Planner::number_cut_points(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan) {
    unsigned makes = 0;
    for (int k = 0; k < 4; ++k) {
        int* number = edge_point + record.edge[layout.own[k].edge];
        const bool is_new = *number < first_point;
        plan.cut_point[k] = *number = is_new ? next_point : *number;
        next_point += is_new;
        makes |= static_cast<unsigned>(is_new) << k;
    }
    plan.makes = static_cast<std::uint16_t>(makes);
}

/// The numbers of face points, and links both ways to the parents before this one. Without branches, which could not be foretold: choices
/// of values and addresses.
inline void SubdivisionEngine::Planner::meet_neighbours(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan) {
    unsigned makes = plan.makes, inner_faces = 0;
    const int own_first = plan.first_half_face;
    for (int k = 0; k < 4; ++k) {
        const int face = layout.own[k].face, behind = record.opposite[face];
        const State& there = states[behind >> 2];
        const ParentLayout& other = layouts[there.layout];
        const bool known = there.cut == cut;  // planned before: a parent after this one is still whole
        const int place = other.place[behind & 3];
        ParentPlan& before = plans[known ? there.place : 0];
        plan.face_point[k] = known ? before.face_point[place] : next_point;
        const LinkEnds ends = LinkEnds{there.first_half_face, there.first_half_face} + other.ends[behind & 3];
        plan.behind[k] = known ? ends : LinkEnds::none();
        before.behind[place] = LinkEnds{own_first, own_first} + layout.ends[face];
        next_point += !known;
        makes |= static_cast<unsigned>(!known) << (4 + k);
        inner_faces |= static_cast<unsigned>(behind >= 0) << k;
    }
    plan.makes = static_cast<std::uint16_t>(makes);
    plan.inner_faces = static_cast<std::uint8_t>(inner_faces);
}

void SubdivisionEngine::plan_parents() {
    constexpr std::size_t far = 12, near = 6;
    const std::size_t count = found_.size();
    plans_.resize(count + 1);
    const int originals = static_cast<int>(canonical_.vertices.size()), tets = canonical_.tets();
    first_point_ = originals + static_cast<int>(points_.size());
    Planner all{cuts_, first_point_, first_point_, edge_point_.data(), plans_.data(), layouts_, &states_[1]};
    int children = static_cast<int>(child_tets_.size()), two_two = 0;
    int* parents = parents_.grow_by(count);
    const std::uint64_t* found = found_.data();
    const CanonicalMesh::Record* records = canonical_.records.data();
    for (std::size_t i = 0; i < count; ++i) {
        if (i + far < count) __builtin_prefetch(&records[found[i + far] / 16]);
        if (i + near < count) {
            const CanonicalMesh::Record& record = records[found[i + near] / 16];
            // Edges of the same lower vertex stand together.
            for (const int edge : {0, 3, 5}) __builtin_prefetch(all.edge_point + record.edge[edge], 1);
            for (const int behind : record.opposite) __builtin_prefetch(&all.states[behind >> 2]);
        }
        const int tet = parents[i] = static_cast<int>(found[i] / 16);
        const CanonicalMesh::Record& record = records[tet];
        const unsigned number = 2 * static_cast<unsigned>(found[i] % 16) + record.odd;
        const ParentLayout& layout = all.layouts[number];
        ParentPlan& plan = all.plans[i + 1];
        plan.corner = shuffled(record.sorted, layout.role_bytes);
        plan.tet = tet;
        plan.layout = static_cast<std::uint8_t>(number);
        plan.first_half_face = 4 * (tets + children);
        all.number_cut_points(layout, record, plan);
        all.meet_neighbours(layout, record, plan);
        const bool has_centre = layout.kind == ParentLayout::two_two;
        const int base = layout.own[3].face, behind = record.opposite[base];
        plan.behind_base = (behind & ~3) | record.position_behind(base);
        if (!has_centre && all.is_earlier_base(behind)) {
            join_earlier_base(all.states[behind >> 2], plan);
            --all.next_point;
        }
        plan.centre = all.next_point;
        all.next_point += has_centre;
        all.states[tet] = {all.cut, plan.first_half_face, static_cast<int>(i) + 1, number};
        children += layout.children;
        two_two += has_centre;
    }
    counts_.uncut -= static_cast<int>(count);
    counts_.two_two += two_two;
    counts_.three_one += static_cast<int>(count) - two_two;
    make_room(static_cast<std::size_t>(children), static_cast<std::size_t>(all.next_point - originals));
}

void SubdivisionEngine::make_room(std::size_t children, std::size_t points) {
    child_tets_.resize(children);
    child_links_.resize(children);
    child_centroids_.resize(children);
    child_volumes_.resize(children);
    child_parents_.resize(children);
    points_.resize(points);
}

}  // namespace cleave::subdivision
