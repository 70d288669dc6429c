#include "solver/subdivision/links.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>
#include <bit>

// Links across the faces of parents: equal pieces, read from the layouts of both sides; and the others, found on demand.

namespace cleave::subdivision {

/// Lists the faces of a new parent that have a tet behind them and no links, in the order of the sorted faces.
void SubdivisionEngine::note_loose_faces(const ParentPlan& plan, const ParentLayout& layout, Buffer<LooseFace>& loose) const {
    unsigned faces = 0;
    for (int k = 0; k < layout.cuts; ++k) faces |= static_cast<unsigned>((plan.inner_faces >> k & 1U) != 0 && plan.outer.ring[k] < 0) << layout.face[k];
    if (layout.cuts == 3 && plan.behind_base >= 0 && plan.outer.base[0] < 0) faces |= 1U << layout.base_face;
    for (; faces != 0; faces &= faces - 1) {
        const int face = std::countr_zero(faces);
        LooseFace* added = loose.grow_by(1);
        added->face = 4 * plan.tet + face;
        added->behind = -1;
        if (face != layout.base_face) continue;
        const auto corner = [&](int role) {
            const Vector4& x = canonical_.vertices[static_cast<std::size_t>(plan.corner[role])];
            return Eigen::Vector3d(x[0], x[1], x[2]);
        };
        added->behind = plan.behind_base;
        added->third = triangle_area({corner(1), corner(2), corner(3)}) / 3;
        for (int k = 0; k < 3; ++k) added->pieces[k] = 4 * (canonical_.tets() + plan.first_child) + layout.base[k];
    }
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

/// A loose face of a cut tet and what lies behind it, unless that was cut later (and lists the face then, if it is still loose).
void SubdivisionEngine::link_loose_face(int tet, int face, Buffer<ExtraLink>& links) const {
    const int behind = canonical_.records[tet].opposite[face];
    const State &here = states_[tet], &there = states_[behind / 4];
    if (there.cut > here.cut) return;
    const FaceSide own = face_side(tet, face), other = face_side(behind / 4, behind % 4);
    const auto& sorted = canonical_.records[tet].sorted;
    const bool low = tet < behind / 4;
    const Triangle whole = triangle({sorted[face], sorted[face == 0 ? 1 : 0], sorted[face <= 1 ? 2 : 1], sorted[face <= 2 ? 3 : 2]}, 0);
    std::vector<ExtraLink> found;
    link_pieces(low ? own : other, low ? other : own, whole, found);
    std::copy(found.begin(), found.end(), links.grow_by(found.size()));
}

/// A whole tet before a 3-1 tet's base, the most frequent case, was prepared when the parent was written.
void SubdivisionEngine::link_loose_faces(std::size_t first, std::size_t last, Buffer<ExtraLink>& links) const {
    constexpr std::size_t ahead = 12;
    for (std::size_t i = first; i < last; ++i) {
        const LooseFace& loose = loose_[i];
        if (i + ahead < last && loose_[i + ahead].behind >= 0) __builtin_prefetch(&states_[static_cast<std::size_t>(loose_[i + ahead].behind / 4)]);
        if (loose.behind >= 0 && states_[static_cast<std::size_t>(loose.behind / 4)].cut < 0) {
            ExtraLink* added = links.grow_by(3);
            for (int k = 0; k < 3; ++k) added[k] = {loose.behind, loose.pieces[k], loose.third};
        } else {
            link_loose_face(loose.face / 4, loose.face % 4, links);
        }
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
