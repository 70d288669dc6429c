#include "solver/subdivision/subdivision_engine.hpp"

#include <immintrin.h>

// Planning: each parent's place among the children and the numbers of its points, in one pass in the order of the parents. A point
// belongs to the first parent that has it; the later ones find its number at the edge or in the plan of the tet behind the face.

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

/// Whether the base's barycentre is new: it is not where the tet behind has the same base, of this cut or an earlier one.
bool SubdivisionEngine::number_base(ParentPlan& plan, int next_point) {
    plan.face_point[3] = next_point;
    const int behind = plan.behind[3];
    if (behind < 0) return true;
    const State& there = states_[behind / 4];
    if (there.cut < 0 || (there.cut == cuts_ && behind / 4 > plan.tet) || layouts_[there.layout].base_face != behind % 4) return true;
    // The barycentre is the one point that the child below the other's lone tet has beside the cut points.
    const ParentLayout& other = layouts_[there.layout];
    plan.face_point[3] = there.cut == cuts_ ? plans_[static_cast<std::size_t>(there.place)].face_point[3]
                                            : child_tets_[static_cast<std::size_t>(there.first_child) + 1][other.pattern->barycentre];
    return false;
}

template <int cuts>
inline void SubdivisionEngine::number_points(const ParentLayout& layout, const CanonicalMesh::Record& record, ParentPlan& plan, int& next_point) {
    unsigned makes = 0;
    for (int k = 0; k < cuts; ++k) {
        int& number = edge_point_[static_cast<std::size_t>(record.edge[layout.edge[k]])];
        const bool is_new = number < first_point_;
        number = is_new ? next_point : number;
        plan.cut_point[k] = number;
        next_point += is_new;
        makes |= static_cast<unsigned>(is_new) << k;
    }
    for (int k = 0; k < cuts; ++k) {
        // A choice of address, because a branch on it cannot be foretold.
        const int behind = plan.behind[k];
        const State& there = states_[static_cast<std::size_t>(behind < 0 ? plan.tet : behind / 4)];
        const bool is_new = (behind < 0) | (there.cut != cuts_) | (behind / 4 > plan.tet);
        plan.face_point[k] = next_point;
        const int* number = is_new ? &plan.face_point[k]
                                   : &plans_[static_cast<std::size_t>(there.place)].face_point[layouts_[there.layout].place[behind & 3]];
        plan.face_point[k] = *number;
        next_point += is_new;
        makes |= static_cast<unsigned>(is_new) << (cuts + k);
    }
    if constexpr (cuts == 3) {
        const bool is_new = number_base(plan, next_point);
        next_point += is_new;
        makes |= static_cast<unsigned>(is_new) << 6;
    } else {
        plan.centre = next_point++;
        makes |= 1U << 8;
    }
    plan.makes = static_cast<std::uint16_t>(makes);
}

inline void SubdivisionEngine::plan_parent(std::size_t place, int& next_point) {
    const int tet = parents_[first_parent_ + place];
    const CanonicalMesh::Record& record = canonical_.records[static_cast<std::size_t>(tet)];
    State& state = states_[static_cast<std::size_t>(tet)];
    state.layout |= record.odd;
    const ParentLayout& layout = layouts_[state.layout];
    ParentPlan& plan = plans_[place];
    plan.corner = shuffled(record.sorted, layout.role_bytes);
    plan.behind = shuffled(record.opposite, layout.face_bytes);
    plan.tet = tet;
    plan.layout = static_cast<std::uint8_t>(state.layout);
    plan.first_child = state.first_child;
    layout.cuts == 3 ? number_points<3>(layout, record, plan, next_point) : number_points<4>(layout, record, plan, next_point);
}

void SubdivisionEngine::plan_parents() {
    constexpr std::size_t far = 12, near = 6;
    const std::size_t count = parents_.size() - first_parent_;
    const int* parents = parents_.data() + first_parent_;
    plans_.resize(count);
    const int originals = static_cast<int>(canonical_.vertices.size());
    int next_point = first_point_ = originals + static_cast<int>(points_.size());
    int children = static_cast<int>(child_tets_.size()), two_two = 0;
    for (std::size_t place = 0; place < count; ++place) {
        if (place + far < count) __builtin_prefetch(&canonical_.records[static_cast<std::size_t>(parents[place + far])]);
        if (place + near < count) {
            const CanonicalMesh::Record& record = canonical_.records[static_cast<std::size_t>(parents[place + near])];
            for (const int edge : record.edge) __builtin_prefetch(&edge_point_[static_cast<std::size_t>(edge)], 1);
            for (const int behind : record.opposite) __builtin_prefetch(&states_[static_cast<std::size_t>(behind < 0 ? 0 : behind / 4)]);
        }
        State& state = states_[static_cast<std::size_t>(parents[place])];
        state.place = static_cast<int>(place);
        state.first_child = children;
        plan_parent(place, next_point);
        const ParentLayout& layout = layouts_[state.layout];
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
