#include "reference_fem/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace cleave::fem {
namespace {

std::string read_text(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    // Reading a folder sets a bad stream only on the first read.
    if (!stream || !(text << stream.rdbuf())) throw Error(fmt::format("{}: cannot be read as a mesh", path));
    return std::move(text).str();
}

/// Words and numbers of an ASCII .msh, one after the other.
class Scanner {
public:
    Scanner(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

    /// The next word; empty at the end of the text.
    std::string_view word() {
        while (position_ < text_.size() && is_space(text_[position_])) ++position_;
        const std::size_t start = position_;
        while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
        return text_.substr(start, position_ - start);
    }

    template <class Number>
    Number number() {
        const std::string_view text = word();
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc::result_out_of_range) fail(fmt::format("number out of range: {}", text));
        if (error != std::errc{} || end != text.data() + text.size()) fail(fmt::format("expected a number, found '{}'", text));
        return value;
    }
    long integer() { return number<long>(); }
    int small_integer() { return number<int>(); }
    double real() {
        const double value = number<double>();
        if (!std::isfinite(value)) fail(fmt::format("expected a finite number, found {}", value));
        return value;
    }

    /// A physical tag; negative ones mark a reversed orientation.
    int tag() {
        const int value = small_integer();
        if (value == std::numeric_limits<int>::min()) fail(fmt::format("number out of range: {}", value));
        return std::abs(value);
    }

    /// A count, bounded by what the file could hold, so that a broken file cannot ask for all memory.
    long count() {
        const long value = integer();
        if (value < 0 || static_cast<std::size_t>(value) > text_.size()) fail(fmt::format("impossible count {}", value));
        return value;
    }

    void skip(long words) {
        while (words-- > 0) word();
    }

    /// Behind the next line that is nothing but the marker.
    void skip_to(std::string_view marker) {
        do {
            position_ = text_.find('\n', position_);
            if (position_ == std::string_view::npos) fail(fmt::format("{} is missing", marker));
            ++position_;
        } while (word() != marker || !at_line_end());
    }

    /// Nodes and elements stand one in a line: words left over mean that the file says something else than is read.
    void end_line() {
        if (!at_line_end()) fail(fmt::format("expected the end of the line, found '{}'", word()));
    }

    void expect(std::string_view marker) {
        const std::string_view found = word();
        if (found != marker) fail(fmt::format("expected {}, found '{}'", marker, found));
    }

    [[noreturn]] void fail(const std::string& what) const {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, text_.size())), '\n');
        throw Error(fmt::format("{}:{}: {}", file_, line, what));
    }

private:
    bool at_line_end() const {
        const std::size_t next = text_.find_first_not_of(" \r\t", position_);
        return next == std::string_view::npos || text_[next] == '\n';
    }

    static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

    std::string file_;
    std::string_view text_;
    std::size_t position_ = 0;
};

constexpr int triangle_type = 2;
constexpr int tet_type = 4;

/// Nodes of an element type, 0 if this reader has no use for it. Types of the Gmsh manual, "MSH file format".
int node_count(int type) {
    switch (type) {
        case 15:
            return 1;  // point
        case 1:
            return 2;  // line
        case 8:
            return 3;  // line of second order
        case triangle_type:
            return 3;
        case tet_type:
            return 4;
        default:
            return 0;
    }
}

/// Collects one file; the section readers differ by format version only.
class MshReader {
public:
    explicit MshReader(const std::string& path) : text_(read_text(path)), scanner_(path, text_) { mesh_.file = path; }

    Mesh read() && {
        scanner_.expect("$MeshFormat");
        read_format();
        for (std::string_view section = scanner_.word(); !section.empty(); section = scanner_.word()) read_section(std::string(section));
        renumber();
        return std::move(mesh_);
    }

private:
    void read_format() {
        const std::string version(scanner_.word());
        if (version != "2.2" && version != "4.1") scanner_.fail(fmt::format("format {} is not read; save as .msh 2.2 or 4.1", version));
        if (scanner_.integer() != 0) scanner_.fail("binary .msh is not read; save it as ASCII");
        scanner_.integer();
        scanner_.expect("$EndMeshFormat");
        version_4_ = version == "4.1";
    }

    void read_section(const std::string& section) {
        if (section.front() != '$') scanner_.fail(fmt::format("expected a section, found '{}'", section));
        if (section == "$Nodes")
            version_4_ ? read_nodes_4() : read_nodes_2();
        else if (section == "$Elements")
            version_4_ ? read_elements_4() : read_elements_2();
        else if (section == "$Entities" && version_4_)
            read_entities();
        else
            return scanner_.skip_to("$End" + section.substr(1));
        scanner_.expect("$End" + section.substr(1));
    }

    void read_nodes_2() {
        for (long left = scanner_.count(); left > 0; --left) {
            const long tag = scanner_.integer();
            add_node(tag, read_point());
            scanner_.end_line();
        }
    }

