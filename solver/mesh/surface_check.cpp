#include "solver/mesh/surface_check.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/surface_edges.hpp"
#include "solver/mesh/surface_intersection.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cleave::mesh {
namespace {

/// An area below this part of the longest edge squared is rounding, not shape.
constexpr double flat_area = 1e-12;

class SurfaceChecker {
public:
    SurfaceChecker(const SurfaceMesh& surface, const std::string& file) : surface_(surface), file_(file) {}

    void run() const {
        if (surface_.triangles.empty()) fail("", "at least one triangle");
        check_vertices();
        for (std::size_t i = 0; i < surface_.triangles.size(); ++i) check_triangle(i);
        check_welded();
        check_duplicates();
        check_edges();
        check_fans();
        check_one_shell();
        check_outward();
        check_intersections();
    }

private:
    [[noreturn]] void fail(const std::string& key, const std::string& expected) const { throw InputError(file_, key, expected); }
    static std::string triangle(std::size_t number) { return fmt::format("triangle {}", number + 1); }
    static std::string edge(const HalfEdge& e) { return fmt::format("edge from vertex {} to {}", e.low + 1, e.high + 1); }

    void check_vertices() const {
        for (std::size_t i = 0; i < surface_.vertices.size(); ++i) {
            if (!surface_.vertices[i].allFinite()) fail(fmt::format("vertex {}", i + 1), "finite coordinates");
        }
    }

    void check_triangle(std::size_t number) const {
        const auto& corners = surface_.triangles[number].vertices;
        double longest = 0;
        for (int i = 0; i < 3; ++i) {
            if (corners[i] < 0 || static_cast<std::size_t>(corners[i]) >= surface_.vertices.size()) {
                fail(triangle(number), fmt::format("vertices from 1 to {}, not {}", surface_.vertices.size(), static_cast<long>(corners[i]) + 1));
            }
            for (int j = 0; j < i; ++j) longest = std::max(longest, (surface_.vertices[corners[i]] - surface_.vertices[corners[j]]).norm());
        }
        const double area = area_vector(surface_, static_cast<int>(number)).norm();
        if (!(area > flat_area * longest * longest)) fail(triangle(number), fmt::format("an area (it has {:.6g} m^2)", area));
    }

    /// Vertices that triangles use, sorted by coordinates: equal ones stand together.
    void check_welded() const {
        std::vector<int> used;
        for (const SurfaceTriangle& t : surface_.triangles) used.insert(used.end(), t.vertices.begin(), t.vertices.end());
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        const auto key = [&](int v) {
            const Eigen::Vector3d& x = surface_.vertices[v];
            return std::tuple(x[0], x[1], x[2], v);
        };
        std::sort(used.begin(), used.end(), [&](int i, int j) { return key(i) < key(j); });
        for (std::size_t i = 1; i < used.size(); ++i) {
            if (surface_.vertices[used[i]] != surface_.vertices[used[i - 1]]) continue;
            fail(fmt::format("vertex {}", used[i] + 1), fmt::format("a welded surface (vertex {} stands at the same point)", used[i - 1] + 1));
        }
    }

    void check_duplicates() const {
        std::vector<std::pair<std::array<int, 3>, std::size_t>> sorted;
        for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
            sorted.emplace_back(surface_.triangles[i].vertices, i);
            std::sort(sorted.back().first.begin(), sorted.back().first.end());
        }
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            if (sorted[i].first != sorted[i - 1].first) continue;
            fail(triangle(sorted[i].second), fmt::format("each triangle once (it is triangle {} again)", sorted[i - 1].second + 1));
        }
    }

    void check_edges() const {
        const std::vector<HalfEdge> edges = sorted_edges(surface_);
        const std::size_t open = count_open(edges);
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t last = i + 1;
            while (last < edges.size() && edges[last].low == edges[i].low && edges[last].high == edges[i].high) ++last;
            if (last - i == 1) {
                fail(edge(edges[i]), fmt::format("a closed surface (only triangle {} is here; {} open edges in all)", edges[i].triangle + 1, open));
            }
            if (last - i > 2) fail(edge(edges[i]), fmt::format("a manifold surface ({} triangles share it)", last - i));
            if (edges[i].ascending == edges[i + 1].ascending) {
                fail(edge(edges[i]), fmt::format("triangles {} and {} to face the same way (one of them is turned over)",
                                                 edges[i].triangle + 1, edges[i + 1].triangle + 1));
            }
            i = last;
        }
    }

    static std::size_t count_open(const std::vector<HalfEdge>& edges) {
        std::size_t open = 0;
        const auto same = [](const HalfEdge& e, const HalfEdge& f) { return e.low == f.low && e.high == f.high; };
        for (std::size_t i = 0; i < edges.size(); ++i) {
            open += !(i > 0 && same(edges[i], edges[i - 1])) && !(i + 1 < edges.size() && same(edges[i], edges[i + 1]));
        }
        return open;
    }

    /// Around each vertex the triangles must form one fan; two mean that sheets touch in a point.
    void check_fans() const {
        const std::vector<std::array<int, 3>> beside = neighbours(surface_);
        std::vector<int> corners(surface_.vertices.size(), 0), first(surface_.vertices.size(), -1);
        for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
            for (const int vertex : surface_.triangles[i].vertices) {
                ++corners[vertex];
                if (first[vertex] < 0) first[vertex] = static_cast<int>(i);
            }
        }
        for (std::size_t vertex = 0; vertex < corners.size(); ++vertex) {
            if (corners[vertex] == 0 || fan_size(static_cast<int>(vertex), first[vertex], beside) == corners[vertex]) continue;
            fail(fmt::format("vertex {}", vertex + 1), "a manifold surface (two sheets touch in this point)");
        }
    }

    int fan_size(int vertex, int first, const std::vector<std::array<int, 3>>& beside) const {
        int size = 0, at = first;
        do {
            const auto& corners = surface_.triangles[at].vertices;
            const auto local = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
            at = beside[at][local];
            ++size;
        } while (at != first);
        return size;
    }

    void check_one_shell() const {
        const std::vector<std::array<int, 3>> beside = neighbours(surface_);
        std::vector<bool> reached(surface_.triangles.size(), false);
        int shells = 0;
        for (std::size_t seed = 0; seed < reached.size(); ++seed) {
            if (reached[seed]) continue;
            ++shells;
            std::vector<int> front{static_cast<int>(seed)};
            reached[seed] = true;
            while (!front.empty()) {
                const int at = front.back();
                front.pop_back();
                for (const int other : beside[at]) {
                    if (!reached[other]) reached[other] = true, front.push_back(other);
                }
            }
        }
        if (shells > 1) fail("", fmt::format("one closed shell (this surface has {}: cavities and loose pieces cannot be meshed)", shells));
    }

    void check_outward() const {
        const double volume = enclosed_volume(surface_);
        if (!(volume > 0)) fail("", fmt::format("triangles that face outwards (the surface is inside out: its volume is {:.6g} m^3)", volume));
    }

    void check_intersections() const {
        if (const auto pair = intersecting_triangles(surface_)) {
            fail(triangle(pair->first), fmt::format("no self-intersection (triangle {} cuts it)", pair->second + 1));
        }
    }

    const SurfaceMesh& surface_;
    const std::string& file_;
};

}  // namespace

void check_surface(const SurfaceMesh& surface, const std::string& file) { SurfaceChecker(surface, file).run(); }

}  // namespace cleave::mesh
