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

/// The base's barycentre and the links to another base behind it, which conforms even where it was cut before; the earlier one's side
/// was written when this tet was whole. Whether the barycentre is new.
inline bool SubdivisionEngine::plan_base(const ParentLayout& layout, int behind, ParentPlan& plan, int next_point) {
    plan.face_point[3] = next_point;
    plan.outer.base.fill(-1);
    plan.behind_base = -1;
    if (behind < 0) return true;
    const int face = behind % 4;
    plan.behind_base = 4 * (behind / 4) + canonical_.records[static_cast<std::size_t>(plan.tet)].position_behind(layout.base_face);
    const State& there = states_[static_cast<std::size_t>(behind / 4)];
    if (there.cut < 0) return true;
    const ParentLayout& other = layouts_[there.layout];
    if (other.base_face != face) return true;
    int* earlier;
    if (there.cut == cuts_) {
        ParentPlan& before = plans_[static_cast<std::size_t>(there.place)];
        plan.face_point[3] = before.face_point[3];
        earlier = before.outer.base.data();
    } else {
        // The barycentre is the one point that the child below the other's lone tet has beside the cut points.
        plan.face_point[3] = child_tets_[static_cast<std::size_t>(there.first_child) + 1][static_cast<std::size_t>(other.pattern->barycentre)];
        earlier = nullptr;
    }
    for (int k = 0; k < 3; ++k) {
        plan.outer.base[k] = first_half_face(there) + other.base[k];
        const int own = 4 * (canonical_.tets() + plan.first_child) + layout.base[k];
        (earlier != nullptr ? earlier[k] : child_links_[static_cast<std::size_t>(there.first_child)].data()[other.base[k]]) = own;
    }
    return false;
}

/// Numbers of a parent's points, and links both ways to the parents before it in this cut.
template <int cuts>
inline void SubdivisionEngine::plan_faces(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan, int& next_point) {
    unsigned makes = 0, inner_faces = 0;
    for (int k = 0; k < cuts; ++k) {
        int& number = edge_point_[static_cast<std::size_t>(record.edge[layout.edge[k]])];
        const bool is_new = number < first_point_;
        number = is_new ? next_point : number;
        plan.cut_point[k] = number;
        next_point += is_new;
        makes |= static_cast<unsigned>(is_new) << k;
    }
    const int own_first = 4 * (canonical_.tets() + plan.first_child);
    ParentPlan nowhere;
    for (int k = 0; k < cuts; ++k) {
        // Choices of address, because a branch on them cannot be foretold. A parent after this one has not been planned.
        const int face = layout.face[k], behind = record.opposite[face];
        const State& there = states_[static_cast<std::size_t>(behind < 0 ? plan.tet : behind / 4)];
        const bool known = (behind >= 0) & (there.cut == cuts_);
        const ParentLayout& other = layouts_[there.layout];
        ParentPlan& before = known ? plans_[static_cast<std::size_t>(there.place)] : nowhere;
        const int place = other.place[behind & 3], unlinked = known ? 0 : -1;
        nowhere.face_point[place] = next_point;
        plan.face_point[k] = before.face_point[place];
        plan.outer.ring[k] = known ? first_half_face(there) + other.ring[behind & 3] : OuterLinks::none;
        plan.outer.lone[k] = (first_half_face(there) + other.lone[behind & 3]) | unlinked;
        before.outer.ring[place] = own_first + layout.ring[face];
        before.outer.lone[place] = own_first + layout.lone[face];
        next_point += !known;
        makes |= static_cast<unsigned>(!known) << (cuts + k);
        inner_faces |= static_cast<unsigned>(behind >= 0) << k;
    }
    if constexpr (cuts == 3) {
        const int behind = record.opposite[layout.base_face];
        const bool is_new = plan_base(layout, behind, plan, next_point);
        next_point += is_new;
        makes |= static_cast<unsigned>(is_new) << 6;
        inner_faces |= static_cast<unsigned>(behind >= 0) << 3;
    } else {
        plan.centre = next_point++;
        makes |= 1U << 8;
    }
    plan.makes = static_cast<std::uint16_t>(makes);
    plan.inner_faces = static_cast<std::uint8_t>(inner_faces);
}

void SubdivisionEngine::plan_parents() {
    constexpr std::size_t far = 12, near = 6;
    const std::size_t count = found_.size();
    plans_.resize(count);
    const int originals = static_cast<int>(canonical_.vertices.size());
    int next_point = first_point_ = originals + static_cast<int>(points_.size());
    int children = static_cast<int>(child_tets_.size()), two_two = 0;
    int* parents = parents_.grow_by(count);
    for (std::size_t place = 0; place < count; ++place) {
        if (place + far < count) __builtin_prefetch(&canonical_.records[found_[place + far] / 16]);
        if (place + near < count) {
            const CanonicalMesh::Record& record = canonical_.records[found_[place + near] / 16];
            // Edges of the same lower vertex stand together.
            for (const int edge : {0, 3, 5}) __builtin_prefetch(&edge_point_[static_cast<std::size_t>(record.edge[edge])], 1);
            for (const int behind : record.opposite) __builtin_prefetch(&states_[static_cast<std::size_t>(behind < 0 ? 0 : behind / 4)]);
        }
        const int tet = static_cast<int>(found_[place] / 16);
        const CanonicalMesh::Record& record = canonical_.records[static_cast<std::size_t>(tet)];
        const unsigned number = 2 * (found_[place] % 16) + record.odd;
        const ParentLayout& layout = layouts_[number];
        parents[place] = tet;
        states_[static_cast<std::size_t>(tet)] = {cuts_, children, static_cast<int>(place), number};
        ParentPlan& plan = plans_[place];
        plan.corner = shuffled(record.sorted, layout.role_bytes);
        plan.tet = tet;
        plan.layout = static_cast<std::uint8_t>(number);
        plan.first_child = children;
        layout.cuts == 3 ? plan_faces<3>(layout, record, plan, next_point) : plan_faces<4>(layout, record, plan, next_point);
        children += layout.children;
        two_two += layout.cuts == 4;
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
