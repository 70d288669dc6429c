#include "solver/mesh/import.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/medit_file.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/obj_file.hpp"
#include "solver/mesh/stl_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>


#include <cstdint>
#include <cstring>

namespace cleave::mesh {
namespace {

using test::cube_surface;

template <class Parse>
std::string complaint(Parse parse, const std::string& text) {
    try {
        parse(text, "body");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

template <class Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string binary_stl(const SurfaceMesh& surface, std::string header = "") {
    header.resize(80, ' ');
    append(header, static_cast<std::uint32_t>(surface.triangles.size()));
    for (const SurfaceTriangle& triangle : surface.triangles) {
        for (int i = 0; i < 3; ++i) append(header, 0.0f);
        for (const int vertex : triangle.vertices) {
            for (const double x : surface.vertices[vertex]) append(header, static_cast<float>(x));
        }
        append(header, std::uint16_t{0});
    }
    return header;
}

std::string ascii_stl(const SurfaceMesh& surface, const std::string& name) {
    std::string text = "solid " + name + "\n";
    for (const SurfaceTriangle& triangle : surface.triangles) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const int vertex : triangle.vertices) {
            const auto& x = surface.vertices[vertex];
            text += fmt::format("  vertex {} {} {}\n", x[0], x[1], x[2]);
        }
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

/// A file that goes with this object.
class File {
public:
    File(const std::string& name, const std::string& content) : path_(folder_ / name) {
        write_file_atomic(path_, content);
    }
    const std::filesystem::path& path() const { return path_; }

private:
    ScratchFolder folder_;
    std::filesystem::path path_;
};

TEST(Stl, AsciiAndBinaryGiveTheSameWeldedCube) {
    const SurfaceMesh ascii = parse_stl(ascii_stl(cube_surface(), "cube"), "a"), binary = parse_stl(binary_stl(cube_surface()), "b");
    const SurfaceMesh disguised = parse_stl(binary_stl(cube_surface(), "solid but binary"), "c");
    for (const SurfaceMesh& surface : {ascii, binary, disguised}) {
        EXPECT_EQ(surface.vertices.size(), 8u);
        EXPECT_EQ(surface.triangles.size(), 12u);
        EXPECT_EQ(enclosed_volume(surface), 1);
        EXPECT_EQ(surface.triangles, ascii.triangles);
    }
}

TEST(Stl, SeveralSolidsArePatches) {
    SurfaceMesh rest = cube_surface(), top = cube_surface();
    rest.triangles.resize(10);
    top.triangles.erase(top.triangles.begin(), top.triangles.begin() + 10);
    const SurfaceMesh surface = parse_stl(ascii_stl(rest, "rest") + ascii_stl(top, "the top"), "a");
    EXPECT_EQ(surface.triangles[9].id, 1);
    EXPECT_EQ(surface.triangles[10].id, 2);
    EXPECT_EQ(surface.names, (std::map<int, std::string>{{1, "rest"}, {2, "the top"}}));
}

TEST(Stl, NamesWhatIsWrong) {
    EXPECT_EQ(complaint(parse_stl, "solid Empty\nendsolid Empty"), "body: expected at least one facet");
    EXPECT_EQ(complaint(parse_stl, "hello"), "body: expected an STL file (ASCII from 'solid' on, or binary: at least 84 bytes)");
    const std::string text = ascii_stl(cube_surface(), "cube"), bytes = binary_stl(cube_surface());
    EXPECT_EQ(complaint(parse_stl, bytes.substr(0, bytes.size() - 1)), "body: expected 684 bytes for the 12 facets that the header tells, not 683");
    EXPECT_EQ(complaint(parse_stl, text.substr(0, text.find("vertex 0 0") + 9)), "body:4: y: expected a finite number, not ''");
    EXPECT_EQ(complaint(parse_stl, text.substr(0, text.find("endfacet"))), "body:7: facet: expected more rows (the file ends here)");
    std::string bad = text;
    bad.replace(bad.find("vertex"), 6, "vertox");
    EXPECT_EQ(complaint(parse_stl, bad), "body:4: expected 'vertex', not 'vertox 0 0 0'");
    std::string infinite = bytes;
    const float huge = std::numeric_limits<float>::infinity();
    std::memcpy(&infinite[84 + 50 + 12], &huge, 4);
    EXPECT_EQ(complaint(parse_stl, infinite), "body: facet 2: expected finite coordinates");
}

TEST(Obj, ReadsQuadsPolygonsAndNegativeNumbers) {
    const std::string vertices = "# cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1 0.5 0.5 0.5\nv 1 0 1\nv 0 1 1\nv 1 1 1\nvn 0 0 1\n";
    const std::string quads = "s off\nf 1 5 7 3\nf 2/1 4/2 8/3 6/4\nf 1//1 2//1 6//1 5//1\nf -6/1/1 -2/1/1 -1/1/1 -5/1/1\nf 1 3 4 2\nf 5 6 8 7\n";
    const SurfaceMesh surface = parse_obj(vertices + quads, "cube.obj");
    EXPECT_EQ(surface.triangles.size(), 12u);
    EXPECT_EQ(enclosed_volume(surface), 1);
    // A pentagon whose fan from the first corner would have a flat triangle (corners 1, 2, 3 on one line).
    const SurfaceMesh pentagon = parse_obj("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4 5\n", "pentagon.obj");
    ASSERT_EQ(pentagon.triangles.size(), 3u);
    double smallest = 1;
    for (int i = 0; i < 3; ++i) smallest = std::min(smallest, area_vector(pentagon, i)[2]);
    EXPECT_EQ(smallest, 0.5);
    EXPECT_EQ(total_area(pentagon), 2);
}

TEST(Obj, RoundTripKeepsBitsAndGroups) {
    SurfaceMesh surface = test::sphere_surface(2);
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) surface.triangles[i].id = i < 50 ? 1 : 2;
    surface.names = {{1, "one"}, {2, "two"}};
    const SurfaceMesh read = parse_obj(format_obj(surface), "again");
    EXPECT_EQ(read.vertices, surface.vertices);
    EXPECT_EQ(read.triangles, surface.triangles);
    EXPECT_EQ(read.names, surface.names);
}

TEST(Obj, NamesWhatIsWrong) {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(complaint(parse_obj, v), "body:3: expected at least one face (an 'f' row)");
    EXPECT_EQ(complaint(parse_obj, v + "f 1 2\n"), "body:4: f: expected three corners or more (this face has 2)");
    std::string polygon = "f";
    for (int corner = 0; corner < 1001; ++corner) polygon += " 1";
    EXPECT_EQ(complaint(parse_obj, v + polygon + "\n"), "body:4: f: expected at most 1000 corners (this face has 1001: split it)");
    EXPECT_EQ(complaint(parse_obj, v + "f 1 2 4\n"), "body:4: f: expected vertices from 1 to 3, not 4");
    EXPECT_EQ(complaint(parse_obj, v + "f 1 2 0\n"), "body:4: f: expected vertices from 1 to 3, not 0");
    EXPECT_EQ(complaint(parse_obj, v + "f 1 2 x/1\n"), "body:4: f: expected vertex numbers, not 'x/1'");
    EXPECT_EQ(complaint(parse_obj, "v 0 0\n"), "body:1: z: expected a finite number, not ''");
    EXPECT_EQ(complaint(parse_obj, "curv 0 0\n"), "body:1: expected a row of an .obj file (v, vn, vt, f, g, o, ...), not 'curv'");
}

TEST(Medit, RoundTripKeepsEverything) {
    TetMesh mesh = test::kuhn_cube(2, 0.1);
    mesh.regions[5] = 7;
    mesh.surface = {{{0, 1, 2}, 3}};
    const TetMesh read = std::get<TetMesh>(parse_medit(format_medit(mesh), "again"));
    EXPECT_EQ(format_msh(read), format_msh(mesh));
}

TEST(Medit, TrianglesAloneAreASurface) {
    const std::string text = "MeshVersionFormatted 1\nDimension\n3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n# a remark\nCorners 1\n1\n"
                             "Triangles\n4\n1 3 2 1\n1 2 4 2\n1 4 3 2\n2 3 4 2\nEnd\n";
    const SurfaceMesh surface = std::get<SurfaceMesh>(parse_medit(text, "tet.mesh"));
    EXPECT_DOUBLE_EQ(enclosed_volume(surface), 1.0 / 6);
    EXPECT_EQ(surface.triangles[1].id, 2);
}

TEST(Medit, NamesWhatIsWrong) {
    const std::string head = "MeshVersionFormatted 2\nDimension 3\n", vertices = "Vertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n";
    EXPECT_EQ(complaint(parse_medit, "hello"), "body:1: expected a Medit file, which starts with MeshVersionFormatted");
    EXPECT_EQ(complaint(parse_medit, "MeshVersionFormatted 2\nDimension 2\n"), "body:2: Dimension: expected 3");
    EXPECT_EQ(complaint(parse_medit, head + vertices), "body: expected tets (Tetrahedra) or a surface (Triangles)");
    EXPECT_EQ(complaint(parse_medit, head + "Triangles 1\n1 2 3 0\n"), "body:3: Triangles: expected the Vertices before them");
    EXPECT_EQ(complaint(parse_medit, head + vertices + "Triangles\n1\n1 2 4 0\n"), "body:10: vertex: expected 1 to 3, not 4");
    EXPECT_EQ(complaint(parse_medit, head + vertices + "Triangles\n2\n1 2 3 0\n"), "body:10: Triangles: expected more rows (the file ends here)");
    EXPECT_EQ(complaint(parse_medit, head + "Vertices 9999\n0 0 0 0\n"), "body:3: number of vertices: expected a count that the file can hold, not 9999");
}

TEST(Import, TurnsTetsOverWhereAllAreInverted) {
    TetMesh mesh = test::kuhn_cube(2);
    for (auto& tet : mesh.tets) std::swap(tet[1], tet[2]);
    const File inverted("inverted.mesh", format_medit(mesh)), as_msh("inverted.msh", format_msh(mesh));
    EXPECT_NEAR(total_volume(std::get<TetMesh>(import_mesh(inverted.path()))), 1, 1e-14);
    EXPECT_THROW(import_mesh(as_msh.path()), InputError);  // both solvers read that file as it is
    std::swap(mesh.tets[3][1], mesh.tets[3][2]);
    const File mixed("mixed.mesh", format_medit(mesh));
    EXPECT_THROW(import_mesh(mixed.path()), InputError);
}

TEST(Import, ChecksSurfacesAndRefusesUnknownEndings) {
    SurfaceMesh surface = cube_surface();
    const File cube("cube.OBJ", format_obj(surface)), step("cube.step", "ISO-10303-21;");
    EXPECT_EQ(std::get<SurfaceMesh>(import_mesh(cube.path())).triangles.back().id, 6);  // six sides, parted at the sharp edges
    surface.triangles.pop_back();
    const File open("open.obj", format_obj(surface));
    EXPECT_THROW(import_mesh(open.path()), InputError);
    try {
        import_mesh(step.path());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.expected(), "a file that ends in one of .msh, .mesh, .vtu, .stl, .obj");
    }
}

}  // namespace
}  // namespace cleave::mesh
