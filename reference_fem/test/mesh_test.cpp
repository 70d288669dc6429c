#include "reference_fem/mesh.hpp"

#include "reference_fem/test/error_text.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cleave::fem::testing {
namespace {

std::string read_error(const std::string& text) {
    return error_of([&] {
        const Mesh mesh = read_msh(write_temporary("bad.msh", text));
        check_cells(mesh);
        const FaceTable faces(mesh);
    });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// Trap: deal.II's reader by file name drops physical tags without a name. None of ours has one.
TEST(MshReader, KeepsUnnamedPhysicalTagsInBothVersions) {
    const MshText text = box_mesh({.region = [](const Point& c) { return c[0] < 0.5 ? 12 : 7; }});
    for (const std::string& written : {text.version_2(), text.version_4()}) {
        const Mesh mesh = read_msh(write_temporary("tags.msh", written));
        ASSERT_EQ(mesh.cells.size(), text.tets.size());
        ASSERT_EQ(mesh.vertices, text.nodes);
        for (std::size_t i = 0; i < text.tets.size(); ++i) {
            EXPECT_EQ(mesh.cells[i], text.tets[i].nodes);
            EXPECT_EQ(mesh.cell_regions[i], text.tets[i].region);
        }
        ASSERT_EQ(mesh.triangles.size(), text.triangles.size());
        for (std::size_t i = 0; i < text.triangles.size(); ++i) EXPECT_EQ(mesh.triangles[i].surface, text.triangles[i].surface);
        EXPECT_EQ(FaceTable(mesh).surface(4).size(), 18u);
    }
}

TEST(MshReader, LeavesOutNodesWithoutTetsAndSkipsUnknownSections) {
    MshText text = single_tet();
    text.nodes.insert(text.nodes.begin() + 2, {9, 9, 9});
    text.tets[0].nodes = {0, 1, 3, 4};
    text.triangles = {{{0, 3, 1}, 5}};
    const std::string names = "$PhysicalNames\n1\n2 5 \"a name with spaces\"\n$EndPhysicalNames\n";
    const Mesh mesh = read_msh(write_temporary("loose.msh", replaced(text.version_2(), "$Nodes", names + "$Nodes")));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.cells[0], (std::array{0, 1, 2, 3}));
    EXPECT_EQ(FaceTable(mesh).surface(5).front().opposite, 3);
}

/// Trap: GridTools::volume is 6 times too large on tets. A cube says which is right.
TEST(Mesh, VolumesSumToTheBox) {
    const Mesh mesh = read_msh(write_box("volume.msh", {.low = {0, 0, 0}, .high = {2, 3, 4}}));
    double volume = 0;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) volume += signed_volume(mesh, cell);
    EXPECT_NEAR(volume, 24, 24e-14);
}

TEST(Mesh, PartsAreJoinedByVertices) {
    MshText text = single_tet();
    for (const Point& node : single_tet().nodes) text.nodes.push_back({node[0] + 5, node[1], node[2]});
    text.tets.push_back({{4, 5, 6, 7}, 1});
    EXPECT_EQ(connected_parts(read_msh(write_temporary("parts.msh", text.version_2()))), (std::vector{0, 1}));
}

/// Trap: deal.II's release library takes negative volumes without a word.
TEST(BadMesh, InvertedOrFlatTetIsNamed) {
    MshText inverted = single_tet();
    std::swap(inverted.tets[0].nodes[0], inverted.tets[0].nodes[1]);
    for (const std::string& text : {inverted.version_2(), inverted.version_4()}) {
        EXPECT_TRUE(contains(read_error(text), "tet 3 is inverted or flat (volume -0.167"));
        EXPECT_TRUE(contains(read_error(text), "bad.msh"));
    }
    MshText flat = single_tet();
    flat.nodes[3] = {0.3, 0.3, 1e-13};
    EXPECT_TRUE(contains(read_error(flat.version_2()), "tet 3 is inverted or flat"));
    EXPECT_EQ(read_error(single_tet().version_2()), "");
}

TEST(BadMesh, BrokenFilesGiveFileAndLine) {
    const std::string good = single_tet().version_2();
    EXPECT_TRUE(contains(error_of([] { read_msh("no_such.msh"); }), "no_such.msh: cannot be read"));
    EXPECT_TRUE(contains(error_of([] { read_msh("/"); }), "/: cannot be read"));
    EXPECT_TRUE(contains(read_error(""), "bad.msh: cannot be read"));
    EXPECT_TRUE(contains(read_error("solid cube\n"), "bad.msh:1: expected $MeshFormat, found 'solid'"));
    EXPECT_TRUE(contains(read_error(replaced(good, "2.2 0 8", "4 0 8")), "bad.msh:2: format 4 is not read"));
    EXPECT_TRUE(contains(read_error(replaced(good, "2.2 0 8", "2.2 1 8")), "binary"));
    EXPECT_TRUE(contains(read_error(replaced(good, "1 0 0 0\n", "1 0 zero 0\n")), "bad.msh:6: expected a number, found 'zero'"));
    EXPECT_TRUE(contains(read_error(replaced(good, "$Nodes\n4", "$Nodes\n3")), "expected $EndNodes"));
    EXPECT_TRUE(contains(read_error(replaced(good, "$Nodes\n4", "$Nodes\n400000000")), "impossible count"));
    EXPECT_TRUE(contains(read_error(replaced(good, "$Nodes\n4\n1 ", "$Nodes\n4\n2 ")), "node 2 stands twice"));
    EXPECT_TRUE(contains(read_error(replaced(good, "3 4 2 1 1 1 2 3 4", "3 4 2 1 1 1 2 3 9")), "element 3 uses node 9"));
    EXPECT_TRUE(contains(read_error(replaced(good, "3 4 2 1 1 1 2 3 4", "3 11 2 1 1 1 2 3 4 1 1 1 1 1 1")), "type 11"));
    EXPECT_TRUE(contains(read_error(replaced(good, "3 4 2 1 1 1 2 3 4", "3 4294967300 2 1 1 1 2 3 4")), "number out of range: 4294967300"));
    EXPECT_TRUE(contains(read_error(replaced(good, "3 4 2 1 1 1 2 3 4", "3 4 2 -2147483648 1 1 2 3 4")), "number out of range: -2147483648"));
    EXPECT_TRUE(contains(read_error(replaced(good, "3 4 2 1 1 1 2 3 4", "3 4 2 1 1 1 2 3 4 5")), "expected the end of the line, found '5'"));
    EXPECT_TRUE(contains(read_error(replaced(good, "1 0 0 0\n", "1 0 inf 0\n")), "expected a finite number, found inf"));
    EXPECT_TRUE(contains(read_error(good.substr(0, good.size() - 30)), "expected"));
    MshText empty = single_tet();
    empty.tets.clear();
    EXPECT_TRUE(contains(read_error(empty.version_2()), "no tets"));
}

TEST(BadMesh, TetThatStandsTwiceOrInTwoVolumesIsNamed) {
    MshText doubled = single_tet();
    doubled.tets.assign(3, doubled.tets[0]);
    EXPECT_TRUE(contains(read_error(doubled.version_2()), "tets 3, 4 and 5 share one face"));
    EXPECT_TRUE(
        contains(read_error(replaced(single_tet().version_4(), "1 0 0 0 1 1 1 1 1 0", "1 0 0 0 1 1 1 2 1 8 0")), "2 physical volumes"));
}

}  // namespace
}  // namespace cleave::fem::testing
