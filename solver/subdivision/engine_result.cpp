#include "solver/subdivision/links.hpp"
#include "solver/subdivision/subdivision_engine.hpp"
#include "solver/subdivision/surface_tags.hpp"

#include <algorithm>

namespace cleave::subdivision {

int SubdivisionEngine::original_half_face(int half_face) const {
    const int child = half_face / 4 - originals(), parent = child_parents_[child];
    const int face = pieces(parent).face[child - first_child(parent)][half_face % 4];
    return face < 0 ? -1 : 4 * parent + canonical_.records[parent].position[face];
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
    const FacePieces& pieces = states_[tet].pieces->pieces[sorted_face];
    for (int k = 0; k < pieces.count; ++k) {
        const int piece = pieces.ascending[k];
        side.add(child_half_face(tet, piece), triangle(child_tets_[states_[tet].first_child + piece / 4], piece % 4));
    }
    return side;
}

/// A whole tet before a 3-1 tet's base, the most frequent case: link_pieces from the original vertices alone.
void SubdivisionEngine::link_base(int whole_half_face, int tet, std::vector<ExtraLink>& links) const {
    const PieceTable& pieces = *states_[tet].pieces;
    const auto& sorted = canonical_.records[tet].sorted;
    const int f = pieces.base_face;
    std::array<Eigen::Vector3d, 15> points;
    for (int i = 0; i < 4; ++i) {
        const Vector4& x = canonical_.vertices[sorted[i]];
        points[i] = {x[0], x[1], x[2]};
    }
    points[first_face_code + f] = (points[f == 0 ? 1 : 0] + points[f <= 1 ? 2 : 1] + points[f <= 2 ? 3 : 2]) / 3;
    for (int k = 0; k < 3; ++k) {
        const auto& [a, b, c] = pieces.base_triangles[k];
        const double area = triangle_area({points[a], points[b], points[c]});
        links.push_back({whole_half_face, child_half_face(tet, pieces.pieces[f].ascending[k]), area});
    }
}

/// A loose face of a cut tet and what lies behind it, unless that was cut later (and lists the face then, if it is still loose).
void SubdivisionEngine::link_loose_face(int tet, int face, std::vector<ExtraLink>& links) const {
    const int behind = canonical_.records[tet].opposite[face];
    const State &here = states_[tet], &there = states_[behind / 4];
    if (there.cut > here.cut) return;
    const bool base = face == here.pieces->base_face;
    if (base && there.cut < 0) {
        link_base(4 * (behind / 4) + canonical_.records[behind / 4].position[behind % 4], tet, links);
        return;
    }
    const FaceSide own = face_side(tet, face), other = face_side(behind / 4, behind % 4);
    const bool low = tet < behind / 4;
    const int low_tet = low ? tet : behind / 4, low_face = low ? face : behind % 4;
    const Triangle whole = triangle(original_.tets[low_tet], canonical_.records[low_tet].position[low_face]);
    link_pieces(low ? own : other, low ? other : own, whole, links);
}

void SubdivisionEngine::find_extra_links(std::vector<ExtraLink>& links) const {
    constexpr std::size_t chunk_size = 1024;
    links.clear();
    const std::size_t chunks = (loose_.size() + chunk_size - 1) / chunk_size;
    if (workers_.alone() || chunks < 4) {
        link_loose_faces(0, loose_.size(), links);
        return;
    }
    std::vector<std::vector<ExtraLink>> parts(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        parts[chunk].reserve(4 * chunk_size);
        link_loose_faces(chunk * chunk_size, std::min(loose_.size(), (chunk + 1) * chunk_size), parts[chunk]);
    });
    for (const std::vector<ExtraLink>& part : parts) links.insert(links.end(), part.begin(), part.end());
}

void SubdivisionEngine::link_loose_faces(std::size_t first, std::size_t last, std::vector<ExtraLink>& links) const {
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

/// Numbers of the engine (children after all original tets) to numbers of a result (children after the whole tets).
class SubdivisionEngine::Renumbering {
public:
    explicit Renumbering(const SubdivisionEngine& engine) : originals_(engine.canonical_.tets()), compact_(originals_, -1) {
        for (int tet = 0; tet < originals_; ++tet) {
            if (!engine.is_cut(tet)) compact_[tet] = whole_++;
        }
    }
    int half_face(int engine_half_face) const {
        if (engine_half_face < 0) return -1;
        const int tet = engine_half_face / 4;
        return 4 * (tet < originals_ ? compact_[tet] : tet - originals_ + whole_) + engine_half_face % 4;
    }

private:
    int originals_, whole_ = 0;
    std::vector<int> compact_;
};

void SubdivisionEngine::append_whole(int tet, const Renumbering& renumbering, Subdivided& out) const {
    out.mesh.tets.push_back(original_.tets[tet]);
    out.parent.push_back(tet);
    out.cut.push_back(-1);
    out.side.push_back(0);
    out.volume.push_back(mesh::tet_volume(original_, tet));
    out.centroid.push_back(mesh::tet_centroid(original_, tet));
    std::array<int, 4> links{-1, -1, -1, -1};
    const CanonicalMesh::Record& record = canonical_.records[tet];
    for (int f = 0; f < 4; ++f) {
        const int behind = record.opposite[f];
        if (behind < 0 || is_cut(behind / 4)) continue;
        links[record.position[f]] = renumbering.half_face(4 * (behind / 4) + canonical_.records[behind / 4].position[behind % 4]);
    }
    out.links.opposite.insert(out.links.opposite.end(), links.begin(), links.end());
    for (std::int8_t face = 0; face < 4; ++face) out.parent_face.push_back(face);
}

void SubdivisionEngine::append_child(std::size_t child, const Renumbering& renumbering, Subdivided& out) const {
    const int tet = child_parents_[child];
    const PieceTable& pieces = *states_[tet].pieces;
    const std::size_t k = child - static_cast<std::size_t>(states_[tet].first_child);
    out.mesh.tets.push_back(child_tets_[child]);
    out.parent.push_back(tet);
    out.cut.push_back(states_[tet].cut);
    out.side.push_back(pieces.side[k]);
    out.volume.push_back(child_volumes_[child]);
    const auto& centroid = child_centroids_[child];
    out.centroid.emplace_back(centroid[0], centroid[1], centroid[2]);
    for (int face = 0; face < 4; ++face) {
        out.links.opposite.push_back(renumbering.half_face(child_links_[child][face]));
        const int on = pieces.face[k][face];
        out.parent_face.push_back(on < 0 ? std::int8_t{-1} : static_cast<std::int8_t>(canonical_.records[tet].position[on]));
    }
}

Subdivided SubdivisionEngine::result() const {
    Subdivided out;
    const Renumbering renumbering(*this);
    for (int tet = 0; tet < canonical_.tets(); ++tet) {
        if (!is_cut(tet)) append_whole(tet, renumbering, out);
    }
    for (std::size_t child = 0; child < child_tets_.size(); ++child) append_child(child, renumbering, out);
    for (const int parent : out.parent) out.mesh.regions.push_back(original_.regions[parent]);
    out.mesh.vertices = original_.vertices;
    for (const auto& x : points_) out.mesh.vertices.emplace_back(x[0], x[1], x[2]);
    out.mesh.region_names = original_.region_names;
    out.mesh.surface_names = original_.surface_names;
    find_extra_links(out.extra_links);
    for (ExtraLink& link : out.extra_links) link = {renumbering.half_face(link.first), renumbering.half_face(link.second), link.area};
    out.counts = counts_;
    out.mesh.surface = cut_surface(original_, out);
    return out;
}

}  // namespace cleave::subdivision
