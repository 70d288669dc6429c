#include "solver/input/table_reader.hpp"
#include "solver/input/test/scratch_folder.hpp"
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

const ScratchFolder folder;

struct Made {
    Body body;
    mesh::TetMesh mesh;
    std::shared_ptr<const Shape> shape;
};

Made make(const std::string& shape, double size) {
    TableReader reader = TableReader::from_text(shape, "shape.toml");
    Made made{{}, {}, read_shape(reader)};
    reader.finish();
    made.body = made.shape->mesh(size, folder);
    made.mesh = mesh::read_msh(made.body.mesh_file);
    mesh::check(made.mesh, "crack");
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

struct Expected {
    const char* shape;
    double size, volume, lips, lips_error;  ///< m, m^3, m^2; how much less the chords of the front may enclose
    bool flat = true;
};

class CrackedBoxes : public testing::TestWithParam<Expected> {};

/// Places of the vertices and how many stand there.
std::map<std::array<double, 3>, int> copies_of(const mesh::TetMesh& mesh) {
    std::map<std::array<double, 3>, int> copies;
    for (const auto& x : mesh.vertices) ++copies[{x[0], x[1], x[2]}];
    return copies;
}

double to_front(const Shape& shape, const Point& x) {
    double nearest = INFINITY;
    for (const CrackFront& front : shape.crack_fronts()) nearest = std::min(nearest, distance(front.locate(x)));
    return nearest;
}

TEST_P(CrackedBoxes, LipsAreDoubledFacesOfOneSurfaceAndTheFrontIsSingle) {
    const Expected& expected = GetParam();
    const Made made = make(expected.shape, expected.size);
    EXPECT_NEAR(mesh::total_volume(made.mesh) / expected.volume, 1, 1e-9);
    const std::map<int, Boundary> sums = boundary(made.mesh);
    ASSERT_EQ(sums.size(), 7U) << "six sides and the crack; no face without a name";
    double sides = 0;
    for (const char* side : {"left", "right", "front", "back", "bottom", "top"}) {
        const Boundary& sum = sums.at(made.body.surfaces.at(side));
        EXPECT_NEAR(sum.outward.norm() / sum.area, 1, 1e-9) << side << " is a plane";
        sides += sum.area;
    }
    const Boundary& lips = sums.at(made.body.surfaces.at("crack"));
    EXPECT_LT(lips.outward.norm(), 1e-7 * sides) << "two lips of opposite normals";
    EXPECT_LE(lips.area, 2 * expected.lips * (1 + 1e-9));
    EXPECT_GE(lips.area, 2 * expected.lips * (1 - expected.lips_error));
    int doubled = 0, front = 0;
    const double small = std::cbrt(expected.volume);
    const std::map<std::array<double, 3>, int> copies = copies_of(made.mesh);
    for (const auto& [x, count] : copies) {
        EXPECT_LE(count, 2);
        if (to_front(*made.shape, x) < 1e-6 * small) {
            EXPECT_EQ(count, 1) << "at " << x[0] << " " << x[1] << " " << x[2];
            ++front;
        }
        doubled += count == 2;
    }
    EXPECT_GT(doubled, 10);
    for (const mesh::SurfaceTriangle& triangle : made.mesh.surface)  // where the crack meets a side too
        if (triangle.id == made.body.surfaces.at("crack"))
            for (const int v : triangle.vertices) {
                const auto& x = made.mesh.vertices[static_cast<std::size_t>(v)];
                EXPECT_EQ(copies.at({x[0], x[1], x[2]}), to_front(*made.shape, {x[0], x[1], x[2]}) < 1e-6 * small ? 1 : 2);
            }
    EXPECT_GE(front, 2);
}

/// The growth field: tangential on the lips, zero on the sides it would dent, one at the front.
TEST_P(CrackedBoxes, GrowthMovesTheFrontAlongTheCrackAndNoSide) {
    const Expected& expected = GetParam();
    const Made made = make(expected.shape, expected.size);
    for (const CrackFront& front : made.shape->crack_fronts()) {
        for (const mesh::SurfaceTriangle& triangle : made.mesh.surface) {
            const auto at = [&](int k) { return made.mesh.vertices[static_cast<std::size_t>(triangle.vertices[static_cast<std::size_t>(k)])]; };
            const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
            const bool lip = triangle.id == made.body.surfaces.at("crack");
            for (int k = 0; k < 3; ++k) {
                const Point x{at(k)[0], at(k)[1], at(k)[2]}, q = uniform_growth(front, x);
                const double into = std::abs(normal.dot(Eigen::Vector3d(q[0], q[1], q[2])));
                EXPECT_LT(into, lip && !expected.flat ? 0.2 : 1e-9);  // triangles of a cap cut its corners: half their angle
            }
        }
        const FrontPlace place = front.locate(front.locate({0.3, 0.2, 0.1}).position);
        const Point q = uniform_growth(front, place.position);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(q[k], place.axes[0][k], 1e-9);
        EXPECT_NEAR(distance(place), 0, 1e-9);
        const Point far = local_growth(front, place.along + 0.25 * front.length, 0.2 * front.length, place.position);
        EXPECT_EQ(std::abs(far[0]) + std::abs(far[1]) + std::abs(far[2]), 0);
    }
}

constexpr double pi = std::numbers::pi;
INSTANTIATE_TEST_SUITE_P(
    Shapes, CrackedBoxes,
    testing::Values(Expected{"shape = \"penny_crack_block\"\nhalf_width = \"6 m\"\ncrack_radius = \"2 m\"", 0.5, 1728, 4 * pi, 0.011},
                    Expected{"shape = \"penny_crack_block\"\nhalf_width = \"6 m\"\ncrack_radius = \"2 m\"\ncrack_angle = \"37 deg\"", 0.5, 1728, 4 * pi, 0.011},
                    Expected{"shape = \"elliptical_crack_block\"\nhalf_width = \"6 m\"\nhalf_axis_x = \"2 m\"\nhalf_axis_y = \"1 m\"\ncrack_angle = \"20 deg\"", 0.3, 1728, 2 * pi, 0.015},
                    Expected{"shape = \"corner_crack_block\"\nwidth = \"5 m\"\nhalf_height = \"5 m\"\ncrack_radius = \"2 m\"\ncrack_angle = \"25 deg\"", 0.3, 250, pi, 0.015},
                    Expected{"shape = \"cap_crack_block\"\nhalf_width = \"6 m\"\ncrack_radius = \"2 m\"\nopening_angle = \"40 deg\"\ncrack_angle = \"15 deg\"", 0.4, 1728,
                             2 * pi * 4 * (1 - 0.766044443) / (0.642787610 * 0.642787610), 0.02, false},
                    Expected{"shape = \"through_crack_block\"\nhalf_width = \"3 m\"\nhalf_height = \"3 m\"\nthickness = \"0.3 m\"\ncrack_half_length = \"1 m\"\ncrack_angle = \"30 deg\"", 0.1, 10.8, 0.6, 1e-9},
                    Expected{"shape = \"through_crack_block\"\nhalf_width = \"3 mm\"\nhalf_height = \"3 mm\"\nthickness = \"0.3 mm\"\ncrack_half_length = \"1 mm\"\ncrack_angle = \"30 deg\"", 1e-4, 10.8e-9, 0.6e-6, 1e-9},
                    Expected{"shape = \"edge_crack_block\"\nwidth = \"3 m\"\nhalf_height = \"3 m\"\nthickness = \"0.3 m\"\ncrack_length = \"1 m\"\ncrack_angle = \"-20 deg\"", 0.1, 5.4, 0.3, 1e-9}));

}  // namespace
}  // namespace cleave::geometry
