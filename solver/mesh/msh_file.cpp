#include "solver/mesh/msh_file.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/row_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace cleave::mesh {
namespace {

enum class Format { v2, v4 };

/// Gmsh's numbers of the element types this reader knows, and their node counts (0: unknown).
constexpr int triangle_type = 2, tet_type = 4;
int node_count(long type) {
    switch (type) {
        case 15: return 1;  // point
        case 1: return 2;   // line
        case triangle_type: return 3;
        case tet_type: return 4;
        default: return 0;
    }
}

struct Element {
    std::array<long, 4> nodes{};  ///< node tags of the file
    int tag = 0;
    int line = 0;
};

/// Everything as it stands in the file; node tags are resolved once all sections are read.
struct RawMesh {
    Format format = Format::v2;
    bool has_nodes = false;
    std::vector<std::pair<long, int>> node_tags;  ///< (tag, vertex)
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Element> triangles;
    std::vector<Element> tets;
    std::map<std::pair<long, long>, int> physical;  ///< (dimension, entity) -> first physical tag
    std::map<int, std::string> region_names;
    std::map<int, std::string> surface_names;
};

int small_tag(RowScanner& scan, const char* what) {
    constexpr long most = 1'000'000'000;
    const long tag = scan.integer(what);
    if (tag > most || tag < -most) scan.fail(what, "a tag of at most 10^9");
    return static_cast<int>(std::abs(tag));  // a negative tag marks a reversed entity
}

void end_section(RowScanner& scan, const std::string& section) {
    if (!scan.next_row() || scan.text() != "$End" + section) scan.fail("$" + section, "$End" + section);
}

void read_format(RowScanner& scan, RawMesh& raw) {
    scan.row("MeshFormat");
    const std::string_view version = scan.text().substr(0, scan.text().find_first_of(" \t"));
    if (version != "2.2" && version != "4.1") scan.fail("MeshFormat", "version 2.2 or 4.1, not " + std::string(version.substr(0, 20)));
    raw.format = version == "2.2" ? Format::v2 : Format::v4;
    scan.real("version");
    if (scan.integer("file type") != 0) scan.fail("MeshFormat", "an ASCII file (this one is binary: save it with Mesh.Binary = 0)");
    end_section(scan, "MeshFormat");
}

void read_names(RowScanner& scan, RawMesh& raw) {
    scan.row("PhysicalNames");
    const std::size_t count = scan.count("number of names");
    for (std::size_t i = 0; i < count; ++i) {
        scan.row("PhysicalNames");
        const long dimension = scan.integer("dimension");
        const int tag = small_tag(scan, "physical tag");
        const std::string_view text = scan.text();
        const std::size_t first = text.find('"');
        const std::size_t last = text.rfind('"');
        if (first == std::string_view::npos || first == last) scan.fail("PhysicalNames", "a name in quotes");
        const std::string name(text.substr(first + 1, last - first - 1));
        if (dimension == 3) raw.region_names[tag] = name;
        if (dimension == 2) raw.surface_names[tag] = name;
    }
    end_section(scan, "PhysicalNames");
}

void read_entities(RowScanner& scan, RawMesh& raw) {
    scan.row("Entities");
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = scan.count("number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
        for (std::size_t i = 0; i < counts[dimension]; ++i) {
            scan.row("Entities");
            const long entity = scan.integer("entity tag");
            for (int box = 0; box < (dimension == 0 ? 3 : 6); ++box) scan.real("entity's box");
            const std::size_t tags = scan.count("number of physical tags");
            if (tags > 0) raw.physical[{dimension, entity}] = small_tag(scan, "physical tag");
        }
    }
    end_section(scan, "Entities");
}

void read_coordinates(RowScanner& scan, RawMesh& raw) {
    const double x = scan.real("x"), y = scan.real("y"), z = scan.real("z");
    raw.vertices.emplace_back(x, y, z);
}

void read_nodes_v2(RowScanner& scan, RawMesh& raw) {
    scan.row("Nodes");
    const std::size_t count = scan.count("number of nodes");
    raw.vertices.reserve(count);
    raw.node_tags.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        scan.row("Nodes");
        raw.node_tags.emplace_back(scan.integer("node tag"), static_cast<int>(raw.vertices.size()));
        read_coordinates(scan, raw);
        scan.end_row("Nodes");
    }
}

