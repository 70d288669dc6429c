#include "solver/mesh/tet_mesh.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace cleave::mesh {
namespace {

using test::kuhn_cube;
using test::unit_tet;

/// The message of the InputError that check throws; empty where it throws none.
std::string complaint(const TetMesh& mesh) {
    try {
        check(mesh, "body.msh");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(TetMesh, VolumeAndCentroidOfTheUnitTet) {
    const TetMesh mesh = unit_tet();
    EXPECT_DOUBLE_EQ(tet_volume(mesh, 0), 1.0 / 6);
    EXPECT_TRUE(tet_centroid(mesh, 0).isApprox(Eigen::Vector3d::Constant(0.25), 1e-15));
}

TEST(TetMesh, FacesPointOutwards) {
    const TetMesh mesh = unit_tet();
    for (int face = 0; face < 4; ++face) {
        const auto [a, b, c] = face_of(mesh.tets[0], face);
        const Eigen::Vector3d normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
        EXPECT_LT(normal.dot(mesh.vertices[mesh.tets[0][face]] - mesh.vertices[a]), 0) << "face " << face;
    }
}

TEST(TetMesh, DihedralAngles) {
    TetMesh mesh = unit_tet();
    // Corner tet: the slanted face meets each coordinate plane at acos(1/sqrt 3) = 54.74 degrees.
    EXPECT_NEAR(smallest_dihedral_angle(mesh, 0), std::acos(1 / std::sqrt(3.0)), 1e-14);
    mesh.vertices = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}};
    EXPECT_NEAR(smallest_dihedral_angle(mesh, 0), std::acos(1.0 / 3), 1e-14);  // regular
}

TEST(TetMesh, CubeFillsItsVolume) {
    const TetMesh mesh = kuhn_cube(4, 0.1);
    check(mesh, "cube");
    EXPECT_NEAR(total_volume(mesh), 1, 1e-14);  // 384 terms of 1/384: rounding only
}

TEST(HalfFaceLinks, AreSymmetricAndFindTheBoundary) {
    const TetMesh mesh = kuhn_cube(3);
    const HalfFaceLinks links = link_half_faces(mesh);
    int boundary = 0;
    for (std::size_t h = 0; h < links.opposite.size(); ++h) {
        const int other = links.opposite[h];
        if (other < 0) {
            ++boundary;
            continue;
        }
        EXPECT_EQ(links.opposite[other], static_cast<int>(h));
        EXPECT_NE(other / 4, static_cast<int>(h / 4));
    }
    EXPECT_EQ(boundary, 6 * 9 * 2);  // two triangles per square of the surface
}

TEST(HalfFaceLinks, RefusesAThirdTet) {
    TetMesh mesh = unit_tet();
    mesh.vertices.insert(mesh.vertices.end(), {{1, 1, 1}, {2, 2, 2}});
    mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}};
    EXPECT_THROW(link_half_faces(mesh), std::invalid_argument);
}

TEST(Check, PassesGoodMeshesAndUnusedVertices) {
    TetMesh mesh = unit_tet();
    mesh.vertices.emplace_back(9, 9, 9);
    EXPECT_EQ(complaint(mesh), "");
    EXPECT_EQ(complaint(kuhn_cube(3, 0.2)), "");
}

TEST(Check, NamesAnInvertedTetAndItsVolume) {
    TetMesh mesh = kuhn_cube(2);
    std::swap(mesh.tets[6][0], mesh.tets[6][1]);
    EXPECT_EQ(complaint(mesh), "body.msh: tet 7: expected a positive volume (it is inverted: -0.0208333 m^3)");
}

TEST(Check, NamesAFlatTet) {
    TetMesh mesh = unit_tet();
    mesh.vertices[3] = {0.3, 0.3, 1e-17};
    EXPECT_NE(complaint(mesh).find("tet 1: expected a positive volume (it is flat"), std::string::npos);
    mesh.vertices[3] = {0.3, 0.3, 1e-12};  // a sliver, but not flat
    EXPECT_EQ(complaint(mesh), "");
}

TEST(Check, ScaleDoesNotMatter) {
    TetMesh mesh = kuhn_cube(2);
    for (auto& vertex : mesh.vertices) vertex *= 1e-9;
    EXPECT_EQ(complaint(mesh), "");
}

TEST(Check, NamesBadVertices) {
    TetMesh mesh = unit_tet();
    mesh.vertices[2][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint(mesh), "body.msh: vertex 3: expected finite coordinates");
    mesh = unit_tet();
    mesh.tets[0][3] = 4;
    EXPECT_EQ(complaint(mesh), "body.msh: tet 1: expected vertices from 1 to 4, not 5");
    mesh.tets[0][3] = 2;
    EXPECT_NE(complaint(mesh).find("four different vertices"), std::string::npos);
    mesh = unit_tet();
    mesh.surface = {{{0, 1, 7}, 5}};
    EXPECT_EQ(complaint(mesh), "body.msh: triangle 1: expected vertices from 1 to 4, not 8");
}

TEST(Check, NamesADuplicateTetAndACrowdedFace) {
    TetMesh mesh = kuhn_cube(1);
    mesh.tets.push_back(mesh.tets[2]);
    mesh.regions.push_back(1);
    EXPECT_EQ(complaint(mesh), "body.msh: tet 7: expected each tet once (it is tet 3 again)");
    mesh = unit_tet();
    mesh.vertices.insert(mesh.vertices.end(), {{1, 1, 1}, {2, 2, 2}});
    mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}};
    mesh.regions = {1, 1, 1};
    EXPECT_EQ(complaint(mesh), "body.msh: tet 3: expected at most two tets at a face (tets 1 and 2 share it already)");
}

TEST(Check, NamesTwoTetsOnOneSideOfTheirFace) {
    TetMesh mesh = unit_tet();
    mesh.vertices.emplace_back(0.1, 0.1, 0.1);
    mesh.tets = {{0, 1, 2, 3}, {4, 1, 2, 3}};
    mesh.regions = {1, 1};
    EXPECT_EQ(complaint(mesh), "body.msh: tet 2: expected no overlap (tet 1 lies on the same side of their face)");
}

TEST(Check, NamesAnEmptyMeshAndMissingRegions) {
    TetMesh mesh;
    EXPECT_EQ(complaint(mesh), "body.msh: tets: expected at least one tet");
    mesh = unit_tet();
    mesh.regions.clear();
    EXPECT_NE(complaint(mesh).find("one region per tet"), std::string::npos);
}

}  // namespace
}  // namespace cleave::mesh
