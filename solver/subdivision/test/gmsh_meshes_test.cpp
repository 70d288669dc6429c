#include "solver/mesh/mesher.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/recipes/pot.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "solver/subdivision/subdivision_engine.hpp"
#include "solver/subdivision/test/engine_equals.hpp"
#include "solver/subdivision/test/random.hpp"
#include "solver/subdivision/test/sound.hpp"

#include <gtest/gtest.h>

namespace cleave::subdivision {
namespace {

using mesh::TetMesh;
using test::expect_sound;

/// `count` random planes and discs through the pot (0.24 m high, 0.24 m wide).
std::vector<Cut> cuts_of_pot(int count, std::uint64_t seed) {
    test::Random random(seed);
    std::vector<Cut> cuts;
    for (int i = 0; i < count; ++i) {
        Cut cut = i % 2 == 0 ? random.plane(-0.12, 0.12) : random.disc(-0.12, 0.12);
        cut.centre[2] += 0.12;
        cuts.push_back(cut);
    }
    return cuts;
}

TEST(GmshMeshes, ThePotCutBySeveralPlanes) {
    const TetMesh mesh = mesh::pot(3000).mesh;
    expect_sound(mesh, subdivide(mesh, {{.centre = {0, 0, 0.1}, .normal = {1, 0.2, 0.1}}}));
    for (const int count : {1, 5, 50}) {
        const std::vector<Cut> cuts = cuts_of_pot(count, static_cast<std::uint64_t>(count));
        const Subdivided plain = subdivide(mesh, cuts);
        expect_sound(mesh, plain);
        SubdivisionEngine engine(mesh);
        for (const Cut& cut : cuts) engine.cut(cut);
        EXPECT_EQ(test::first_difference(engine.result(), plain), "") << count << " cuts";
    }
}

TEST(NetgenMeshes, ACubeCutByRandomPlanesAndDiscs) {
    const TetMesh cube = mesh::test::kuhn_cube(2);
    const mesh::HalfFaceLinks links = mesh::link_half_faces(cube);
    mesh::SurfaceMesh surface{.vertices = cube.vertices, .triangles = {}, .names = {}};
    for (int h = 0; h < static_cast<int>(links.opposite.size()); ++h) {
        if (links.opposite[h] < 0) surface.triangles.push_back({mesh::face_of(cube.tets[h / 4], h % 4), 1});
    }
    const TetMesh mesh = mesh::mesh_surface(surface, 0.2, mesh::Mesher::netgen);
    ASSERT_GT(mesh.tets.size(), 200u);
    for (const int count : {1, 50}) {
        test::Random random(static_cast<std::uint64_t>(count));
        std::vector<Cut> cuts;
        for (int i = 0; i < count; ++i) cuts.push_back(i % 2 == 0 ? random.plane(0, 1) : random.disc(0, 1));
        const Subdivided plain = subdivide(mesh, cuts);
        expect_sound(mesh, plain);
        SubdivisionEngine engine(mesh);
        for (const Cut& cut : cuts) engine.cut(cut);
        EXPECT_EQ(test::first_difference(engine.result(), plain), "") << count << " cuts";
    }
}

TEST(ImportedMeshes, AFileCutLikeTheMeshItCameFrom) {
    const TetMesh mesh = mesh::pot(1000).mesh, read = mesh::parse_msh(mesh::format_msh(mesh), "pot.msh");
    const std::vector<Cut> cuts = cuts_of_pot(10, 7);
    const Subdivided out = subdivide(read, cuts);
    expect_sound(read, out);
    EXPECT_EQ(test::first_difference(out, subdivide(mesh, cuts)), "");
}

}  // namespace
}  // namespace cleave::subdivision