void read_nodes_v4(RowScanner& scan, RawMesh& raw) {
    scan.row("Nodes");
    const std::size_t blocks = scan.count("number of node blocks");
    const std::size_t total = scan.count("number of nodes");
    raw.vertices.reserve(total);
    raw.node_tags.reserve(total);
    for (std::size_t block = 0; block < blocks; ++block) {
        scan.row("Nodes");
        scan.integer("entity dimension");
        scan.integer("entity tag");
        const bool parametric = scan.integer("parametric") != 0;
        const std::size_t count = scan.count("number of nodes in the block");
        for (std::size_t i = 0; i < count; ++i) {
            scan.row("Nodes");
            raw.node_tags.emplace_back(scan.integer("node tag"), static_cast<int>(raw.vertices.size() + i));
            scan.end_row("Nodes");
        }
        for (std::size_t i = 0; i < count; ++i) {
            scan.row("Nodes");
            read_coordinates(scan, raw);
            if (!parametric) scan.end_row("Nodes");
        }
    }
    if (raw.vertices.size() != total) {
        scan.fail("Nodes", fmt::format("{} nodes as the section's head says, not {}", total, raw.vertices.size()));
    }
}

void read_nodes(RowScanner& scan, RawMesh& raw) {
    if (std::exchange(raw.has_nodes, true)) scan.fail("Nodes", "one section of nodes");
    raw.format == Format::v2 ? read_nodes_v2(scan, raw) : read_nodes_v4(scan, raw);
    end_section(scan, "Nodes");
    std::sort(raw.node_tags.begin(), raw.node_tags.end());
    const auto twice = std::adjacent_find(raw.node_tags.begin(), raw.node_tags.end(),
                                          [](const auto& left, const auto& right) { return left.first == right.first; });
    if (twice != raw.node_tags.end()) scan.fail("Nodes", fmt::format("each node once (tag {} stands twice)", twice->first));
}

int checked_node_count(RowScanner& scan, long type) {
    const int nodes = node_count(type);
    if (nodes == 0) scan.fail("Elements", fmt::format("points, lines, 3-node triangles and 4-node tets, not Gmsh's element type {}", type));
    return nodes;
}

/// Reads the node tags at the end of an element's row and keeps tets and tagged triangles.
void read_element_nodes(RowScanner& scan, RawMesh& raw, long type, int nodes, int tag) {
    Element element{.tag = tag, .line = scan.line()};
    for (int node = 0; node < nodes; ++node) element.nodes[node] = scan.integer("node tag of an element");
    scan.end_row("Elements");
    if (type == tet_type) raw.tets.push_back(element);
    if (type == triangle_type && tag != 0) raw.triangles.push_back(element);
}

void read_elements_v2(RowScanner& scan, RawMesh& raw) {
    scan.row("Elements");
    const std::size_t count = scan.count("number of elements");
    for (std::size_t i = 0; i < count; ++i) {
        scan.row("Elements");
        scan.integer("element tag");
        const long type = scan.integer("element type");
        const int nodes = checked_node_count(scan, type);
        const std::size_t tags = scan.count("number of tags");
        int physical = 0;
        for (std::size_t tag = 0; tag < tags; ++tag) {
            const int value = small_tag(scan, "tag of an element");
            if (tag == 0) physical = value;
        }
        read_element_nodes(scan, raw, type, nodes, physical);
    }
}

void read_elements_v4(RowScanner& scan, RawMesh& raw) {
    scan.row("Elements");
    const std::size_t blocks = scan.count("number of element blocks");
    const std::size_t total = scan.count("number of elements");
    std::size_t found = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        scan.row("Elements");
        const long dimension = scan.integer("entity dimension");
        const long entity = scan.integer("entity tag");
        const long type = scan.integer("element type");
        const int nodes = checked_node_count(scan, type);
        const std::size_t count = scan.count("number of elements in the block");
        const auto physical = raw.physical.find({dimension, entity});
        const int tag = physical == raw.physical.end() ? 0 : physical->second;
        for (std::size_t i = 0; i < count; ++i) {
            scan.row("Elements");
            scan.integer("element tag");
            read_element_nodes(scan, raw, type, nodes, tag);
        }
        found += count;
    }
    if (found != total) scan.fail("Elements", fmt::format("{} elements as the section's head says, not {}", total, found));
}

void read_elements(RowScanner& scan, RawMesh& raw) {
    raw.format == Format::v2 ? read_elements_v2(scan, raw) : read_elements_v4(scan, raw);
    end_section(scan, "Elements");
}

void skip_section(RowScanner& scan, const std::string& section) {
    while (scan.next_row()) {
        if (scan.text() == "$End" + section) return;
    }
    scan.fail("$" + section, "$End" + section + " (the file ends here)");
}

