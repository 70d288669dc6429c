#include "solver/subdivision/links.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>

// Links of faces that do not conform, found on demand.

namespace cleave::subdivision {

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
        side.add(state(tet).first_half_face + piece, triangle(child_tets_[first_child(tet) + piece / 4], piece % 4));
    }
    return side;
}

/// A loose face of a cut tet and what lies behind it, unless that was cut later (and lists the face then, if it is still loose).
void SubdivisionEngine::link_loose_face(int tet, int face, Buffer<ExtraLink>& links) const {
    const int behind = canonical_.records[tet].opposite[face];
    const State &here = state(tet), &there = state(behind / 4);
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
        if (i + ahead < last && loose_[i + ahead].behind >= 0) __builtin_prefetch(&state(loose_[i + ahead].behind / 4));
        if (loose.behind >= 0 && state(loose.behind / 4).cut < 0) {
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
