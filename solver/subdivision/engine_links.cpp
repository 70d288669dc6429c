#include "solver/subdivision/links.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>
#include <bit>

// Links across the faces of parents: equal pieces, read from the layouts of both sides; and the others, found on demand.

namespace cleave::subdivision {

template <int cuts>
void SubdivisionEngine::find_outer_links(const ParentPlan& plan, const ParentLayout& layout, OuterLinks& outer, Buffer<int>& loose) {
    unsigned loose_faces = 0;
    for (int k = 0; k < cuts; ++k) {
        const int behind = plan.behind[k];
        outer.ring[k] = OuterLinks::none;
        outer.lone[k] = -1;
        if (behind < 0) continue;
        const State& there = states_[static_cast<std::size_t>(behind / 4)];
        if (there.cut != cuts_) {
            loose_faces |= 1U << layout.face[k];
            continue;
        }
        const ParentLayout& other = layouts_[there.layout];
        outer.ring[k] = first_half_face(there) + other.ring[behind & 3];
        outer.lone[k] = first_half_face(there) + other.lone[behind & 3];
    }
    if constexpr (cuts == 3) {
        if (!find_base_links(plan, layout, outer)) loose_faces |= 1U << layout.face[3];
    }
    for (; loose_faces != 0; loose_faces &= loose_faces - 1) loose.push_back(4 * plan.tet + std::countr_zero(loose_faces));
}
template void SubdivisionEngine::find_outer_links<3>(const ParentPlan&, const ParentLayout&, OuterLinks&, Buffer<int>&);
template void SubdivisionEngine::find_outer_links<4>(const ParentPlan&, const ParentLayout&, OuterLinks&, Buffer<int>&);

/// Whether the base conforms. Two bases do even where they were cut one after the other; the earlier one's side was written when this
/// tet was whole.
bool SubdivisionEngine::find_base_links(const ParentPlan& plan, const ParentLayout& layout, OuterLinks& outer) {
    const int behind = plan.behind[3];
    outer.base.fill(-1);
    if (behind < 0) return true;
    const State& there = states_[static_cast<std::size_t>(behind / 4)];
    const ParentLayout& other = layouts_[there.layout];
    if (there.cut < 0 || other.base_face != behind % 4) return false;
    for (int k = 0; k < 3; ++k) outer.base[k] = first_half_face(there) + other.base[k];
    if (there.cut == cuts_) return true;
    int* earlier = child_links_[static_cast<std::size_t>(there.first_child)].data();
    for (int k = 0; k < 3; ++k) earlier[other.base[k]] = 4 * (canonical_.tets() + plan.first_child) + layout.base[k];
    return true;
}

Triangle SubdivisionEngine::triangle(const std::array<int, 4>& tet, int face) const {
    Triangle corners;
    const auto originals = static_cast<int>(canonical_.vertices.size());
    for (int i = 0; i < 3; ++i) {
        const int number = tet[mesh::face_vertices[face][i]];
        if (number < originals) {
            const Vector4& x = canonical_.vertices[number];
            corners[i] = {x[0], x[1], x[2]};
        } else {
            const std::array<double, 3>& x = points_[static_cast<std::size_t>(number - originals)];
            corners[i] = {x[0], x[1], x[2]};
        }
    }
    return corners;
}

/// One side of a face: the tet itself where it is whole, else its pieces.
FaceSide SubdivisionEngine::face_side(int tet, int sorted_face) const {
    FaceSide side;
    if (!is_cut(tet)) {
        const int face = canonical_.records[tet].position[sorted_face];
        side.add(4 * tet + face, triangle(original_.tets[tet], face));
        return side;
    }
    const FacePieces& of_face = pieces(tet).pieces[sorted_face];
    for (int k = 0; k < of_face.count; ++k) {
        const int piece = of_face.ascending[k];
        side.add(first_half_face(states_[tet]) + piece, triangle(child_tets_[states_[tet].first_child + piece / 4], piece % 4));
    }
    return side;
}

/// A whole tet before a 3-1 tet's base, the most frequent case: link_pieces from the original vertices alone.
void SubdivisionEngine::link_base(int whole_half_face, int tet, Buffer<ExtraLink>& links) const {
    const auto& sorted = canonical_.records[tet].sorted;
    const ParentLayout& base = layout(tet);
    const auto corner = [&](int role) {
        const Vector4& x = canonical_.vertices[sorted[base.role[role]]];
        return Eigen::Vector3d(x[0], x[1], x[2]);
    };
    const double third = triangle_area({corner(1), corner(2), corner(3)}) / 3;
    const int first = first_half_face(states_[tet]);
    ExtraLink* added = links.grow_by(3);
    for (int k = 0; k < 3; ++k) added[k] = {whole_half_face, first + base.base[k], third};
}

/// A loose face of a cut tet and what lies behind it, unless that was cut later (and lists the face then, if it is still loose).
void SubdivisionEngine::link_loose_face(int tet, int face, Buffer<ExtraLink>& links) const {
    const int behind = canonical_.records[tet].opposite[face];
    const State &here = states_[tet], &there = states_[behind / 4];
    if (there.cut > here.cut) return;
    if (there.cut < 0 && face == layout(tet).base_face) {
        link_base(4 * (behind / 4) + canonical_.records[behind / 4].position[behind % 4], tet, links);
        return;
    }
    const FaceSide own = face_side(tet, face), other = face_side(behind / 4, behind % 4);
    const auto& sorted = canonical_.records[tet].sorted;
    const bool low = tet < behind / 4;
    const Triangle whole = triangle({sorted[face], sorted[face == 0 ? 1 : 0], sorted[face <= 1 ? 2 : 1], sorted[face <= 2 ? 3 : 2]}, 0);
    std::vector<ExtraLink> found;
    link_pieces(low ? own : other, low ? other : own, whole, found);
    std::copy(found.begin(), found.end(), links.grow_by(found.size()));
}

void SubdivisionEngine::link_loose_faces(std::size_t first, std::size_t last, Buffer<ExtraLink>& links) const {
    constexpr std::size_t far = 12, near = 6;
    for (std::size_t i = first; i < last; ++i) {
        if (i + far < last) __builtin_prefetch(&canonical_.records[loose_[i + far] / 4]);
        if (i + near < last) {
            const int behind = canonical_.records[loose_[i + near] / 4].opposite[loose_[i + near] % 4];
            __builtin_prefetch(&states_[behind / 4]);
            __builtin_prefetch(&canonical_.records[behind / 4].position);
        }
        link_loose_face(loose_[i] / 4, loose_[i] % 4, links);
    }
}

void SubdivisionEngine::find_extra_links(Buffer<ExtraLink>& links) const {
    constexpr std::size_t chunk_size = 1024;
    links.clear();
    const std::size_t chunks = (loose_.size() + chunk_size - 1) / chunk_size;
    if (workers_.alone() || chunks < 4) {
        link_loose_faces(0, loose_.size(), links);
        return;
    }
    std::vector<Buffer<ExtraLink>> parts(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        link_loose_faces(chunk * chunk_size, std::min(loose_.size(), (chunk + 1) * chunk_size), parts[chunk]);
    });
    for (const Buffer<ExtraLink>& part : parts) std::copy(part.begin(), part.end(), links.grow_by(part.size()));
}

}  // namespace cleave::subdivision