RawMesh read_sections(RowScanner& scan) {
    RawMesh raw;
    if (!scan.next_row() || scan.text() != "$MeshFormat") scan.fail("", "a Gmsh .msh file, which starts with $MeshFormat");
    read_format(scan, raw);
    while (scan.next_row()) {
        const std::string_view head = scan.text();
        if (head.front() != '$') scan.fail("", "a section that starts with '$'");
        const std::string section(head.substr(1));
        if (section == "PhysicalNames") read_names(scan, raw);
        else if (section == "Entities" && raw.format == Format::v4) read_entities(scan, raw);
        else if (section == "Nodes") read_nodes(scan, raw);
        else if (section == "Elements") read_elements(scan, raw);
        else skip_section(scan, section);
    }
    return raw;
}

template <std::size_t count>
std::array<int, count> vertices_of(const RawMesh& raw, const Element& element, const RowScanner& scan) {
    std::array<int, count> vertices{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto found = std::lower_bound(raw.node_tags.begin(), raw.node_tags.end(), std::pair<long, int>(element.nodes[i], -1));
        if (found == raw.node_tags.end() || found->first != element.nodes[i]) {
            throw InputError(scan.name(), element.line, "Elements", fmt::format("a node that exists, not {}", element.nodes[i]));
        }
        vertices[i] = found->second;
    }
    return vertices;
}

TetMesh resolved(RawMesh raw, const RowScanner& scan) {
    if (!raw.has_nodes) throw InputError(scan.name(), "$Nodes", "a section of nodes");
    if (raw.tets.empty()) throw InputError(scan.name(), "$Elements", "at least one 4-node tet (a surface mesh has to be meshed first)");
    TetMesh mesh;
    mesh.tets.reserve(raw.tets.size());
    mesh.regions.reserve(raw.tets.size());
    mesh.surface.reserve(raw.triangles.size());
    for (const Element& tet : raw.tets) {
        mesh.tets.push_back(vertices_of<4>(raw, tet, scan));
        mesh.regions.push_back(tet.tag);
    }
    for (const Element& triangle : raw.triangles) mesh.surface.push_back({vertices_of<3>(raw, triangle, scan), triangle.tag});
    mesh.vertices = std::move(raw.vertices);
    mesh.region_names = std::move(raw.region_names);
    mesh.surface_names = std::move(raw.surface_names);
    return mesh;
}

void append_names(std::string& text, const TetMesh& mesh) {
    if (mesh.region_names.empty() && mesh.surface_names.empty()) return;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "$PhysicalNames\n{}\n", mesh.region_names.size() + mesh.surface_names.size());
    for (const auto& [tag, name] : mesh.surface_names) fmt::format_to(out, "2 {} \"{}\"\n", tag, name);
    for (const auto& [tag, name] : mesh.region_names) fmt::format_to(out, "3 {} \"{}\"\n", tag, name);
    text += "$EndPhysicalNames\n";
}

}  // namespace

TetMesh parse_msh(std::string_view text, const std::string& name) {
    RowScanner scan(text, name);
    RawMesh raw = read_sections(scan);
    return resolved(std::move(raw), scan);
}

TetMesh read_msh(const std::filesystem::path& path) { return parse_msh(read_file(path), path.string()); }

std::string format_msh(const TetMesh& mesh) {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    append_names(text, mesh);
    auto out = std::back_inserter(text);
    fmt::format_to(out, "$Nodes\n{}\n", mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Eigen::Vector3d& x = mesh.vertices[i];
        fmt::format_to(out, "{} {:.17g} {:.17g} {:.17g}\n", i + 1, x[0], x[1], x[2]);
    }
    fmt::format_to(out, "$EndNodes\n$Elements\n{}\n", mesh.surface.size() + mesh.tets.size());
    std::size_t number = 0;
    for (const SurfaceTriangle& triangle : mesh.surface) {
        const auto& [a, b, c] = triangle.vertices;
        fmt::format_to(out, "{} 2 2 {} {} {} {} {}\n", ++number, triangle.id, triangle.id, a + 1, b + 1, c + 1);
    }
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const auto& [a, b, c, d] = mesh.tets[tet];
        const int region = mesh.regions[tet];
        fmt::format_to(out, "{} 4 2 {} {} {} {} {} {}\n", ++number, region, std::max(region, 1), a + 1, b + 1, c + 1, d + 1);
    }
    return text + "$EndElements\n";
}

void write_msh(const TetMesh& mesh, const std::filesystem::path& path) { write_file_atomic(path, format_msh(mesh)); }

}  // namespace cleave::mesh