    void read_nodes_4() {
        long blocks = scanner_.count();
        scanner_.skip(3);  // number of nodes, smallest and largest tag
        for (; blocks > 0; --blocks) {
            const long dimension = read_dimension();
            scanner_.integer();
            const long coordinates = scanner_.integer() != 0 ? dimension : 0;  // parametric coordinates follow x, y, z
            std::vector<long> tags(static_cast<std::size_t>(scanner_.count()));
            for (long& tag : tags) tag = scanner_.integer();
            for (const long tag : tags) {
                add_node(tag, read_point());
                scanner_.skip(coordinates);
                scanner_.end_line();
            }
        }
    }

    int read_dimension() {
        const int dimension = scanner_.small_integer();
        if (dimension < 0 || dimension > 3) scanner_.fail(fmt::format("impossible dimension {}", dimension));
        return dimension;
    }

    Point read_point() {
        const double x = scanner_.real(), y = scanner_.real(), z = scanner_.real();
        return {x, y, z};
    }

    void add_node(long tag, const Point& point) {
        if (!node_of_tag_.emplace(tag, static_cast<int>(mesh_.vertices.size())).second)
            scanner_.fail(fmt::format("node {} stands twice", tag));
        mesh_.vertices.push_back(point);
    }

    /// Tags of the physical groups of each geometric entity: 4.1 keeps them here, 2.2 with each element.
    void read_entities() {
        std::array<long, 4> counts{};
        for (long& count : counts) count = scanner_.count();
        for (int dimension = 0; dimension < 4; ++dimension)
            for (long left = counts[dimension]; left > 0; --left) read_entity(dimension);
    }

    void read_entity(int dimension) {
        const long tag = scanner_.integer();
        scanner_.skip(dimension == 0 ? 3 : 6);  // a point or a box
        std::vector<int>& groups = groups_[{dimension, tag}];
        for (long left = scanner_.count(); left > 0; --left) groups.push_back(scanner_.tag());
        if (dimension > 0) scanner_.skip(scanner_.count());
        scanner_.end_line();
    }

    void read_elements_2() {
        for (long left = scanner_.count(); left > 0; --left) {
            const long tag = scanner_.integer();
            const int type = scanner_.small_integer();
            const long tags = scanner_.count();
            const int group = tags > 0 ? scanner_.tag() : 0;
            scanner_.skip(tags - 1);
            read_element(tag, type, group == 0 ? std::vector<int>{} : std::vector{group});
        }
    }

    void read_elements_4() {
        long blocks = scanner_.count();
        scanner_.skip(3);  // number of elements, smallest and largest tag
        for (; blocks > 0; --blocks) {
            const int dimension = read_dimension();
            const long entity = scanner_.integer();
            const int type = scanner_.small_integer();
            const auto found = groups_.find({dimension, entity});
            const std::vector<int> groups = found == groups_.end() ? std::vector<int>{} : found->second;
            for (long left = scanner_.count(); left > 0; --left) read_element(scanner_.integer(), type, groups);
        }
    }

    void read_element(long tag, int type, const std::vector<int>& groups) {
        const int count = node_count(type);
        if (count == 0) scanner_.fail(fmt::format("element {} has type {}; only linear triangles (2) and tets (4) are read", tag, type));
        std::array<int, 4> nodes{};
        for (int i = 0; i < count; ++i) nodes[i] = node(scanner_.integer(), tag);
        scanner_.end_line();
        if (type == tet_type) add_tet(tag, nodes, groups);
        if (type == triangle_type)
            for (const int group : groups) mesh_.triangles.push_back({{nodes[0], nodes[1], nodes[2]}, group, tag});
    }

    int node(long tag, long element) const {
        const auto found = node_of_tag_.find(tag);
        if (found == node_of_tag_.end()) scanner_.fail(fmt::format("element {} uses node {}, which is not in the file", element, tag));
        return found->second;
    }

    void add_tet(long tag, const std::array<int, 4>& nodes, const std::vector<int>& groups) {
        if (groups.size() > 1) scanner_.fail(fmt::format("tet {} is in {} physical volumes; it must be in one", tag, groups.size()));
        mesh_.cells.push_back(nodes);
        mesh_.cell_regions.push_back(groups.empty() ? 0 : groups.front());
        mesh_.cell_elements.push_back(tag);
    }

    /// Keeps the vertices that tets use. Triangles that touch any other are kept as faces of no tet (vertex -1).
    void renumber() {
        std::vector<int> number(mesh_.vertices.size(), -1);
        for (const auto& cell : mesh_.cells)
            for (const int vertex : cell) number[vertex] = 0;
        std::vector<Point> used;
        for (std::size_t i = 0; i < number.size(); ++i) {
            if (number[i] < 0) continue;
            number[i] = static_cast<int>(used.size());
            used.push_back(mesh_.vertices[i]);
        }
        mesh_.vertices = std::move(used);
        for (auto& cell : mesh_.cells)
            for (int& vertex : cell) vertex = number[vertex];
        for (SurfaceTriangle& triangle : mesh_.triangles)
            for (int& vertex : triangle.vertices) vertex = number[vertex];
    }

    std::string text_;
    Scanner scanner_;
    Mesh mesh_;
    bool version_4_ = false;
    std::map<std::pair<int, long>, std::vector<int>> groups_;
    std::unordered_map<long, int> node_of_tag_;  // looked up only, never walked
};

}  // namespace

Mesh read_msh(const std::string& path) { return MshReader(path).read(); }

}  // namespace cleave::fem
