// Bad meshes and surfaces, through `cleave mesh` and through a case: the classes of broken file that circulate.

#include "validation/test/robustness/bad_input.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace cleave::robustness {
namespace {

/// Two tets that share a face; nodes and elements as text, so that each can be spoiled.
std::string msh(const std::string& nodes = "5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n",
                const std::string& elements = "2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 2 3 4 5\n") {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes + "$EndNodes\n$Elements\n" + elements + "$EndElements\n";
}

const std::string nodes = "5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n", elements = "2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 2 3 4 5\n";

const std::string tet = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string shifted_tet(double x, int first) {
    std::string text;
    for (const char* v : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"}) text += fmt::format("v {} {}\n", x + (v[0] - '0'), std::string(v).substr(2));
    for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) text += fmt::format("f {} {} {}\n", first + f[0], first + f[1], first + f[2]);
    return text;
}

std::string vtu(const std::string& points, const std::string& connectivity, const std::string& offsets, const std::string& types, int cells) {
    return fmt::format(R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="{}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{}</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">{}</DataArray><DataArray type="Int64" Name="offsets" format="ascii">{}</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">{}</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>
)", cells, points, connectivity, offsets, types);
}

const std::string four_points = "0 0 0 1 0 0 0 1 0 0 0 1";

std::string binary_stl(std::uint32_t said, std::uint32_t held) {
    std::string text(80, ' ');
    text.append(reinterpret_cast<const char*>(&said), 4);
    for (std::uint32_t i = 0; i < held; ++i) {
        const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, static_cast<float>(i)};
        text.append(reinterpret_cast<const char*>(numbers), 48).append(2, '\0');
    }
    return text;
}

BadInput bad_mesh(const std::string& name, const std::string& file, const std::string& bytes, std::vector<std::string> told) {
    told.insert(told.begin(), file);
    return {name, "mesh " + file + " --out out.msh", {{file, bytes}}, std::move(told)};
}

std::vector<BadInput> bad_tets() {
    return {
        bad_mesh("msh_empty", "bad.msh", "", {"expected"}),
        bad_mesh("msh_binary_garbage", "bad.msh", std::string("\x00\x01\x02\xff\xfe", 5), {"expected"}),
        bad_mesh("msh_of_version_1", "bad.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n", {"expected"}),
        bad_mesh("msh_of_version_9", "bad.msh", changed(msh(), "2.2 0 8", "9.9 0 8"), {"9.9"}),
        bad_mesh("msh_no_nodes", "bad.msh", msh("0\n"), {"expected"}),
        bad_mesh("msh_no_tets", "bad.msh", msh(nodes, "0\n"), {"tet"}),
        bad_mesh("msh_truncated_in_nodes", "bad.msh", msh().substr(0, 70), {"expected"}),
        bad_mesh("msh_truncated_in_elements", "bad.msh", msh().substr(0, msh().size() - 30), {"expected"}),
        bad_mesh("msh_count_of_nodes_negative", "bad.msh", msh(changed(nodes, "5\n1 0", "-5\n1 0")), {"expected"}),
        bad_mesh("msh_count_of_nodes_huge", "bad.msh", msh(changed(nodes, "5\n1 0", "99999999999999\n1 0")), {"expected"}),
        bad_mesh("msh_count_of_elements_huge", "bad.msh", msh(nodes, changed(elements, "2\n1 4", "99999999999999\n1 4")), {"expected"}),
        bad_mesh("msh_coordinate_nan", "bad.msh", msh(changed(nodes, "2 1 0 0", "2 nan 0 0")), {"finite"}),
        bad_mesh("msh_coordinate_infinite", "bad.msh", msh(changed(nodes, "2 1 0 0", "2 1e999 0 0")), {"expected"}),
        bad_mesh("msh_coordinate_a_word", "bad.msh", msh(changed(nodes, "2 1 0 0", "2 one 0 0")), {"expected"}),
        bad_mesh("msh_node_that_is_not_there", "bad.msh", msh(nodes, changed(elements, "2 3 4 5", "2 3 4 77")), {"77"}),
        bad_mesh("msh_node_twice", "bad.msh", msh(changed(nodes, "5 1 1 1", "4 1 1 1")), {"4"}),
        bad_mesh("msh_tet_with_a_vertex_twice", "bad.msh", msh(nodes, changed(elements, "2 3 4 5", "2 3 4 4")), {"tet"}),
        bad_mesh("msh_tet_inverted", "bad.msh", msh(nodes, changed(elements, "2 3 4 5", "3 2 4 5")), {"volume"}),
        bad_mesh("msh_tet_flat", "bad.msh", msh(changed(nodes, "5 1 1 1", "5 0.5 0.5 0")), {"volume"}),
        bad_mesh("msh_tet_twice", "bad.msh", msh(nodes, "3\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 2 3 4 5\n3 4 2 1 1 2 3 4 5\n"), {"tet"}),
        bad_mesh("msh_face_of_three_tets", "bad.msh",
                 msh("6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n6 2 2 2\n", "3\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 2 3 4 5\n3 4 2 1 1 2 3 4 6\n"), {"face"}),
        bad_mesh("msh_of_hexahedra", "bad.msh", msh("8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n", "1\n1 5 2 1 1 1 2 3 4 5 6 7 8\n"),
                 {"tet"}),
        bad_mesh("vtu_empty", "bad.vtu", "", {"expected"}),
        bad_mesh("vtu_truncated", "bad.vtu", vtu(four_points, "0 1 2 3", "4", "10", 1).substr(0, 300), {"expected"}),
        bad_mesh("vtu_of_another_kind", "bad.vtu", "<VTKFile type=\"ImageData\"/>", {"UnstructuredGrid"}),
        bad_mesh("vtu_of_hexahedra", "bad.vtu", vtu(four_points, "0 1 2 3", "4", "12", 1), {"10"}),
        bad_mesh("vtu_index_out_of_range", "bad.vtu", vtu(four_points, "0 1 2 9", "4", "10", 1), {"9"}),
        bad_mesh("vtu_index_negative", "bad.vtu", vtu(four_points, "0 1 2 -3", "4", "10", 1), {"-3"}),
        bad_mesh("vtu_too_few_points", "bad.vtu", vtu("0 0 0 1 0 0", "0 1 2 3", "4", "10", 1), {"expected"}),
        bad_mesh("vtu_cells_huge", "bad.vtu", vtu(four_points, "0 1 2 3", "4", "10", 2000000000), {"expected"}),
        bad_mesh("vtu_offset_wrong", "bad.vtu", vtu(four_points, "0 1 2 3", "400", "10", 1), {"expected"}),
        bad_mesh("medit_empty", "bad.mesh", "", {"expected"}),
        bad_mesh("medit_truncated", "bad.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0", {"expected"}),
        bad_mesh("medit_two_dimensions", "bad.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n0\nEnd\n", {"imension"}),
    };
}

