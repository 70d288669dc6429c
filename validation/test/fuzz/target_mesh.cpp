// Mesh files by their endings, through the import that all programs share.

#include "solver/mesh/import.hpp"
#include "solver/mesh/medit_file.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/obj_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/mesh/test/vtu_writer.hpp"
#include "solver/mesh/vtu_file.hpp"
#include "validation/test/fuzz/mesh_seeds.hpp"
#include "validation/test/fuzz/target.hpp"

#include <cstdint>
#include <cstring>

namespace cleave::fuzz {

namespace {

using namespace mesh;

Target import_target(const std::string& name, const std::string& ending, std::vector<std::string> seeds) {
    const std::string file = "input" + ending;
    return {name, std::move(seeds), [file](const std::string& bytes) { (void)import_mesh(input_file(file, bytes)); }};
}

SurfaceMesh named_cube() {
    SurfaceMesh cube = test::cube_surface();
    for (std::size_t i = 0; i < cube.triangles.size(); ++i) cube.triangles[i].id = 1 + static_cast<int>(i / 6);
    cube.names = {{1, "lower"}, {2, "upper"}};
    return cube;
}

std::string ascii_stl() {
    return "solid a\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
           "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid a\n"
           "solid b\nfacet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
           "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid b\n";
}

std::string binary_stl() {
    const SurfaceMesh cube = test::cube_surface();
    std::string bytes(80, ' ');
    const auto append = [&bytes](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    append(static_cast<std::uint32_t>(cube.triangles.size()));
    for (const SurfaceTriangle& triangle : cube.triangles) {
        for (int k = 0; k < 3; ++k) append(0.0F);
        for (const int vertex : triangle.vertices)
            for (int k = 0; k < 3; ++k) append(static_cast<float>(cube.vertices[static_cast<std::size_t>(vertex)][k]));
        append(std::uint16_t{0});
    }
    return bytes;
}

constexpr const char* quads = "# a cube of quads\no cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nvn 0 0 1\n"
                              "g low\nf 4 3 2 1\ng rest\nf 5//1 6//1 7//1 8//1\nf 1 2 6 5\nf 2 3 7 6\nf -6 -5 -1 -2\nf 4/1/1 1/1/1 5/1/1 8/1/1\n";
constexpr const char* medit_surface = "MeshVersionFormatted 2\n# a tet's surface\nDimension\n3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                                      "Triangles\n4\n1 3 2 1\n1 2 4 2\n1 4 3 3\n2 3 4 4\nCorners 1\n1\nEnd\n";
constexpr const char* vtu_surface =
    "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"5\"><Points>"
    "<DataArray type=\"Float32\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
    "<DataArray type=\"Int32\" Name=\"connectivity\">0 0 2 1 0 1 3 0 3 2 1 2 3</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\">1 4 7 10 13</DataArray><DataArray type=\"UInt8\" Name=\"types\">1 5 5 5 5</DataArray>"
    "</Cells></Piece></UnstructuredGrid></VTKFile>";

std::vector<std::string> vtu_seeds() {
    const TetMesh mesh = two_tets();
    std::vector<std::string> seeds{format_vtu(mesh), vtu_surface};
    for (const bool wide : {false, true})
        for (const bool zlib : {false, true})
            for (const auto& [appended, encoded] : {std::pair(false, true), {true, true}, {true, false}})
                seeds.push_back(test::stored_vtu(mesh, {wide, zlib, appended, encoded}));
    return seeds;
}

}  // namespace

Target msh_target() { return import_target("msh", ".msh", msh_seeds()); }
Target medit_target() { return import_target("medit", ".mesh", {format_medit(two_tets()), medit_surface}); }
Target vtu_target() { return import_target("vtu", ".vtu", vtu_seeds()); }
Target stl_target() { return import_target("stl", ".stl", {ascii_stl(), binary_stl()}); }
Target obj_target() { return import_target("obj", ".obj", {format_obj(named_cube()), quads}); }

}  // namespace cleave::fuzz
