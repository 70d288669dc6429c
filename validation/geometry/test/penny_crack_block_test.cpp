#include "solver/input/table_reader.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/geometry/shape.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

namespace cleave::geometry {
namespace {

struct Made {
    Body body;
    mesh::TetMesh mesh;
    std::shared_ptr<const Shape> shape;
};

Made make(const std::string& angle) {
    TableReader reader = TableReader::from_text(
        "shape = \"penny_crack_block\"\nhalf_width = \"6 m\"\ncrack_radius = \"2 m\"\ncrack_angle = \"" + angle + "\"\n", "shape.toml");
    Made made{{}, {}, read_shape(reader)};
    reader.finish();
    made.body = made.shape->mesh(0.5, std::filesystem::path(testing::TempDir()) / "cleave_penny_test");
    made.mesh = mesh::read_msh(made.body.mesh_file);
    mesh::check(made.mesh, "penny");
    return made;
}

/// Unlinked faces by the surface id of their triangle, 0 without one: the sum of their outward areas and of their sizes.
struct Boundary {
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();
    double area = 0;
};

std::map<int, Boundary> boundary(const mesh::TetMesh& mesh) {
    std::map<std::array<int, 3>, int> ids;
    for (const mesh::SurfaceTriangle& triangle : mesh.surface) {
        auto key = triangle.vertices;
        std::sort(key.begin(), key.end());
        ids[key] = triangle.id;
    }
    std::map<int, Boundary> sums;
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    for (std::size_t half = 0; half < links.opposite.size(); ++half) {
        if (links.opposite[half] >= 0) continue;
        auto face = mesh::face_of(mesh.tets[half / 4], static_cast<int>(half % 4));
        const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(face[static_cast<std::size_t>(k)])]; };
        const Eigen::Vector3d area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
        std::sort(face.begin(), face.end());
        Boundary& sum = sums[ids.contains(face) ? ids.at(face) : 0];
        sum.outward += area;
        sum.area += area.norm();
    }
    return sums;
}

class PennyCrackBlock : public testing::TestWithParam<const char*> {};

TEST_P(PennyCrackBlock, LipsAreDoubledFacesOfOneSurfaceAndTheFrontIsSingle) {
    const Made made = make(GetParam());
    EXPECT_NEAR(mesh::total_volume(made.mesh), 12 * 12 * 12, 1e-9);
    const std::map<int, Boundary> sums = boundary(made.mesh);
    ASSERT_EQ(sums.size(), 7U) << "six sides and the crack; no face without a name";
    for (const char* side : {"left", "right", "front", "back", "bottom", "top"})
        EXPECT_NEAR(sums.at(made.body.surfaces.at(side)).area, 144, 1e-9);
    EXPECT_NEAR(sums.at(made.body.surfaces.at("top")).outward.z(), 144, 1e-9);
    const Boundary& lips = sums.at(made.body.surfaces.at("crack"));
    // Two lips of opposite normals; chords of the front cut off 1 - sin(t)/t of the disc, t <= 0.25.
    EXPECT_LT(lips.outward.norm(), 1e-9);
    EXPECT_NEAR(lips.area / (2 * 4 * std::numbers::pi), 1, 0.011);
    std::map<std::array<double, 3>, int> copies;
    for (const auto& x : made.mesh.vertices) ++copies[{x[0], x[1], x[2]}];
    const auto r = made.shape->coordinates().at("r"), front = made.shape->coordinates().at("front_distance");
    int doubled = 0;
    for (const auto& [x, count] : copies) {
        if (front(x) < 1e-9) {
            EXPECT_EQ(count, 1);
        }
        if (count == 1) continue;
        EXPECT_EQ(count, 2);
        EXPECT_LT(r(x), 2);
        ++doubled;
    }
    EXPECT_GT(doubled, 20);
}

INSTANTIATE_TEST_SUITE_P(Angles, PennyCrackBlock, testing::Values("0 deg", "37 deg"));

}  // namespace
}  // namespace cleave::geometry
