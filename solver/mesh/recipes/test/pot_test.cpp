#include "solver/mesh/recipes/pot.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace cleave::mesh {
namespace {

std::filesystem::path only_file(const std::filesystem::path& folder) {
    std::filesystem::path found;
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) found = entry.path(), ++files;
    EXPECT_EQ(files, 1);
    return found;
}

TEST(Pot, ComesWithinTwoPercentOfThePapersCount) {
    const Body body = pot(6163);
    EXPECT_NEAR(body.record.count, 6163, 0.02 * 6163);
    EXPECT_EQ(body.record.count, static_cast<int>(body.mesh.tets.size()));
    // A revolved profile without sharp corners: no slivers (Gmsh 4.8.4 gives 13.9 degrees).
    EXPECT_GT(body.record.smallest_dihedral, 5 * std::numbers::pi / 180);
    EXPECT_EQ(body.record.slivers, 0);
    EXPECT_EQ(body.mesh.region_names.at(1), "pot");
}

TEST(Pot, IsAClosedVesselOfOnePiece) {
    const Body body = pot(2000);
    check(body.mesh, "pot");
    const HalfFaceLinks links = link_half_faces(body.mesh);
    std::size_t boundary = 0;
    for (const int other : links.opposite) boundary += other < 0;
    EXPECT_EQ(boundary, body.mesh.surface.size());  // the tagged surface is the whole boundary
    // A vessel is a ball with a dent: Euler characteristic of its surface V - E + F = 2, with E = 3F/2.
    std::vector<bool> used(body.mesh.vertices.size(), false);
    for (const SurfaceTriangle& triangle : body.mesh.surface) {
        for (const int vertex : triangle.vertices) used[vertex] = true;
    }
    const long vertices = std::count(used.begin(), used.end(), true);
    EXPECT_EQ(vertices - static_cast<long>(boundary) / 2, 2);
}

TEST(BodyCache, GivesTheSameBits) {
    const ScratchFolder folder;
    const Body fresh = pot(1500, folder);
    const std::string text = read_file(only_file(folder));
    const Body cached = pot(1500, folder);
    EXPECT_EQ(cached.record, fresh.record);
    EXPECT_EQ(format_msh(cached.mesh), format_msh(fresh.mesh));
    EXPECT_EQ(text, format_msh(fresh.mesh));
}

TEST(BodyCache, MakesOnceAndReplacesADamagedFile) {
    const ScratchFolder folder;
    int made = 0;
    const auto make = [&] { return ++made, test::kuhn_cube(2); };
    cached_body("cube", "cube 2", 48, folder, make);
    cached_body("cube", "cube 2", 48, folder, make);
    EXPECT_EQ(made, 1);
    const auto file = only_file(folder);
    const std::string whole = read_file(file);
    write_file_atomic(file, whole.substr(0, whole.size() / 2));
    EXPECT_EQ(cached_body("cube", "cube 2", 48, folder, make).record.count, 48);
    EXPECT_EQ(made, 2);
    EXPECT_EQ(read_file(file), whole);
    cached_body("cube", "cube 2, another text", 48, folder, make);  // another recipe, another file
    EXPECT_EQ(made, 3);
}

TEST(BodyCache, RefusesACountThatMisses) {
    const auto make = [] { return test::kuhn_cube(2); };
    EXPECT_NO_THROW(cached_body("cube", "", 48, {}, make));
    EXPECT_THROW(cached_body("cube", "", 49, {}, make), MeshingError);  // 48 of 49 is 2.04 % off
}

TEST(BodyRecord, CountsSlivers) {
    TetMesh mesh = test::unit_tet();
    mesh.vertices[3] = {0.3, 0.3, 0.01};
    const Body body = cached_body("sliver", "", 1, {}, [&] { return mesh; });
    EXPECT_EQ(body.record.slivers, 1);
    EXPECT_LT(body.record.smallest_dihedral, 0.05);
}

}  // namespace
}  // namespace cleave::mesh
