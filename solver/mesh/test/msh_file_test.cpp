#include "solver/mesh/msh_file.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <gtest/gtest.h>


namespace cleave::mesh {
namespace {

// Two tets over the face (2, 3, 4), regions 7 and 8; one tagged and one untagged triangle; node tags with gaps.
const std::string msh_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 5 "bottom face"
3 7 "left"
$EndPhysicalNames
$Nodes
5
10 0 0 0
20 1 0 0
30 0 1 0
41 0 0 1e0
50 1 1 1
$EndNodes
$Elements
5
1 15 2 0 1 10
2 2 2 5 1 10 30 20
3 2 2 0 2 10 20 41
4 4 2 7 1 10 20 30 41
5 4 3 8 2 99 20 30 41 50
$EndElements
)";

const std::string msh_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
2 5 "bottom face"
3 7 "left"
$EndPhysicalNames
$Entities
1 0 2 2
1 0 0 0 0
1 0 0 0 1 1 0 2 -5 6 0
2 0 0 0 1 1 1 0 0
1 0 0 0 1 1 1 1 7 0
2 0 0 0 1 1 1 1 8 0
$EndEntities
$Nodes
2 5 10 50
0 1 0 1
10
0 0 0
3 1 1 4
20
30
41
50
1 0 0 0.1 0.2 0.3
0 1 0 0.1 0.2 0.3
0 0 1e0 0.1 0.2 0.3
1 1 1 0.1 0.2 0.3
$EndNodes
$Elements
5 5 1 5
0 1 15 1
1 10
2 1 2 1
2 10 30 20
2 2 2 1
3 10 20 41
3 1 4 1
4 10 20 30 41
3 2 4 1
5 20 30 41 50
$EndElements
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
    try {
        parse_msh(text, "a.msh");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

void expect_two_tets(const TetMesh& mesh) {
    check(mesh, "a.msh");
    EXPECT_EQ(mesh.vertices.size(), 5u);
    EXPECT_EQ(mesh.tets, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {1, 2, 3, 4}}));
    EXPECT_EQ(mesh.regions, (std::vector<int>{7, 8}));
    EXPECT_EQ(mesh.surface, (std::vector<SurfaceTriangle>{{{0, 2, 1}, 5}}));
    EXPECT_EQ(mesh.vertices[3], Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(mesh.region_names, (std::map<int, std::string>{{7, "left"}}));
    EXPECT_EQ(mesh.surface_names, (std::map<int, std::string>{{5, "bottom face"}}));
}

TEST(MshFile, ReadsFormat2) { expect_two_tets(parse_msh(msh_2, "a.msh")); }
TEST(MshFile, ReadsFormat4) { expect_two_tets(parse_msh(msh_4, "a.msh")); }

TEST(MshFile, ReadsWindowsLineEndsAndSkipsOtherSections) {
    std::string text = replaced(msh_4, "$Nodes", "$Comments\nanything $ at all\n$EndComments\n$Nodes");
    text += "$NodeData\n1\n\"a\"\n$EndNodeData\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    expect_two_tets(parse_msh(text, "a.msh"));
}

TEST(MshFile, ReadsFormat4WithoutEntitiesAsRegionZero) {
    const std::size_t first = msh_4.find("$Entities"), last = msh_4.find("$Nodes");
    const TetMesh mesh = parse_msh(msh_4.substr(0, first) + msh_4.substr(last), "a.msh");
    EXPECT_EQ(mesh.regions, (std::vector<int>{0, 0}));
    EXPECT_TRUE(mesh.surface.empty());
}

TEST(MshFile, WritesWhatItReads) {
    TetMesh mesh = test::kuhn_cube(3, 0.1);
    mesh.surface = {{{0, 5, 1}, 4}};
    mesh.regions[3] = 0;
    mesh.surface_names[4] = "crack";
    const TetMesh again = parse_msh(format_msh(mesh), "again");
    EXPECT_EQ(again.vertices, mesh.vertices);  // to the bit
    EXPECT_EQ(again.tets, mesh.tets);
    EXPECT_EQ(again.regions, mesh.regions);
    EXPECT_EQ(again.surface, mesh.surface);
    EXPECT_EQ(again.surface_names, mesh.surface_names);
    EXPECT_EQ(format_msh(again), format_msh(mesh));
}

TEST(MshFile, ReadsFromDisk) {
    const ScratchFolder folder;
    const auto path = folder / "unit_tet.msh";
    write_msh(test::unit_tet(), path);
    EXPECT_EQ(read_msh(path).tets.size(), 1u);
    std::filesystem::remove(path);
    EXPECT_THROW(read_msh(path), InputError);
}

TEST(MshFile, FaultsAreOneLineWithFileAndRow) {
    const struct { std::string text, message; } faults[] = {
        {"", "a.msh: expected a Gmsh .msh file, which starts with $MeshFormat"},
        {"solid cube\n", "a.msh:1: expected a Gmsh .msh file, which starts with $MeshFormat"},
        {replaced(msh_2, "2.2 0 8", "4 0 8"), "a.msh:2: MeshFormat: expected version 2.2 or 4.1, not 4"},
        {replaced(msh_4, "4.1 0 8", "4.1 1 8"),
         "a.msh:2: MeshFormat: expected an ASCII file (this one is binary: save it with Mesh.Binary = 0)"},
        {replaced(msh_2, "30 0 1 0", "30 0 one 0"), "a.msh:13: y: expected a finite number, not 'one'"},
        {replaced(msh_2, "30 0 1 0", "30 0 nan 0"), "a.msh:13: y: expected a finite number, not 'nan'"},
        {replaced(msh_2, "30 0 1 0", "30 0 1"), "a.msh:13: z: expected a finite number, not ''"},
        {replaced(msh_2, "30 0 1 0", "20 0 1 0"), "a.msh:16: Nodes: expected each node once (tag 20 stands twice)"},
        {replaced(msh_2, "$Nodes\n5", "$Nodes\n-5"), "a.msh:10: number of nodes: expected a count of at least 0, not -5"},
        {replaced(msh_2, "$Nodes\n5", "$Nodes\n6"), "a.msh:16: Nodes: expected more rows (the section ends here)"},
        {replaced(msh_2, "$Nodes\n5", "$Nodes\n4"), "a.msh:15: $Nodes: expected $EndNodes"},
        {replaced(msh_2, "$Nodes\n5", "$Nodes\n900000000000000000"),
         "a.msh:10: number of nodes: expected a count that the file can hold, not 900000000000000000"},
        {replaced(msh_2, "$Nodes\n5", "$Nodes\n90000000000000000000000"),
         "a.msh:10: number of nodes: expected an integer, not '90000000000000000000000'"},
        {replaced(msh_2, "20 30 41 50", "20 30 41 51"), "a.msh:23: Elements: expected a node that exists, not 51"},
        {replaced(msh_2, "20 30 41 50", "20 30 41"), "a.msh:23: node tag of an element: expected an integer, not ''"},
        {replaced(msh_2, "20 30 41 50", "20 30 41 50 1"), "a.msh:23: Elements: expected the end of the row, not '1'"},
        {replaced(msh_2, "5 4 3 8", "5 11 3 8"),
         "a.msh:23: Elements: expected points, lines, 3-node triangles and 4-node tets, not Gmsh's element type 11"},
        {replaced(msh_4, "2 5 10 50", "2 6 10 50"), "a.msh:30: Nodes: expected 6 nodes as the section's head says, not 5"},
        {replaced(msh_4, "5 5 1 5", "5 4 1 5"), "a.msh:43: Elements: expected 4 elements as the section's head says, not 5"},
        {replaced(msh_4, "2 10 30 20", "2 10 30"), "a.msh:37: node tag of an element: expected an integer, not ''"},
        {msh_2.substr(0, msh_2.find("50 1 1 1")), "a.msh:14: Nodes: expected more rows (the file ends here)"},
        {msh_2.substr(0, msh_2.find("$Elements")),
         "a.msh: $Elements: expected at least one 4-node tet (a surface mesh has to be meshed first)"},
        {msh_2.substr(0, msh_2.find("$Nodes")), "a.msh: $Nodes: expected a section of nodes"},
        {msh_2 + "$NodeData\n1\n", "a.msh:26: $NodeData: expected $EndNodeData (the file ends here)"},
    };
    for (const auto& fault : faults) EXPECT_EQ(complaint(fault.text), fault.message);
    EXPECT_EQ(complaint(msh_2), "");
}

TEST(MshFile, EveryTruncationIsAnInputErrorOrAMesh) {
    for (const std::string& whole : {msh_2, msh_4}) {
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const std::string message = complaint(whole.substr(0, length));  // another exception, or a crash, fails the test
            EXPECT_EQ(message.empty(), length + 1 == whole.size()) << length;  // only the last line end may miss
        }
    }
}

TEST(MshFile, EveryWrongByteIsAnInputErrorOrAMesh) {
    for (const std::string& whole : {msh_2, msh_4}) {
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const char wrong : {'\0', '-', '9', '$', '\n', 'x'}) {
                std::string text = whole;
                text[at] = wrong;
                complaint(text);
            }
        }
    }
}

}  // namespace
}  // namespace cleave::mesh
