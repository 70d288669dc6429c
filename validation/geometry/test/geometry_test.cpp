#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/table_reader.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/obj_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/mesh/vtu_file.hpp"
#include "validation/geometry/shape.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

namespace cleave::geometry {
namespace {

const ScratchFolder folder;

std::shared_ptr<const Shape> shape(const std::string& text) {
    TableReader reader = TableReader::from_text(text, "shape.toml");
    auto made = read_shape(reader);
    reader.finish();
    return made;
}

/// Vector area (sum of outward normals times area) of each tagged surface.
std::map<int, double> areas(const mesh::TetMesh& mesh) {
    std::map<int, double> sum;
    for (const mesh::SurfaceTriangle& t : mesh.surface) {
        const auto& v = mesh.vertices;
        sum[t.id] += (v[static_cast<std::size_t>(t.vertices[1])] - v[static_cast<std::size_t>(t.vertices[0])])
                         .cross(v[static_cast<std::size_t>(t.vertices[2])] - v[static_cast<std::size_t>(t.vertices[0])])
                         .norm() / 2;
    }
    return sum;
}

TEST(Block, HasItsVolumeAndSides) {
    const auto block = shape("shape = \"block\"\nextent = [\"2 m\", \"1 m\", \"0.5 m\"]\n");
    const Body body = block->mesh(0.3, folder);
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    mesh::check(mesh, "block");
    EXPECT_NEAR(mesh::total_volume(mesh), 1, 1e-12);
    const std::map<int, double> area = areas(mesh);
    EXPECT_NEAR(area.at(body.surfaces.at("left")), 0.5, 1e-12);
    EXPECT_NEAR(area.at(body.surfaces.at("back")), 1.0, 1e-12);
    EXPECT_NEAR(area.at(body.surfaces.at("top")), 2.0, 1e-12);
    EXPECT_EQ(area.size(), 6U);
    EXPECT_NEAR(block->coordinates().at("depth")({1, 0.4, 0.25}), 0.25, 1e-15);
}

TEST(Block, IsMeshedAlikeEachTimeAndFinerWhenAsked) {
    const auto block = shape("shape = \"block\"\nextent = [\"1 m\", \"1 m\", \"1 m\"]\n");
    std::filesystem::remove_all(folder / "a");
    std::filesystem::remove_all(folder / "b");
    const auto one = mesh::read_msh(block->mesh(0.4, folder / "a").mesh_file), two = mesh::read_msh(block->mesh(0.4, folder / "b").mesh_file);
    EXPECT_EQ(one.tets, two.tets);
    EXPECT_EQ(one.vertices, two.vertices);
    // Half the size: eight times the tets far from the surface; coarse meshes gain a little less.
    const std::size_t coarse = mesh::read_msh(block->mesh(0.2, folder).mesh_file).tets.size();
    EXPECT_GT(mesh::read_msh(block->mesh(0.1, folder).mesh_file).tets.size(), 6 * coarse);
}

TEST(PlateWithHole, QuarterHasItsVolumeAndTags) {
    const auto plate = shape("shape = \"plate_with_hole\"\nhole_radius = \"1 m\"\nhalf_width = \"5 m\"\nthickness = \"0.3 m\"\nsector = \"quarter\"\n");
    const Body body = plate->mesh(0.3, folder);
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    mesh::check(mesh, "plate");
    // the rim's facets cut off 1 - sin(t)/t of the disc, t = facet angle <= 0.1: below 2e-3 of pi/4
    const double exact = 0.3 * (25 - std::numbers::pi / 4);
    EXPECT_NEAR(mesh::total_volume(mesh), exact, 0.3 * 2e-3 * std::numbers::pi / 4);
    const std::map<int, double> area = areas(mesh);
    EXPECT_NEAR(area.at(body.surfaces.at("right")), 1.5, 1e-9);
    EXPECT_NEAR(area.at(body.surfaces.at("symmetry_x")), 1.2, 1e-9);
    EXPECT_NEAR(area.at(body.surfaces.at("hole")), 0.3 * std::numbers::pi / 2, 1e-3);
    EXPECT_EQ(area.size(), body.surfaces.size());
    for (const auto& x : mesh.vertices) EXPECT_GE(std::hypot(x[0], x[1]), 1 - 1e-9);
}

TEST(PlateWithHole, FullPlateIsFourQuarters) {
    const auto plate = shape("shape = \"plate_with_hole\"\nhole_radius = \"1 m\"\nhalf_width = \"5 m\"\nthickness = \"0.3 m\"\n");
    const Body body = plate->mesh(0.5, folder);
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    EXPECT_NEAR(mesh::total_volume(mesh), 0.3 * (100 - std::numbers::pi), 0.3 * 6e-3 * std::numbers::pi);
    EXPECT_EQ(areas(mesh).size(), 7U);
}

TEST(Imported, UsesTheFilesTagsAndRefusesInvertedTets) {
    const auto block = shape("shape = \"block\"\nextent = [\"1 m\", \"1 m\", \"1 m\"]\n");
    const std::string file = block->mesh(0.5, folder).mesh_file.string();
    const auto imported = shape("mesh = \"" + file + "\"\n");
    EXPECT_EQ(imported->surface_names().size(), 6U);
    EXPECT_GT(imported->length("mesh_size"), 0.1);
    mesh::TetMesh mesh = mesh::read_msh(file);
    std::swap(mesh.tets[3][0], mesh.tets[3][1]);
    mesh::write_msh(mesh, folder / "inverted.msh");
    EXPECT_THROW(shape("mesh = \"" + (folder / "inverted.msh").string() + "\"\n"), InputError);
}

TEST(Imported, SurfacesAreMeshedAtTheLaddersSize) {
    const std::filesystem::path file = folder / "cube.obj";
    write_file_atomic(file, mesh::format_obj(mesh::test::cube_surface()));
    for (const char* mesher : {"netgen", "gmsh"}) {
        const auto cube = shape("mesh = \"" + file.string() + "\"\nmesher = \"" + mesher + "\"\n");
        EXPECT_EQ(cube->length("extent"), 1);
        EXPECT_THROW(cube->length("mesh_size"), std::invalid_argument);  // so that a case needs a ladder
        const Body body = cube->mesh(0.5, folder);
        const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
        mesh::check(mesh, mesher);
        EXPECT_NEAR(mesh::total_volume(mesh), 1, 1e-12);
        const std::map<int, double> area = areas(mesh);
        for (const std::string& name : cube->surface_names()) EXPECT_NEAR(area.at(body.surfaces.at(name)), 1, 1e-12) << name;
        EXPECT_EQ(area.size(), 6U);
        EXPECT_EQ(cube->mesh(0.5, folder).mesh_file, body.mesh_file);
        EXPECT_NE(cube->mesh(0.9, folder).mesh_file, body.mesh_file);
    }
}

TEST(Imported, TetsOfOtherFormatsBecomeOneMsh) {
    const mesh::TetMesh mesh = mesh::test::kuhn_cube(2);
    write_file_atomic(folder / "cube.vtu", mesh::format_vtu(mesh));
    const auto cube = shape("mesh = \"" + (folder / "cube.vtu").string() + "\"\n");
    EXPECT_GT(cube->length("mesh_size"), 0.1);
    const mesh::TetMesh read = mesh::read_msh(cube->mesh(1, folder).mesh_file);
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.tets, mesh.tets);
}

TEST(Imported, BrokenSurfacesAreOneLine) {
    mesh::SurfaceMesh open = mesh::test::cube_surface();
    open.triangles.pop_back();
    write_file_atomic(folder / "open.obj", mesh::format_obj(open));
    EXPECT_THROW(shape("mesh = \"" + (folder / "open.obj").string() + "\"\n"), InputError);
    mesh::write_msh(mesh::test::kuhn_cube(1), folder / "tets.msh");
    EXPECT_NO_THROW(shape("mesh = \"" + (folder / "tets.msh").string() + "\"\n"));
    EXPECT_THROW(shape("mesh = \"" + (folder / "tets.msh").string() + "\"\nmesher = \"gmsh\"\n"), InputError);  // tets are not meshed
}

}  // namespace
}  // namespace cleave::geometry
