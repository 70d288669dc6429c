#include "solver/subdivision/links.hpp"
#include "solver/subdivision/subdivision_engine.hpp"
#include "solver/subdivision/surface_tags.hpp"

#include <algorithm>

namespace cleave::subdivision {

struct SubdivisionEngine::Sides {
    FaceSide low, high;
    Triangle face;
};

std::array<double, 3> SubdivisionEngine::vertex(int number) const {
    const auto originals = static_cast<int>(canonical_.vertices.size());
    if (number >= originals) return points_[static_cast<std::size_t>(number - originals)];
    const Vector4& x = canonical_.vertices[number];
    return {x[0], x[1], x[2]};
}

/// The pieces on both sides of the original face whose smaller half face is `key`.
void SubdivisionEngine::gather_sides(int key, Sides& sides) const {
    const auto triangle = [&](const std::array<int, 4>& tet, int face) {
        Triangle corners;
        const std::array<int, 3> numbers = mesh::face_of(tet, face);
        for (int i = 0; i < 3; ++i) {
            const std::array<double, 3> x = vertex(numbers[i]);
            corners[i] = {x[0], x[1], x[2]};
        }
        return corners;
    };
    const auto gather = [&](int tet, int sorted_face, FaceSide& side) {
        side.count = 0;
        if (!is_cut(tet)) {
            const int face = canonical_.position[tet][sorted_face];
            side.add(4 * tet + face, triangle(original_.tets[tet], face));
            return;
        }
        const FacePieces& pieces = table(tet).pieces[sorted_face];
        std::array<std::uint8_t, 5> ascending = pieces.half_face;
        std::sort(ascending.begin(), ascending.begin() + pieces.count);
        for (int k = 0; k < pieces.count; ++k) {
            const std::size_t child = static_cast<std::size_t>(states_[tet].first_child + ascending[k] / 4);
            side.add(child_half_face(tet, ascending[k]), triangle(child_tets_[child], ascending[k] % 4));
        }
    };
    const int tet = key / 4;
    const auto& position = canonical_.position[tet];
    const int face = static_cast<int>(std::find(position.begin(), position.end(), key % 4) - position.begin());
    const int behind = canonical_.opposite[tet][face];
    gather(tet, face, sides.low);
    gather(behind / 4, behind % 4, sides.high);
    sides.face = triangle(original_.tets[tet], key % 4);
}

void SubdivisionEngine::find_extra_links(std::vector<ExtraLink>& links) const {
    links.clear();
    Sides sides;
    loose_.for_each([&](std::size_t key) {
        gather_sides(static_cast<int>(key), sides);
        link_pieces(sides.low, sides.high, sides.face, links);
    });
}

Subdivided SubdivisionEngine::result() const {
    Subdivided out;
    const int originals = canonical_.tets();
    std::vector<int> compact(originals, -1);
    for (int tet = 0; tet < originals; ++tet) {
        if (is_cut(tet)) continue;
        compact[tet] = static_cast<int>(out.parent.size());
        out.parent.push_back(tet);
    }
    const int whole = static_cast<int>(out.parent.size());
    const auto renumbered = [&](int half_face) {
        if (half_face < 0) return -1;
        const int tet = half_face / 4;
        return 4 * (tet < originals ? compact[tet] : tet - originals + whole) + half_face % 4;
    };
    for (int i = 0; i < whole; ++i) {
        const int tet = out.parent[i];
        out.mesh.tets.push_back(original_.tets[tet]);
        out.cut.push_back(-1);
        out.side.push_back(0);
        out.volume.push_back(mesh::tet_volume(original_, tet));
        out.centroid.push_back(mesh::tet_centroid(original_, tet));
        std::array<int, 4> links{-1, -1, -1, -1};
        for (int f = 0; f < 4; ++f) {
            const int behind = canonical_.opposite[tet][f];
            if (behind < 0 || is_cut(behind / 4)) continue;
            links[canonical_.position[tet][f]] = renumbered(4 * (behind / 4) + canonical_.position[behind / 4][behind % 4]);
        }
        out.links.opposite.insert(out.links.opposite.end(), links.begin(), links.end());
        for (std::int8_t face = 0; face < 4; ++face) out.parent_face.push_back(face);
    }
    for (std::size_t child = 0; child < child_tets_.size(); ++child) {
        const int tet = child_parents_[child];
        const PieceTable& pieces = table(tet);
        const std::size_t k = child - static_cast<std::size_t>(states_[tet].first_child);
        out.mesh.tets.push_back(child_tets_[child]);
        out.parent.push_back(tet);
        out.cut.push_back(states_[tet].cut);
        out.side.push_back(pieces.side[k]);
        out.volume.push_back(child_volumes_[child]);
        const auto& centroid = child_centroids_[child];
        out.centroid.emplace_back(centroid[0], centroid[1], centroid[2]);
        for (int face = 0; face < 4; ++face) {
            out.links.opposite.push_back(renumbered(child_links_[child][face]));
            const int on = pieces.face[k][face];
            out.parent_face.push_back(on < 0 ? std::int8_t{-1} : static_cast<std::int8_t>(canonical_.position[tet][on]));
        }
    }
    for (const int parent : out.parent) out.mesh.regions.push_back(original_.regions[parent]);
    out.mesh.vertices = original_.vertices;
    for (const auto& x : points_) out.mesh.vertices.emplace_back(x[0], x[1], x[2]);
    out.mesh.region_names = original_.region_names;
    out.mesh.surface_names = original_.surface_names;
    find_extra_links(out.extra_links);
    for (ExtraLink& link : out.extra_links) link = {renumbered(link.first), renumbered(link.second), link.area};
    out.counts = counts_;
    out.mesh.surface = cut_surface(original_, out);
    return out;
}

}  // namespace cleave::subdivision
