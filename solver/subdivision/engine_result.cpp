#include "solver/subdivision/subdivision_engine.hpp"
#include "solver/subdivision/surface_tags.hpp"

namespace cleave::subdivision {

int SubdivisionEngine::original_half_face(int half_face) const {
    const int child = half_face / 4 - originals(), parent = child_parents_[child];
    const int face = pieces(parent).face[child - first_child(parent)][half_face % 4];
    return face < 0 ? -1 : 4 * parent + canonical_.records[parent].position[face];
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
    const PieceTable& pieces = this->pieces(tet);
    const std::size_t k = child - static_cast<std::size_t>(first_child(tet));
    out.mesh.tets.push_back(child_tets_[child]);
    out.parent.push_back(tet);
    out.cut.push_back(state(tet).cut);
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
    Buffer<ExtraLink> extra_links;
    find_extra_links(extra_links);
    for (const auto& [first, second, area] : extra_links) {
        out.extra_links.push_back({renumbering.half_face(first), renumbering.half_face(second), area});
    }
    out.counts = counts_;
    out.mesh.surface = cut_surface(original_, out);
    return out;
}

}  // namespace cleave::subdivision
