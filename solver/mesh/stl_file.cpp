#include "solver/mesh/stl_file.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/row_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <utility>

namespace cleave::mesh {
namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;
static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

template <class Number>
Number number_at(std::string_view bytes, std::size_t position) {
    Number number;
    std::memcpy(&number, bytes.data() + position, sizeof number);
    return number;
}

/// Gives equal points (as numbers: -0 is 0) one vertex, in the order of their first use.
void weld(SurfaceMesh& surface) {
    const auto& points = surface.vertices;
    std::vector<int> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    const auto key = [&](int i) { return std::tuple(points[i][0], points[i][1], points[i][2], i); };
    std::sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });
    std::vector<int> first(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        first[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];
    }
    std::vector<int> number(points.size(), -1);
    std::vector<Eigen::Vector3d> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (first[i] != static_cast<int>(i)) continue;
        number[i] = static_cast<int>(kept.size());
        kept.push_back(points[i]);
    }
    for (SurfaceTriangle& triangle : surface.triangles) {
        for (int& vertex : triangle.vertices) vertex = number[first[vertex]];
    }
    surface.vertices = std::move(kept);
}

void add_facet(SurfaceMesh& surface, int patch) {
    const int next = static_cast<int>(surface.vertices.size());
    surface.triangles.push_back({{next - 3, next - 2, next - 1}, patch});
}

SurfaceMesh parse_binary(std::string_view bytes, const std::string& name) {
    SurfaceMesh surface;
    for (std::size_t at = header_bytes; at < bytes.size(); at += facet_bytes) {
        for (std::size_t corner = 1; corner <= 3; ++corner) {
            Eigen::Vector3d point;
            for (std::size_t axis = 0; axis < 3; ++axis) point[static_cast<long>(axis)] = number_at<float>(bytes, at + 12 * corner + 4 * axis);
            if (!point.allFinite()) throw InputError(name, fmt::format("facet {}", surface.triangles.size() + 1), "finite coordinates");
            surface.vertices.push_back(point);
        }
        add_facet(surface, 0);
    }
    return surface;
}

class AsciiReader {
public:
    AsciiReader(std::string_view text, const std::string& name) : scan_(text, name) {}

    SurfaceMesh read() {
        while (scan_.next_row()) read_solid();
        if (solids_ < 2) {
            for (SurfaceTriangle& triangle : surface_.triangles) triangle.id = 0;
            surface_.names.clear();
        }
        return std::move(surface_);
    }

private:
    void expect(std::initializer_list<std::string_view> words) {
        for (const std::string_view word : words) {
            if (const std::string_view found = scan_.word(); found != word) {
                scan_.fail("", fmt::format("'{}', not '{}'", fmt::join(words, " "), scan_.text().substr(0, 40)));
            }
        }
    }

    void read_solid() {
        expect({"solid"});
        const int patch = ++solids_;
        if (!scan_.rest().empty()) surface_.names[patch] = scan_.rest();
        for (scan_.needed_row("solid"); !scan_.text().starts_with("endsolid"); scan_.needed_row("solid")) read_facet(patch);
    }

    void read_facet(int patch) {
        expect({"facet", "normal"});
        scan_.needed_row("facet");
        expect({"outer", "loop"});
        for (int corner = 0; corner < 3; ++corner) {
            scan_.needed_row("facet");
            expect({"vertex"});
            const double x = scan_.real("x"), y = scan_.real("y"), z = scan_.real("z");
            scan_.end_row("vertex");
            surface_.vertices.emplace_back(x, y, z);
        }
        scan_.needed_row("facet");
        expect({"endloop"});
        scan_.needed_row("facet");
        expect({"endfacet"});
        add_facet(surface_, patch);
    }

    RowScanner scan_;
    SurfaceMesh surface_;
    int solids_ = 0;
};

/// A binary file may start with "solid", too: what counts is whether its length fits the count of facets.
bool is_binary(std::string_view bytes, const std::string& name) {
    const bool fits = bytes.size() >= header_bytes && bytes.size() == header_bytes + facet_bytes * number_at<std::uint32_t>(bytes, 80);
    if (fits) return true;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && bytes.substr(first).starts_with("solid")) return false;
    if (bytes.size() < header_bytes) throw InputError(name, "", "an STL file (ASCII from 'solid' on, or binary: at least 84 bytes)");
    const auto count = number_at<std::uint32_t>(bytes, 80);
    throw InputError(name, "", fmt::format("{} bytes for the {} facets that the header tells, not {}", header_bytes + facet_bytes * count, count,
                                           bytes.size()));
}

}  // namespace

SurfaceMesh parse_stl(std::string_view bytes, const std::string& name) {
    SurfaceMesh surface = is_binary(bytes, name) ? parse_binary(bytes, name) : AsciiReader(bytes, name).read();
    if (surface.triangles.empty()) throw InputError(name, "", "at least one facet");
    weld(surface);
    return surface;
}

}  // namespace cleave::mesh
