#include "validation/test/fuzz/mesh_seeds.hpp"

#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"

namespace cleave::fuzz {

namespace {

constexpr const char* format_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 3 \"side\"\n3 1 \"core\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 1 1\n1 0 0 0 0\n1 0 0 0 1 0 0 0 2 1 -1\n1 0 0 0 1 1 0 1 3 0\n1 0 0 0 1 1 1 1 1 1 1\n$EndEntities\n"
    "$Nodes\n2 4 1 9\n2 1 0 3\n1\n2\n9\n0 0 0\n1 0 0\n0 1 0\n3 1 0 1\n4\n0 0 1\n$EndNodes\n"
    "$Elements\n2 2 1 2\n2 1 2 1\n1 1 9 2\n3 1 4 1\n2 1 2 9 4\n$EndElements\n$NodeData\n0\n$EndNodeData\n";

}  // namespace

mesh::TetMesh two_tets() {
    mesh::TetMesh mesh = mesh::test::unit_tet();
    mesh.vertices.emplace_back(1, 1, 1);
    mesh.tets.push_back({1, 2, 3, 4});
    mesh.regions = {1, 2};
    mesh.surface = {{{0, 2, 1}, 3}, {{0, 1, 3}, 4}};
    mesh.region_names = {{1, "core"}, {2, "skin"}};
    mesh.surface_names = {{3, "bottom"}, {4, "front"}};
    return mesh;
}

std::vector<std::string> msh_seeds() { return {mesh::format_msh(two_tets()), format_4}; }

}  // namespace cleave::fuzz
