#include "solver/subdivision/piece_tables.hpp"

#include "solver/mesh/tet_mesh.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

namespace cleave::subdivision {
namespace {

using FaceCodes = std::array<PointCode, 3>;

FaceCodes sorted_codes(const std::array<std::uint8_t, 4>& child, int face) {
    const auto& local = mesh::face_vertices[face];
    FaceCodes codes{child[local[0]], child[local[1]], child[local[2]]};
    std::sort(codes.begin(), codes.end());
    return codes;
}

/// A point of a face as both sides know it: by the ranks 0, 1, 2 of the face's vertices; 0..2 vertices, 3..5 edges, 6 barycentre.
int rank_on_face(PointCode code, int face) {
    const auto rank = [face](int vertex) { return vertex - (vertex > face ? 1 : 0); };
    if (code < first_edge_code) return rank(code);
    if (code >= first_face_code) return 6;
    const auto& [i, j] = edge_ends[code - first_edge_code];
    return 2 + rank(i) + rank(j);  // (0,1) 3, (0,2) 4, (1,2) 5
}

void fill_inner_links(PieceTable& table) {
    std::map<FaceCodes, int> waiting;
    for (int child = 0; child < table.children; ++child) {
        for (int face = 0; face < 4; ++face) {
            table.inner[child][face] = PieceTable::outer;
            if (table.face[child][face] >= 0) continue;
            const FaceCodes codes = sorted_codes(table.codes[child], face);
            const auto [other, first] = waiting.emplace(codes, 4 * child + face);
            if (first) continue;
            table.inner[child][face] = other->second;
            table.inner[other->second / 4][other->second % 4] = 4 * child + face;
        }
    }
}

void fill_pieces(PieceTable& table) {
    for (int parent_face = 0; parent_face < 4; ++parent_face) {
        std::map<std::array<int, 3>, int> ordered;
        for (int child = 0; child < table.children; ++child) {
            for (int face = 0; face < 4; ++face) {
                if (table.face[child][face] != parent_face) continue;
                std::array<int, 3> ranks{};
                const FaceCodes codes = sorted_codes(table.codes[child], face);
                for (int i = 0; i < 3; ++i) ranks[i] = rank_on_face(codes[i], parent_face);
                std::sort(ranks.begin(), ranks.end());
                ordered[ranks] = 4 * child + face;
            }
        }
        FacePieces& pieces = table.pieces[parent_face];
        for (const auto& [ranks, half_face] : ordered) pieces.half_face[pieces.count++] = static_cast<std::uint8_t>(half_face);
        pieces.ascending = pieces.half_face;
        std::sort(pieces.ascending.begin(), pieces.ascending.begin() + pieces.count);
    }
}

PieceTable build(unsigned plus_mask, bool odd) {
    PieceTable table;
    const CutTemplate& cut = cut_template(plus_mask);
    if (!cut.children.empty()) table.base_face = cut.base_face;
    for (const ChildTemplate& shape : cut.children) {
        const int child = table.children++;
        table.codes[child] = shape.points;
        if (odd) std::swap(table.codes[child][2], table.codes[child][3]);
        table.side[child] = static_cast<std::int8_t>(shape.side);
        for (int face = 0; face < 4; ++face) {
            unsigned common = 15;
            for (const int corner : mesh::face_vertices[face]) common &= faces_of(table.codes[child][corner]);
            table.face[child][face] = static_cast<std::int8_t>(common == 0 ? -1 : std::countr_zero(common));
        }
    }
    fill_inner_links(table);
    fill_pieces(table);
    return table;
}

std::array<PieceTable, 32> build_all() {
    std::array<PieceTable, 32> all;
    for (unsigned i = 0; i < 32; ++i) all[i] = build(i / 2, i % 2 == 1);
    return all;
}

}  // namespace

const std::array<PieceTable, 32>& piece_tables() {
    static const std::array<PieceTable, 32> all = build_all();
    return all;
}

}  // namespace cleave::subdivision
