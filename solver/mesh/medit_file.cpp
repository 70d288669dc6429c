#include "solver/mesh/medit_file.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/row_scanner.hpp"

#include <fmt/format.h>

#include <cctype>
#include <iterator>
#include <utility>

namespace cleave::mesh {
namespace {

/// Rows of "a b c ... reference".
template <std::size_t corners>
struct Elements {
    std::vector<std::array<int, corners>> vertices;
    std::vector<int> references;
};

class MeditReader {
public:
    MeditReader(std::string_view text, const std::string& name) : scan_(text, name) {}

    std::variant<TetMesh, SurfaceMesh> read() {
        if (!next_row() || scan_.word() != "MeshVersionFormatted") scan_.fail("", "a Medit file, which starts with MeshVersionFormatted");
        bool ended = false;
        while (!ended && next_row()) ended = !read_section();
        if (!tets_.vertices.empty()) return tet_mesh();
        if (triangles_.vertices.empty()) throw InputError(scan_.name(), "", "tets (Tetrahedra) or a surface (Triangles)");
        return surface();
    }

private:
    /// The next row that is no comment.
    bool next_row() {
        while (scan_.next_row()) {
            if (scan_.text().front() != '#') return true;
        }
        return false;
    }

    void needed_row(const char* what) {
        if (!next_row()) scan_.fail(what, "more rows (the file ends here)");
    }

    /// The count behind a keyword: on its row or on the next.
    std::size_t count(const char* what) {
        if (scan_.rest().empty()) needed_row(what);
        return scan_.count(what);
    }

    bool read_section() {
        const std::string keyword(scan_.word());
        if (keyword == "End") return false;
        if (keyword == "Dimension") read_dimension();
        else if (keyword == "Vertices") read_vertices();
        else if (keyword == "Tetrahedra") read_elements(tets_, "Tetrahedra");
        else if (keyword == "Triangles") read_elements(triangles_, "Triangles");
        else if (!keyword.empty() && std::isalpha(static_cast<unsigned char>(keyword.front()))) skip_section();
        else scan_.fail("", fmt::format("a section of a Medit file, not '{}'", keyword.substr(0, 40)));
        return true;
    }

    void skip_section() {
        for (std::size_t left = count("number of rows"); left > 0; --left) needed_row("section");
    }

    void read_dimension() {
        if (scan_.rest().empty()) needed_row("Dimension");
        if (scan_.integer("Dimension") != 3) scan_.fail("Dimension", "3");
    }

    void read_vertices() {
        if (!vertices_.empty()) scan_.fail("Vertices", "one section of vertices");
        const std::size_t total = count("number of vertices");
        for (std::size_t i = 0; i < total; ++i) {
            needed_row("Vertices");
            const double x = scan_.real("x"), y = scan_.real("y"), z = scan_.real("z");
            scan_.integer("reference");
            scan_.end_row("Vertices");
            vertices_.emplace_back(x, y, z);
        }
    }

    template <std::size_t corners>
    void read_elements(Elements<corners>& elements, const char* what) {
        if (vertices_.empty()) scan_.fail(what, "the Vertices before them");
        const std::size_t total = count(what);
        for (std::size_t i = 0; i < total; ++i) {
            needed_row(what);
            std::array<int, corners> element{};
            for (int& vertex : element) vertex = read_vertex();
            elements.vertices.push_back(element);
            elements.references.push_back(read_reference());
            scan_.end_row(what);
        }
    }

    int read_vertex() {
        const long number = scan_.integer("vertex");
        if (number < 1 || static_cast<std::size_t>(number) > vertices_.size()) {
            scan_.fail("vertex", fmt::format("1 to {}, not {}", vertices_.size(), number));
        }
        return static_cast<int>(number) - 1;
    }

    int read_reference() {
        const long reference = scan_.integer("reference");
        if (reference < 0 || reference > 1'000'000'000) scan_.fail("reference", fmt::format("0 to 10^9, not {}", reference));
        return static_cast<int>(reference);
    }

    TetMesh tet_mesh() {
        TetMesh mesh;
        mesh.vertices = std::move(vertices_);
        mesh.tets = std::move(tets_.vertices);
        mesh.regions = std::move(tets_.references);
        for (std::size_t i = 0; i < triangles_.vertices.size(); ++i) {
            if (triangles_.references[i] != 0) mesh.surface.push_back({triangles_.vertices[i], triangles_.references[i]});
        }
        return mesh;
    }

    SurfaceMesh surface() {
        SurfaceMesh surface;
        surface.vertices = std::move(vertices_);
        for (std::size_t i = 0; i < triangles_.vertices.size(); ++i) {
            surface.triangles.push_back({triangles_.vertices[i], triangles_.references[i]});
        }
        return surface;
    }

    RowScanner scan_;
    std::vector<Eigen::Vector3d> vertices_;
    Elements<4> tets_;
    Elements<3> triangles_;
};

}  // namespace

std::variant<TetMesh, SurfaceMesh> parse_medit(std::string_view text, const std::string& name) { return MeditReader(text, name).read(); }

std::string format_medit(const TetMesh& mesh) {
    std::string text = "MeshVersionFormatted 2\nDimension 3\n";
    auto out = std::back_inserter(text);
    fmt::format_to(out, "Vertices\n{}\n", mesh.vertices.size());
    for (const Eigen::Vector3d& x : mesh.vertices) fmt::format_to(out, "{:.17g} {:.17g} {:.17g} 0\n", x[0], x[1], x[2]);
    fmt::format_to(out, "Triangles\n{}\n", mesh.surface.size());
    for (const SurfaceTriangle& triangle : mesh.surface) {
        const auto [a, b, c] = triangle.vertices;
        fmt::format_to(out, "{} {} {} {}\n", a + 1, b + 1, c + 1, triangle.id);
    }
    fmt::format_to(out, "Tetrahedra\n{}\n", mesh.tets.size());
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
        const auto [a, b, c, d] = mesh.tets[i];
        fmt::format_to(out, "{} {} {} {} {}\n", a + 1, b + 1, c + 1, d + 1, mesh.regions[i]);
    }
    return text + "End\n";
}

}  // namespace cleave::mesh
