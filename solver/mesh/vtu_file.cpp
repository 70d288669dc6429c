#include "solver/mesh/vtu_file.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/vtu_data.hpp"
#include "solver/mesh/xml_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace cleave::mesh {
namespace {

/// VTK's numbers of the cell types this reader knows.
constexpr std::size_t vertex_type = 1, line_type = 3, triangle_type = 5, tet_type = 10;

class VtuReader {
public:
    VtuReader(std::string_view bytes, const std::string& name) : tags_(xml_tags(bytes, name, "AppendedData")) { storage_.file = name; }

    std::variant<TetMesh, SurfaceMesh> read() {
        read_storage();
        find_piece();
        read_points();
        read_cells();
        if (!mesh_.tets.empty()) return tet_mesh();
        if (mesh_.surface.empty()) throw InputError(storage_.file, "Cells", "tets (type 10) or a surface of triangles (type 5)");
        return SurfaceMesh{std::move(mesh_.vertices), std::move(mesh_.surface), {}};
    }

private:
    [[noreturn]] void fail(const XmlTag& tag, const std::string& expected) const { throw InputError(storage_.file, tag.line, tag.name, expected); }

    static std::string attribute(const XmlTag& tag, const std::string& name) {
        const auto found = tag.attributes.find(name);
        return found == tag.attributes.end() ? "" : found->second;
    }

    const XmlTag* find(std::string_view name, std::string_view parent, std::string_view array = {}) const {
        for (const XmlTag& tag : tags_) {
            if (tag.name == name && tag.parent == parent && (array.empty() || attribute(tag, "Name") == array)) return &tag;
        }
        return nullptr;
    }

    void read_storage() {
        if (tags_.empty() || tags_.front().name != "VTKFile") throw InputError(storage_.file, "", "a VTK XML file, which starts with <VTKFile>");
        const XmlTag& root = tags_.front();
        if (attribute(root, "type") != "UnstructuredGrid") fail(root, fmt::format("type UnstructuredGrid, not '{}'", attribute(root, "type")));
        if (attribute(root, "byte_order") == "BigEndian") fail(root, "byte_order LittleEndian");
        storage_.header_bytes = attribute(root, "header_type") == "UInt64" ? 8 : 4;
        const std::string compressor = attribute(root, "compressor");
        storage_.compressed = !compressor.empty();
        if (storage_.compressed && compressor != "vtkZLibDataCompressor") fail(root, fmt::format("no compressor or vtkZLibDataCompressor, not '{}'", compressor));
        if (const XmlTag* data = find("AppendedData", "VTKFile")) {
            const std::size_t start = data->text.find('_');
            if (start == std::string_view::npos) fail(*data, "'_' before the data");
            storage_.appended = data->text.substr(start + 1);
            storage_.appended_is_base64 = attribute(*data, "encoding") == "base64";
        }
    }

    void find_piece() const {
        const auto pieces = std::count_if(tags_.begin(), tags_.end(), [](const XmlTag& tag) { return tag.name == "Piece"; });
        if (pieces != 1) throw InputError(storage_.file, "Piece", fmt::format("one piece, not {}", pieces));
    }

    std::vector<double> numbers(std::string_view parent, std::string_view array) const {
        const XmlTag* tag = find("DataArray", parent, array);
        if (tag == nullptr) throw InputError(storage_.file, std::string(parent), fmt::format("a DataArray {}", array));
        return vtu_numbers(*tag, storage_);
    }

    std::size_t size_of_piece(const std::string& name) const {
        const XmlTag& piece = *find("Piece", "UnstructuredGrid");
        const std::string text = attribute(piece, name);
        std::size_t size = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
        if (error != std::errc() || end != text.data() + text.size()) fail(piece, fmt::format("{} as a number, not '{}'", name, text));
        return size;
    }

    void require(bool right, const std::string& key, const std::string& expected) const {
        if (!right) throw InputError(storage_.file, key, expected);
    }

    void read_points() {
        require(find("Piece", "UnstructuredGrid") != nullptr, "Piece", "a Piece inside UnstructuredGrid");
        const std::vector<double> x = numbers("Points", "");
        const std::size_t count = size_of_piece("NumberOfPoints");
        require(x.size() / 3 == count && x.size() % 3 == 0, "Points", fmt::format("3 x {} coordinates, not {}", count, x.size()));
        for (std::size_t i = 0; i < count; ++i) mesh_.vertices.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    }

    /// Numbers that count or point at something: an array of floats may hold others.
    std::vector<std::size_t> whole_numbers(std::string_view array) const {
        constexpr double most = 9007199254740992;  // 2^53: up to here each whole number is a double
        std::vector<std::size_t> whole;
        for (const double number : numbers("Cells", array)) {
            require(number >= 0 && number <= most && number == std::floor(number), fmt::format("Cells {}", array), fmt::format("whole numbers from 0, not {}", number));
            whole.push_back(static_cast<std::size_t>(number));
        }
        return whole;
    }

