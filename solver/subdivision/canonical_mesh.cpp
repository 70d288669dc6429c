#include "solver/subdivision/canonical_mesh.hpp"

#include "solver/subdivision/templates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace cleave::subdivision {
namespace {

/// Sorts a tet's vertices by a network of five exchanges; returns the record's first part.
CanonicalMesh::Record sorted_record(const std::array<int, 4>& vertices) {
    CanonicalMesh::Record record{};
    record.sorted = vertices;
    record.position = {0, 1, 2, 3};
    // Choices of values: a branch could not be foretold.
    const auto exchange = [&](int i, int j) {
        const bool turned = record.sorted[i] > record.sorted[j];
        const auto choose = [turned](auto& a, auto& b) {
            const auto first = turned ? b : a, second = turned ? a : b;
            a = first, b = second;
        };
        choose(record.sorted[i], record.sorted[j]);
        choose(record.position[i], record.position[j]);
        record.odd ^= static_cast<std::uint8_t>(turned);
    };
    exchange(0, 1), exchange(2, 3), exchange(0, 2), exchange(1, 3), exchange(1, 2);
    record.opposite.fill(-1);
    return record;
}

/// Edges and faces by their lowest vertex: 4 * tet + i for each tet that has the vertex as sorted vertex i, with others above it.
struct Incidence {
    std::vector<int> start, items;  ///< of vertex v from start[v] to start[v + 1]
    Incidence(const CanonicalMesh& mesh, std::size_t vertices) : start(vertices + 1, 0) {
        for (const CanonicalMesh::Record& record : mesh.records) {
            for (int i = 0; i < 3; ++i) ++start[static_cast<std::size_t>(record.sorted[i]) + 1];
        }
        for (std::size_t v = 0; v < vertices; ++v) start[v + 1] += start[v];
        items.resize(static_cast<std::size_t>(start[vertices]));
        std::vector<int> next(start.begin(), start.end() - 1);
        for (int tet = 0; tet < mesh.tets(); ++tet) {
            for (int i = 0; i < 3; ++i) items[static_cast<std::size_t>(next[mesh.records[tet].sorted[i]]++)] = 4 * tet + i;
        }
    }
};

/// Numbers the edges above a vertex in the order in which its tets name them, and shortens what stands for the shortest edges' squares.
class EdgeNumbers {
public:
    EdgeNumbers(CanonicalMesh& mesh) : mesh_(mesh), known_(mesh.vertices.size(), {-1, 0}) {}

    void name(int low, int item) {
        CanonicalMesh::Record& record = mesh_.records[item / 4];
        const int i = item % 4;
        for (int j = i + 1; j < 4; ++j) {
            const int high = record.sorted[j];
            Known& known = known_[high];
            if (known.low != low) {
                known = {low, mesh_.edges++};
                shorten(low, high);
            }
            record.edge[edge_code(i, j) - first_edge_code] = known.edge;
        }
    }

private:
    struct Known {
        int low, edge;
    };
    void shorten(int low, int high) {
        Vector4 &a = mesh_.vertices[low], &b = mesh_.vertices[high];
        const Vector4 along = b - a, squares = along * along;
        const double square = (squares[0] + squares[1]) + squares[2];
        a[3] = std::min(a[3], square);
        b[3] = std::min(b[3], square);
    }
    CanonicalMesh& mesh_;
    std::vector<Known> known_;  ///< per vertex: the last edge that ends there, and its lower vertex
};

/// Finds the two tets at each face above a vertex, in a small table by the face's other vertices.
class FacePairs {
public:
    FacePairs(CanonicalMesh& mesh) : mesh_(mesh), places_(64) {}

    /// Call before a vertex with so many tets.
    void start(std::size_t tets) {
        ++round_;
        std::size_t size = places_.size();
        while (size < 8 * tets) size *= 2;  // three faces a tet
        if (size > places_.size()) places_.assign(size, {});
    }

    void name(int item) {
        const auto& v = mesh_.records[item / 4].sorted;
        const int slot = item & ~3;
        if (item % 4 == 0) {
            add(v[2], v[3], slot + 1);
            add(v[1], v[3], slot + 2);
            add(v[1], v[2], slot + 3);
        } else if (item % 4 == 1) {
            add(v[2], v[3], slot);
        }
    }

private:
    struct Place {
        int round = 0;  ///< of another round: free
        int middle, high, slot;
        bool full;
    };
    void add(int middle, int high, int slot) {
        const std::size_t mask = places_.size() - 1;
        std::size_t at = (static_cast<std::uint32_t>(middle) * 0x9e3779b1U + static_cast<std::uint32_t>(high) * 0x85ebca6bU) >> 7 & mask;
        while (places_[at].round == round_ && (places_[at].middle != middle || places_[at].high != high)) at = (at + 1) & mask;
        Place& place = places_[at];
        if (place.round != round_) {
            place = {round_, middle, high, slot, false};
            return;
        }
        if (place.full) throw std::invalid_argument("CanonicalMesh: three tets share a face");
        place.full = true;
        join(slot, place.slot);
        join(place.slot, slot);
    }
    /// What a half face's record says of the half face behind it.
    void join(int slot, int behind) {
        CanonicalMesh::Record &record = mesh_.records[slot / 4], &other = mesh_.records[behind / 4];
        record.opposite[slot % 4] = behind;
        record.behind = static_cast<std::uint8_t>(record.behind | other.position[behind % 4] << 2 * (slot % 4));
    }
    CanonicalMesh& mesh_;
    std::vector<Place> places_;
    int round_ = 0;
};

}  // namespace

CanonicalMesh::CanonicalMesh(const mesh::TetMesh& mesh) {
    vertices.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& x : mesh.vertices) vertices.push_back(Vector4{x[0], x[1], x[2], std::numeric_limits<double>::infinity()});
    records.reserve(mesh.tets.size());
    for (const auto& tet : mesh.tets) records.push_back(sorted_record(tet));
    constexpr std::size_t ahead = 16;
    const auto ask_for = [&](int item) { __builtin_prefetch(&records[item / 4], 1); };
    const Incidence incidence(*this, vertices.size());
    EdgeNumbers edge_numbers(*this);
    FacePairs face_pairs(*this);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto first = static_cast<std::size_t>(incidence.start[v]), last = static_cast<std::size_t>(incidence.start[v + 1]);
        face_pairs.start(last - first);
        for (std::size_t i = first; i < last; ++i) {
            if (i + ahead < incidence.items.size()) ask_for(incidence.items[i + ahead]);
            edge_numbers.name(static_cast<int>(v), incidence.items[i]);
            face_pairs.name(incidence.items[i]);
        }
    }
    for (Vector4& vertex : vertices) vertex[3] = std::sqrt(vertex[3]);  // the root keeps the order: shortest_incident_edges, to the bit
}

}  // namespace cleave::subdivision
