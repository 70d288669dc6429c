#include "solver/mesh/obj_file.hpp"

#include "solver/mesh/row_scanner.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

namespace cleave::mesh {
namespace {

/// Triangulating a face takes the square of its corners.
constexpr std::size_t most_corners = 1000;

/// Keywords that say nothing about the shape.
bool is_decoration(std::string_view word) {
    static constexpr std::string_view known[] = {"vn", "vt", "vp", "s", "usemtl", "mtllib", "l", "p"};
    return std::find(std::begin(known), std::end(known), word) != std::end(known);
}

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name) : scan_(text, name) {}

    SurfaceMesh read() {
        while (scan_.next_row()) read_row();
        if (surface_.triangles.empty()) scan_.fail("", "at least one face (an 'f' row)");
        name_patches();
        return std::move(surface_);
    }

private:
    void read_row() {
        const std::string_view word = scan_.word();
        if (word.front() == '#' || is_decoration(word)) return;
        if (word == "v") read_vertex();
        else if (word == "f") read_face();
        else if (word == "g") group_ = scan_.rest();
        else if (word == "o") object_ = scan_.rest(), group_.clear();
        else scan_.fail("", fmt::format("a row of an .obj file (v, vn, vt, f, g, o, ...), not '{}'", word.substr(0, 40)));
    }

    void read_vertex() {
        const double x = scan_.real("x"), y = scan_.real("y"), z = scan_.real("z");
        surface_.vertices.emplace_back(x, y, z);
    }

    /// The vertex of a corner "a", "a/t", "a//n" or "a/t/n".
    int corner(std::string_view word) {
        const std::string_view number = word.substr(0, word.find('/'));
        long value = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
        if (error != std::errc() || end != number.data() + number.size()) {
            scan_.fail("f", fmt::format("vertex numbers, not '{}'", word.substr(0, 40)));
        }
        const long count = static_cast<long>(surface_.vertices.size());
        const long vertex = value < 0 ? count + value : value - 1;
        if (value == 0 || vertex < 0 || vertex >= count) scan_.fail("f", fmt::format("vertices from 1 to {}, not {}", count, value));
        return static_cast<int>(vertex);
    }

    void read_face() {
        std::vector<int> corners;
        for (std::string_view word = scan_.word(); !word.empty(); word = scan_.word()) corners.push_back(corner(word));
        if (corners.size() < 3) scan_.fail("f", fmt::format("three corners or more (this face has {})", corners.size()));
        if (corners.size() > most_corners) scan_.fail("f", fmt::format("at most {} corners (this face has {}: split it)", most_corners, corners.size()));
        std::rotate(corners.begin(), corners.begin() + best_apex(corners), corners.end());
        const int patch = patch_of(group_.empty() ? object_ : group_);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) surface_.triangles.push_back({{corners[0], corners[i], corners[i + 1]}, patch});
    }

    /// Twice the area of the smallest triangle of the fan around a corner, along the polygon's own normal (negative where one turns over).
    double smallest_of_fan(const std::vector<int>& polygon, std::size_t apex) const {
        const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& { return surface_.vertices[polygon[(apex + i) % polygon.size()]]; };
        const auto twice_area = [&](std::size_t i) -> Eigen::Vector3d { return (corner(i) - corner(0)).cross(corner(i + 1) - corner(0)); };
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) normal += twice_area(i);
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) smallest = std::min(smallest, twice_area(i).dot(normal.normalized()));
        return smallest;
    }

    long best_apex(const std::vector<int>& polygon) const {
        std::size_t best = 0;
        if (polygon.size() == 3) return 0;
        for (std::size_t apex = 1; apex < polygon.size(); ++apex) {
            // Rounding must not decide: a square's diagonals are equally good.
            if (smallest_of_fan(polygon, apex) > (1 + 1e-9) * smallest_of_fan(polygon, best)) best = apex;
        }
        return static_cast<long>(best);
    }

    int patch_of(const std::string& group) {
        return patches_.try_emplace(group, static_cast<int>(patches_.size()) + 1).first->second;
    }

    /// One group says nothing about the surface; with several, each is a patch.
    void name_patches() {
        if (patches_.size() < 2) {
            for (SurfaceTriangle& triangle : surface_.triangles) triangle.id = 0;
            return;
        }
        for (const auto& [group, patch] : patches_) {
            if (!group.empty()) surface_.names[patch] = group;
        }
    }

    RowScanner scan_;
    SurfaceMesh surface_;
    std::string object_, group_;
    std::map<std::string, int> patches_;  ///< groups that hold faces, numbered in the order of their first face
};

}  // namespace

SurfaceMesh parse_obj(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

std::string format_obj(const SurfaceMesh& surface) {
    std::string text;
    auto out = std::back_inserter(text);
    for (const Eigen::Vector3d& x : surface.vertices) fmt::format_to(out, "v {:.17g} {:.17g} {:.17g}\n", x[0], x[1], x[2]);
    int patch = 0;
    for (const SurfaceTriangle& triangle : surface.triangles) {
        if (triangle.id != patch) {
            patch = triangle.id;
            const auto name = surface.names.find(patch);
            fmt::format_to(out, "g {}\n", name == surface.names.end() ? std::to_string(patch) : name->second);
        }
        const auto [a, b, c] = triangle.vertices;
        fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
    }
    return text;
}

}  // namespace cleave::mesh