std::vector<BadInput> bad_surfaces() {
    return {
        bad_mesh("stl_empty", "bad.stl", "", {"expected"}),
        bad_mesh("stl_header_only", "bad.stl", std::string(80, ' '), {"expected"}),
        bad_mesh("stl_truncated", "bad.stl", binary_stl(4, 2), {"expected"}),
        bad_mesh("stl_count_huge", "bad.stl", binary_stl(0xffffffffU, 2), {"expected"}),
        bad_mesh("stl_no_triangles", "bad.stl", binary_stl(0, 0), {"at least one facet"}),
        bad_mesh("stl_ascii_cut", "bad.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n", {"expected"}),
        bad_mesh("stl_ascii_nan", "bad.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n", {"finite"}),
        bad_mesh("obj_empty", "bad.obj", "", {"expected"}),
        bad_mesh("obj_index_zero", "bad.obj", changed(tet, "f 2 3 4", "f 0 3 4"), {"bad.obj:8"}),
        bad_mesh("obj_index_too_large", "bad.obj", changed(tet, "f 2 3 4", "f 2 3 40"), {"bad.obj:8", "40"}),
        bad_mesh("obj_index_before_the_first", "bad.obj", changed(tet, "f 2 3 4", "f 2 3 -40"), {"bad.obj:8", "-40"}),
        bad_mesh("obj_two_indices", "bad.obj", changed(tet, "f 2 3 4", "f 2 3"), {"bad.obj:8"}),
        bad_mesh("obj_two_coordinates", "bad.obj", changed(tet, "v 0 0 1", "v 0 0"), {"bad.obj:4"}),
        bad_mesh("obj_coordinate_infinite", "bad.obj", changed(tet, "v 0 0 1", "v 0 0 inf"), {"bad.obj:4", "finite"}),
        bad_mesh("obj_open", "bad.obj", changed(tet, "f 2 3 4\n", ""), {"closed surface"}),
        bad_mesh("obj_a_face_twice", "bad.obj", tet + "f 2 3 4\n", {"expected"}),
        bad_mesh("obj_a_fin", "bad.obj", "v 2 2 2\n" + tet + "f 1 3 4\n", {"expected"}),
        bad_mesh("obj_one_face_turned", "bad.obj", changed(tet, "f 2 3 4", "f 3 2 4"), {"face the same way"}),
        bad_mesh("obj_face_with_a_vertex_twice", "bad.obj", changed(tet, "f 2 3 4", "f 2 3 3"), {"expected"}),
        bad_mesh("obj_of_no_volume", "bad.obj", changed(tet, "v 0 0 1", "v 0.2 0.2 0"), {"expected"}),
        bad_mesh("obj_crosses_itself", "bad.obj", shifted_tet(0, 1) + shifted_tet(0.1, 5), {"expected"}),
        bad_mesh("obj_two_bodies", "bad.obj", shifted_tet(0, 1) + shifted_tet(5, 5), {"one"}),
        bad_mesh("obj_the_size_of_nothing", "bad.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", {"expected"}),
        {"mesh_missing", "mesh none.obj --out out.msh", {}, {"none.obj"}},
        {"mesh_of_unknown_kind", "mesh bad.step --out out.msh", {{"bad.step", "ISO-10303-21;"}}, {"bad.step", ".stl"}},
        {"mesh_count_of_words", "mesh tet.obj --out out.msh --count many", {{"tet.obj", tet}}, {"--count"}},
        {"mesh_count_negative", "mesh tet.obj --out out.msh --count -5", {{"tet.obj", tet}}, {"--count"}},
        {"mesh_out_is_a_folder", "mesh tets.msh --out out.msh", {{"tets.msh", msh()}, {"out.msh/x", ""}}, {"out.msh"}, 3},
        {"mesh_disk_full", "mesh tets.msh --out out.vtu", {{"tets.msh", msh()}}, {"out.vtu"}, 3, "trap '' XFSZ; ulimit -f 1;"},
    };
}

class BadMesh : public testing::TestWithParam<BadInput> {};

TEST_P(BadMesh, GetsOneLine) { EXPECT_EQ(complaint(GetParam()), ""); }

INSTANTIATE_TEST_SUITE_P(Tets, BadMesh, testing::ValuesIn(bad_tets()), [](const auto& info) { return info.param.name; });
INSTANTIATE_TEST_SUITE_P(Surfaces, BadMesh, testing::ValuesIn(bad_surfaces()), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace cleave::robustness
