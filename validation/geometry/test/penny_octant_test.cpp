#include "solver/mesh/check.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/geometry/shape.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

namespace cleave::geometry {
namespace {

std::shared_ptr<const Shape> octant() {
    TableReader reader = TableReader::from_text(
        "shape = \"penny_octant\"\nhalf_width = \"8 m\"\ncrack_radius = \"2 m\"\nload_radius = \"0.5 m\"\n", "shape.toml");
    auto shape = read_shape(reader);
    reader.finish();
    return shape;
}

TEST(PennyOctant, SurfacesSplitItsCrackPlane) {
    const auto shape = octant();
    const ScratchFolder folder;
    const Body body = shape->mesh(0.3, folder);
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    mesh::check(mesh, "octant");
    EXPECT_NEAR(mesh::total_volume(mesh), 512, 1e-9);
    std::map<int, double> area;
    for (const mesh::SurfaceTriangle& t : mesh.surface) {
        const Eigen::Vector3d &a = mesh.vertices[t.vertices[0]], &b = mesh.vertices[t.vertices[1]], &c = mesh.vertices[t.vertices[2]];
        area[t.id] += (b - a).cross(c - a).norm() / 2;
    }
    const double core = area.at(body.surfaces.at("core")), lips = area.at(body.surfaces.at("lips"));
    EXPECT_NEAR(core + lips + area.at(body.surfaces.at("ligament")), 64, 1e-9);
    // Chords of length h inside a circle of radius r lose (h/r)^2/6 of the area: 0.3 m in 2 m, 0.25 m in 0.5 m.
    EXPECT_NEAR(core, std::numbers::pi / 16, 0.06 * core);
    EXPECT_NEAR(core + lips, std::numbers::pi, 0.01 * lips);
    for (const char* side : {"left", "right", "front", "back", "top"}) EXPECT_NEAR(area.at(body.surfaces.at(side)), 64, 1e-9) << side;
}

/// A quarter of the front. Nothing moves on the core or on the outside.
TEST(PennyOctant, GrowthOfTheFront) {
    const CrackFront front = octant()->crack_fronts().at(0);
    EXPECT_EQ(front.lips, "lips");
    EXPECT_NEAR(front.length, std::numbers::pi, 1e-6);  // of its polygon of 3600 sides a turn
    EXPECT_NEAR(uniform_growth(front, {std::sqrt(2.0), std::sqrt(2.0), 0})[0], std::sqrt(0.5), 1e-12);
    EXPECT_EQ(uniform_growth(front, {0.5, 0, 0})[0], 0);
    EXPECT_EQ(uniform_growth(front, {8, 1, 1})[0], 0);
}

}  // namespace
}  // namespace cleave::geometry