    /// The first of the arrays that hold regions; empty where none is here.
    std::vector<double> regions(std::size_t cells) const {
        for (const char* array : {"region", "gmsh:physical", "CellEntityIds"}) {
            if (find("DataArray", "CellData", array) == nullptr) continue;
            std::vector<double> values = numbers("CellData", array);
            const bool whole = std::all_of(values.begin(), values.end(), [](double v) { return v >= 0 && v <= 1e9 && v == std::floor(v); });
            require(values.size() == cells && whole, fmt::format("CellData {}", array), fmt::format("{} whole numbers from 0 to 10^9", cells));
            return values;
        }
        return std::vector<double>(cells, 0);
    }

    void read_cells() {
        const std::vector<std::size_t> connectivity = whole_numbers("connectivity"), offsets = whole_numbers("offsets"), types = whole_numbers("types");
        const std::size_t cells = size_of_piece("NumberOfCells");
        require(offsets.size() == cells && types.size() == cells, "Cells", fmt::format("{} offsets and types, not {} and {}", cells, offsets.size(), types.size()));
        const std::vector<double> region = regions(cells);
        std::size_t start = 0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            require(offsets[cell] >= start && offsets[cell] <= connectivity.size(), "Cells offsets", "numbers that grow, up to the length of connectivity");
            add_cell(cell, types[cell], std::span(connectivity).subspan(start, offsets[cell] - start), static_cast<int>(region[cell]));
            start = offsets[cell];
        }
    }

    void add_cell(std::size_t cell, std::size_t type, std::span<const std::size_t> corners, int region) {
        if (type == vertex_type || type == line_type) return;
        const std::string key = fmt::format("cell {}", cell + 1);
        require(type == tet_type || type == triangle_type, key, fmt::format("a linear tet (type 10) or triangle (5), not type {}", type));
        require(corners.size() == (type == tet_type ? 4 : 3), key, fmt::format("{} corners, not {}", type == tet_type ? 4 : 3, corners.size()));
        std::array<int, 4> vertices{};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            require(corners[i] < mesh_.vertices.size(), key, fmt::format("points from 0 to {}, not {}", static_cast<long>(mesh_.vertices.size()) - 1, corners[i]));
            vertices[i] = static_cast<int>(corners[i]);
        }
        if (type == triangle_type) {
            mesh_.surface.push_back({{vertices[0], vertices[1], vertices[2]}, region});
        } else {
            mesh_.tets.push_back(vertices);
            mesh_.regions.push_back(region);
        }
    }

    TetMesh tet_mesh() {
        std::erase_if(mesh_.surface, [](const SurfaceTriangle& triangle) { return triangle.id == 0; });
        return std::move(mesh_);
    }

    std::vector<XmlTag> tags_;
    VtuStorage storage_;
    TetMesh mesh_;
};

void append_array(std::string& text, std::string_view type, std::string_view name, const auto& write) {
    fmt::format_to(std::back_inserter(text), "<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n", type, name);
    write(std::back_inserter(text));
    text += "</DataArray>\n";
}

}  // namespace

std::variant<TetMesh, SurfaceMesh> parse_vtu(std::string_view bytes, const std::string& name) { return VtuReader(bytes, name).read(); }

std::string format_vtu(const TetMesh& mesh) {
    std::string text = fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
                                   "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<CellData>\n", mesh.vertices.size(), mesh.tets.size());
    append_array(text, "Int32", "region", [&](auto out) { for (const int region : mesh.regions) fmt::format_to(out, "{}\n", region); });
    text += "</CellData>\n<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (const Eigen::Vector3d& x : mesh.vertices) fmt::format_to(std::back_inserter(text), "{:.17g} {:.17g} {:.17g}\n", x[0], x[1], x[2]);
    text += "</DataArray>\n</Points>\n<Cells>\n";
    append_array(text, "Int64", "connectivity", [&](auto out) { for (const auto& t : mesh.tets) fmt::format_to(out, "{} {} {} {}\n", t[0], t[1], t[2], t[3]); });
    append_array(text, "Int64", "offsets", [&](auto out) { for (std::size_t i = 1; i <= mesh.tets.size(); ++i) fmt::format_to(out, "{}\n", 4 * i); });
    append_array(text, "UInt8", "types", [&](auto out) { for (std::size_t i = 0; i < mesh.tets.size(); ++i) fmt::format_to(out, "{}\n", tet_type); });
    return text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace cleave::mesh
