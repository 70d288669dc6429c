#include "solver/subdivision/canonical_mesh.hpp"

#include "solver/subdivision/cut.hpp"
#include "solver/subdivision/templates.hpp"

#include <algorithm>
#include <stdexcept>

namespace cleave::subdivision {
namespace {

/// Items bucketed by a vertex (counting sort): those of vertex v stand from start[v] to start[v + 1].
template <class Item>
struct Buckets {
    std::vector<int> start;
    std::vector<Item> items;
};

/// Calls emit(add) twice, where add(vertex, item) names each item: first to count, then to place.
template <class Item, class Emit>
Buckets<Item> bucketed(std::size_t vertices, const Emit& emit) {
    Buckets<Item> buckets;
    buckets.start.assign(vertices + 1, 0);
    emit([&](int vertex, const Item&) { ++buckets.start[vertex + 1]; });
    for (std::size_t v = 0; v < vertices; ++v) buckets.start[v + 1] += buckets.start[v];
    buckets.items.resize(buckets.start[vertices]);
    std::vector<int> next(buckets.start.begin(), buckets.start.end() - 1);
    emit([&](int vertex, const Item& item) { buckets.items[next[vertex]++] = item; });
    return buckets;
}

void sort_tets(const mesh::TetMesh& mesh, CanonicalMesh& out) {
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const auto& vertices = mesh.tets[tet];
        std::array<std::uint8_t, 4> position{0, 1, 2, 3};
        std::sort(position.begin(), position.end(), [&](int a, int b) { return vertices[a] < vertices[b]; });
        bool odd = false;
        for (int i = 0; i < 4; ++i) {
            out.records[tet].sorted[i] = vertices[position[i]];
            for (int j = 0; j < i; ++j) odd ^= position[j] > position[i];
        }
        out.records[tet].position = position;
        out.records[tet].odd = odd ? 1 : 0;
    }
}

void number_edges(CanonicalMesh& out) {
    struct Item {
        int high, slot;  // 6 * tet + edge
    };
    const Buckets<Item> buckets = bucketed<Item>(out.vertices.size(), [&](const auto& add) {
        for (int tet = 0; tet < out.tets(); ++tet) {
            for (int e = 0; e < 6; ++e) {
                const auto& v = out.records[tet].sorted;
                add(v[edge_ends[e][0]], {v[edge_ends[e][1]], 6 * tet + e});
            }
        }
    });
    std::vector<Item> bucket;
    for (std::size_t low = 0; low < out.vertices.size(); ++low) {
        bucket.assign(buckets.items.begin() + buckets.start[low], buckets.items.begin() + buckets.start[low + 1]);
        std::sort(bucket.begin(), bucket.end(), [](const Item& a, const Item& b) { return a.high < b.high; });
        for (std::size_t i = 0; i < bucket.size(); ++i) {
            if (i == 0 || bucket[i].high != bucket[i - 1].high) ++out.edges;
            out.records[bucket[i].slot / 6].edge[bucket[i].slot % 6] = out.edges - 1;
        }
    }
}

void link_faces(CanonicalMesh& out) {
    struct Item {
        int middle, high, slot;  // 4 * tet + face
        bool same(const Item& other) const { return middle == other.middle && high == other.high; }
    };
    const Buckets<Item> buckets = bucketed<Item>(out.vertices.size(), [&](const auto& add) {
        for (int tet = 0; tet < out.tets(); ++tet) {
            const auto& v = out.records[tet].sorted;
            add(v[1], {v[2], v[3], 4 * tet});
            add(v[0], {v[2], v[3], 4 * tet + 1});
            add(v[0], {v[1], v[3], 4 * tet + 2});
            add(v[0], {v[1], v[2], 4 * tet + 3});
        }
    });
    std::vector<Item> bucket;
    for (std::size_t low = 0; low < out.vertices.size(); ++low) {
        bucket.assign(buckets.items.begin() + buckets.start[low], buckets.items.begin() + buckets.start[low + 1]);
        std::sort(bucket.begin(), bucket.end(), [](const Item& a, const Item& b) {
            return a.middle != b.middle ? a.middle < b.middle : a.high < b.high;
        });
        for (std::size_t i = 0; i < bucket.size(); ++i) {
            const int slot = bucket[i].slot;
            const bool known = i > 0 && bucket[i].same(bucket[i - 1]);
            out.records[slot / 4].opposite[slot % 4] = -1;
            if (!known) continue;
            if (i > 1 && bucket[i].same(bucket[i - 2])) throw std::invalid_argument("CanonicalMesh: three tets share a face");
            const int other = bucket[i - 1].slot;
            out.records[slot / 4].opposite[slot % 4] = other;
            out.records[other / 4].opposite[other % 4] = slot;
        }
    }
}

void note_positions_behind(CanonicalMesh& out) {
    for (CanonicalMesh::Record& record : out.records) {
        unsigned packed = 0;
        for (int f = 0; f < 4; ++f) {
            const int behind = record.opposite[f];
            if (behind >= 0) packed |= static_cast<unsigned>(out.records[behind / 4].position[behind % 4]) << 2 * f;
        }
        record.behind = static_cast<std::uint8_t>(packed);
    }
}

}  // namespace

CanonicalMesh::CanonicalMesh(const mesh::TetMesh& mesh) : records(mesh.tets.size()) {
    const std::vector<double> shortest = shortest_incident_edges(mesh);
    vertices.reserve(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Eigen::Vector3d& x = mesh.vertices[v];
        vertices.push_back(Vector4{x[0], x[1], x[2], shortest[v]});
    }
    sort_tets(mesh, *this);
    number_edges(*this);
    link_faces(*this);
    note_positions_behind(*this);
}

}  // namespace cleave::subdivision
