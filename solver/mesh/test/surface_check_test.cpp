#include "solver/mesh/surface_check.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/surface_marks.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace cleave::mesh {
namespace {

using test::cube_surface;
using test::sphere_surface;

std::string complaint(const SurfaceMesh& surface) {
    try {
        check_surface(surface, "body.stl");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

SurfaceMesh moved(SurfaceMesh surface, const Eigen::Vector3d& by) {
    for (auto& x : surface.vertices) x += by;
    return surface;
}

SurfaceMesh both(SurfaceMesh one, const SurfaceMesh& two) {
    const int first = static_cast<int>(one.vertices.size());
    one.vertices.insert(one.vertices.end(), two.vertices.begin(), two.vertices.end());
    for (const SurfaceTriangle& t : two.triangles) one.triangles.push_back({{t.vertices[0] + first, t.vertices[1] + first, t.vertices[2] + first}, t.id});
    return one;
}

TEST(SurfaceMesh, VolumeAndAreaAreThoseOfMathematics) {
    EXPECT_DOUBLE_EQ(enclosed_volume(cube_surface()), 1);
    EXPECT_DOUBLE_EQ(total_area(cube_surface()), 6);
    EXPECT_NEAR(enclosed_volume(moved(cube_surface(), {1e6, 0, 0})), 1, 1e-9);  // relative to a vertex: no cancellation of 1e18 in the sums
    // An equilateral facet of edge a lies a^2 / 8 below the sphere in the mean: the ball loses 3/8 a^2 of its volume, a^2 = 4 / sqrt(3) times the
    // facet's area. An octahedron's facets differ by up to 2 in area, so that the loss is somewhat larger: 25 %.
    const double facet = 4 * std::numbers::pi / (8 * 256), loss = 3.0 / 8 * 4 / std::sqrt(3) * facet;
    EXPECT_NEAR(1 - enclosed_volume(sphere_surface(4)) / (4 * std::numbers::pi / 3), loss, 0.25 * loss);
}

TEST(SurfaceCheck, PassesSoundSurfaces) {
    EXPECT_EQ(complaint(cube_surface()), "");
    EXPECT_EQ(complaint(sphere_surface(3)), "");
    SurfaceMesh with_spare = cube_surface();
    with_spare.vertices.emplace_back(0, 0, 0);  // used by no triangle: no duplicate
    EXPECT_EQ(complaint(with_spare), "");
}

TEST(SurfaceCheck, NamesWhatIsWrongWithOneTriangle) {
    EXPECT_EQ(complaint({}), "body.stl: expected at least one triangle");
    SurfaceMesh surface = cube_surface();
    surface.vertices[2][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint(surface), "body.stl: vertex 3: expected finite coordinates");
    surface = cube_surface();
    surface.triangles[4].vertices[1] = 8;
    EXPECT_EQ(complaint(surface), "body.stl: triangle 5: expected vertices from 1 to 8, not 9");
    surface = cube_surface();
    surface.triangles[4].vertices[1] = surface.triangles[4].vertices[0];
    EXPECT_EQ(complaint(surface), "body.stl: triangle 5: expected an area (it has 0 m^2)");
}

TEST(SurfaceCheck, NamesOpenAndUnweldedSurfaces) {
    SurfaceMesh surface = cube_surface();
    surface.triangles.pop_back();
    EXPECT_EQ(complaint(surface), "body.stl: edge from vertex 5 to 7: expected a closed surface (only triangle 1 is here; 3 open edges in all)");
    surface = cube_surface();
    surface.vertices.push_back(surface.vertices[7]);
    surface.triangles[11].vertices[1] = 8;
    EXPECT_EQ(complaint(surface), "body.stl: vertex 9: expected a welded surface (vertex 8 stands at the same point)");
}

TEST(SurfaceCheck, NamesTurnedTriangles) {
    SurfaceMesh surface = cube_surface();
    std::swap(surface.triangles[0].vertices[0], surface.triangles[0].vertices[1]);
    EXPECT_NE(complaint(surface).find("to face the same way (one of them is turned over)"), std::string::npos) << complaint(surface);
    surface = cube_surface();
    for (auto& triangle : surface.triangles) std::swap(triangle.vertices[0], triangle.vertices[1]);
    EXPECT_EQ(complaint(surface), "body.stl: expected triangles that face outwards (the surface is inside out: its volume is -1 m^3)");
}

TEST(SurfaceCheck, NamesDoubledTrianglesAndEdgesOfFour) {
    SurfaceMesh surface = cube_surface();
    surface.triangles.push_back(surface.triangles[3]);
    EXPECT_EQ(complaint(surface), "body.stl: triangle 13: expected each triangle once (it is triangle 4 again)");
    // Two cubes that share an edge (x = 1, y = 1): four triangles meet there.
    surface = both(cube_surface(), moved(cube_surface(), {1, 1, 0}));
    for (auto& triangle : surface.triangles) {
        for (int& vertex : triangle.vertices) vertex = vertex == 8 ? 3 : vertex == 12 ? 7 : vertex;
    }
    EXPECT_EQ(complaint(surface), "body.stl: edge from vertex 4 to 8: expected a manifold surface (4 triangles share it)");
}

TEST(SurfaceCheck, NamesSheetsThatTouchAndSeveralShells) {
    SurfaceMesh surface = both(cube_surface(), moved(cube_surface(), {1, 1, 1}));
    for (auto& triangle : surface.triangles) {
        for (int& vertex : triangle.vertices) vertex = vertex == 8 ? 7 : vertex;
    }
    EXPECT_EQ(complaint(surface), "body.stl: vertex 8: expected a manifold surface (two sheets touch in this point)");
    EXPECT_EQ(complaint(both(cube_surface(), moved(cube_surface(), {3, 0, 0}))),
              "body.stl: expected one closed shell (this surface has 2: cavities and loose pieces cannot be meshed)");
}

TEST(SurfaceCheck, NamesSelfIntersections) {
    // The pole pushed through the other side of the sphere: still closed and oriented, and its volume positive.
    SurfaceMesh surface = sphere_surface(3);
    surface.vertices[4] = {0, 0, -1.2};
    EXPECT_GT(enclosed_volume(surface), 0);
    EXPECT_NE(complaint(surface).find("expected no self-intersection (triangle "), std::string::npos) << complaint(surface);
    surface.vertices[4] = {0, 0, -0.9};  // a spike that stops inside: sound, the check must not cry
    EXPECT_EQ(complaint(surface), "");
}

TEST(SurfaceMarks, SharpEdgesPartACubeButNotASphere) {
    SurfaceMesh cube = cube_surface();
    split_at_sharp_edges(cube);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(cube.triangles[i].id, static_cast<int>(i / 2) + 1);
    SurfaceMesh sphere = sphere_surface(3);
    split_at_sharp_edges(sphere);
    for (const SurfaceTriangle& triangle : sphere.triangles) EXPECT_EQ(triangle.id, 0);
    cube.triangles[0].id = 9;  // patches of the file's own stay
    const SurfaceMesh before = cube;
    split_at_sharp_edges(cube);
    EXPECT_EQ(cube.triangles, before.triangles);
}

TEST(SurfaceMarks, EachFaceGetsThePatchItLiesOn) {
    SurfaceMesh cube = cube_surface();
    split_at_sharp_edges(cube);
    cube.names = {{1, "left"}, {6, "top"}};
    TetMesh mesh = test::kuhn_cube(3);
    mark_surface(mesh, cube);
    EXPECT_EQ(mesh.surface.size(), 6u * 9 * 2);
    EXPECT_EQ(mesh.surface_names, cube.names);
    for (const SurfaceTriangle& triangle : mesh.surface) {
        for (const int vertex : triangle.vertices) {
            const Eigen::Vector3d& x = mesh.vertices[vertex];
            EXPECT_EQ(x[(triangle.id - 1) / 2], (triangle.id - 1) % 2) << triangle.id;
        }
    }
}

}  // namespace
}  // namespace cleave::mesh
