#include "solver/mesh/check.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cleave::mesh {
namespace {

/// A volume below this part of the longest edge cubed is rounding, not shape (double precision: about 1e-16 per operation).
constexpr double flat_volume = 1e-14;

class Checker {
public:
    Checker(const TetMesh& mesh, const std::string& file) : mesh_(mesh), file_(file) {}

    void run() const {
        if (mesh_.tets.empty()) fail("tets", "at least one tet");
        if (mesh_.regions.size() != mesh_.tets.size()) fail("regions", "one region per tet");
        check_vertices();
        for (std::size_t tet = 0; tet < mesh_.tets.size(); ++tet) check_tet(tet);
        for (std::size_t i = 0; i < mesh_.surface.size(); ++i) {
            for (const int vertex : mesh_.surface[i].vertices) require_vertex(vertex, fmt::format("triangle {}", i + 1));
        }
        check_duplicates();
        check_faces();
    }

private:
    [[noreturn]] void fail(const std::string& key, const std::string& expected) const { throw InputError(file_, key, expected); }

    void require_vertex(int vertex, const std::string& owner) const {
        if (vertex >= 0 && static_cast<std::size_t>(vertex) < mesh_.vertices.size()) return;
        fail(owner, fmt::format("vertices from 1 to {}, not {}", mesh_.vertices.size(), static_cast<long>(vertex) + 1));
    }

    void check_vertices() const {
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            if (!mesh_.vertices[i].allFinite()) fail(fmt::format("vertex {}", i + 1), "finite coordinates");
        }
    }

    void check_tet(std::size_t tet) const {
        const auto& corners = mesh_.tets[tet];
        const std::string owner = fmt::format("tet {}", tet + 1);
        double longest = 0;
        for (int i = 0; i < 4; ++i) {
            require_vertex(corners[i], owner);
            for (int j = 0; j < i; ++j) {
                if (corners[i] == corners[j]) fail(owner, fmt::format("four different vertices ({} stands twice)", corners[i] + 1));
                longest = std::max(longest, (mesh_.vertices[corners[i]] - mesh_.vertices[corners[j]]).norm());
            }
        }
        const double volume = tet_volume(mesh_, static_cast<int>(tet));
        const double smallest = flat_volume * longest * longest * longest;
        if (volume < -smallest) fail(owner, fmt::format("a positive volume (it is inverted: {:.6g} m^3)", volume));
        if (!(volume > smallest)) fail(owner, fmt::format("a positive volume (it is flat: {:.6g} m^3)", volume));
    }

    void check_duplicates() const {
        std::vector<std::pair<std::array<int, 4>, std::size_t>> tets;
        tets.reserve(mesh_.tets.size());
        for (std::size_t i = 0; i < mesh_.tets.size(); ++i) {
            std::array<int, 4> corners = mesh_.tets[i];
            std::sort(corners.begin(), corners.end());
            tets.emplace_back(corners, i);
        }
        std::sort(tets.begin(), tets.end());
        for (std::size_t i = 1; i < tets.size(); ++i) {
            if (tets[i].first != tets[i - 1].first) continue;
            fail(fmt::format("tet {}", tets[i].second + 1), fmt::format("each tet once (it is tet {} again)", tets[i - 1].second + 1));
        }
    }

    void check_faces() const {
        const std::vector<SortedFace> faces = sorted_faces(mesh_);
        for (std::size_t i = 1; i < faces.size(); ++i) {
            if (faces[i].vertices != faces[i - 1].vertices) continue;
            const int first = faces[i - 1].half_face, second = faces[i].half_face;
            if (i >= 2 && faces[i - 2].vertices == faces[i].vertices) {
                fail(fmt::format("tet {}", second / 4 + 1),
                     fmt::format("at most two tets at a face (tets {} and {} share it already)", faces[i - 2].half_face / 4 + 1,
                                 first / 4 + 1));
            }
            if (is_even(first) == is_even(second)) {
                fail(fmt::format("tet {}", second / 4 + 1),
                     fmt::format("no overlap (tet {} lies on the same side of their face)", first / 4 + 1));
            }
        }
    }

    /// Whether the outward order of a face's vertices is an even permutation of the sorted one: differs between neighbours.
    bool is_even(int half_face) const {
        const auto [a, b, c] = face_of(mesh_.tets[half_face / 4], half_face % 4);
        return ((a < b) + (b < c) + (a < c)) % 2 == 1;
    }

    const TetMesh& mesh_;
    const std::string& file_;
};

}  // namespace

void check(const TetMesh& mesh, const std::string& file) { Checker(mesh, file).run(); }

}  // namespace cleave::mesh
