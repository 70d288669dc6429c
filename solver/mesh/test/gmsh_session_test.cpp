#include "solver/mesh/gmsh_session.hpp"

#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"

#include <Eigen/Geometry>
#include <gmsh.h>
#include <gtest/gtest.h>


#include <stdexcept>

namespace cleave::mesh {
namespace {

TetMesh gmsh_box(const GmshSession& session, double size) {
    session.new_model("box");
    session.run([] {
        gmsh::model::occ::addBox(0, 0, 0, 1, 2, 3);
        gmsh::model::occ::synchronize();
        gmsh::model::addPhysicalGroup(3, {1}, 7);
        gmsh::model::setPhysicalName(3, 7, "box");
        gmsh::model::addPhysicalGroup(2, {1}, 3);
    });
    session.set_uniform_size(size);
    session.generate();
    return session.take_mesh();
}

TEST(GmshSession, MeshesABoxThatPassesTheChecks) {
    const GmshSession session;
    const TetMesh mesh = gmsh_box(session, 0.4);
    check(mesh, "box");
    EXPECT_NEAR(total_volume(mesh), 6, 6e-13);  // flat faces: the mesh fills the box up to rounding
    EXPECT_EQ(mesh.regions.front(), 7);
    EXPECT_EQ(mesh.region_names.at(7), "box");
    double area = 0;
    for (const SurfaceTriangle& triangle : mesh.surface) {
        EXPECT_EQ(triangle.id, 3);
        const auto [a, b, c] = triangle.vertices;
        area += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    }
    EXPECT_NEAR(area, 6, 1e-12);  // surface 1 of an OCC box: x = 0, sides 2 and 3
}

TEST(GmshSession, RepeatsToTheBitAndReadsBackFromItsOwnFile) {
    const ScratchFolder folder;
    const auto file = folder / "box.msh";
    std::string first;
    {
        const GmshSession session;
        first = format_msh(gmsh_box(session, 0.5));
        session.run([&] { gmsh::write(file.string()); });
    }
    const GmshSession again;
    EXPECT_EQ(format_msh(gmsh_box(again, 0.5)), first);
    const TetMesh from_file = read_msh(file);  // what Gmsh writes (4.1) and what it hands over are one mesh
    const TetMesh in_memory = parse_msh(first, "memory");
    EXPECT_EQ(from_file.tets.size(), in_memory.tets.size());
    EXPECT_EQ(from_file.regions, in_memory.regions);
    EXPECT_EQ(from_file.region_names, in_memory.region_names);
    EXPECT_EQ(from_file.surface.size(), in_memory.surface.size());
    EXPECT_NEAR(total_volume(from_file), total_volume(in_memory), 1e-13);
}

TEST(GmshSession, TurnsGmshErrorsIntoOurs) {
    const GmshSession session;
    session.new_model("broken");
    EXPECT_THROW(session.run([] { gmsh::model::occ::addCurveLoop({99}); }), MeshingError);
    EXPECT_THROW(session.take_mesh(), MeshingError);  // nothing meshed
    EXPECT_EQ(gmsh_box(session, 1).regions.front(), 7);  // and the session is still of use
}

TEST(GmshSession, IsOnePerProcess) {
    const GmshSession session;
    EXPECT_THROW(GmshSession second, std::logic_error);
}

}  // namespace
}  // namespace cleave::mesh
