// The bodies of the finite element benchmarks: elliptic plate, layered strip, block with a circle on its top.

#include "solver/input/input_error.hpp"
#include "solver/input/table_reader.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/geometry/contact_block.hpp"
#include "validation/geometry/shape.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <numbers>

namespace cleave::geometry {
namespace {

const ScratchFolder folder;

struct Measured {
    mesh::TetMesh mesh;
    std::map<std::string, double> area, volume;  // by name
};

Measured measure(const Body& body) {
    Measured measured{mesh::read_msh(body.mesh_file), {}, {}};
    const mesh::TetMesh& mesh = measured.mesh;
    mesh::check(mesh, "shape");
    const auto at = [&](int vertex) { return mesh.vertices[static_cast<std::size_t>(vertex)]; };
    for (const auto& [name, tag] : body.surfaces)
        for (const mesh::SurfaceTriangle& t : mesh.surface)
            if (t.id == tag) measured.area[name] += (at(t.vertices[1]) - at(t.vertices[0])).cross(at(t.vertices[2]) - at(t.vertices[0])).norm() / 2;
    for (const auto& [name, tag] : body.regions)
        for (std::size_t i = 0; i < mesh.tets.size(); ++i)
            if (mesh.regions[i] == tag) {
                const auto& t = mesh.tets[i];
                measured.volume[name] += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).dot(at(t[3]) - at(t[0])) / 6;
            }
    return measured;
}

std::shared_ptr<const Shape> shape(const std::string& text) {
    TableReader reader = TableReader::from_text(text, "shape.toml");
    auto made = read_shape(reader);
    reader.finish();
    return made;
}

TEST(EllipticPlate, HasItsSidesAndALineAtMidHeight) {
    const auto plate = shape("shape = \"elliptic_plate\"\ninner = [\"2 m\", \"1 m\", \"0 m\"]\nouter = [\"3.25 m\", \"2.75 m\", \"0 m\"]\nthickness = \"0.6 m\"\n");
    const Measured plate_mesh = measure(plate->mesh(0.3, folder));
    const double face = std::numbers::pi / 4 * (3.25 * 2.75 - 2 * 1);
    EXPECT_NEAR(plate_mesh.area.at("top"), face, 0.01 * face);  // facets
    EXPECT_NEAR(plate_mesh.volume.at("body"), plate_mesh.area.at("top") * 0.6, 0.002 * face);
    EXPECT_NEAR(plate_mesh.area.at("symmetry_x"), 1.75 * 0.6, 1e-9);
    EXPECT_NEAR(plate_mesh.area.at("symmetry_y"), 1.25 * 0.6, 1e-9);
    EXPECT_NEAR(plate_mesh.area.at("outer_lower") / plate_mesh.area.at("outer_upper"), 1, 1e-7);  // OCC places points to 1e-7 or so
    EXPECT_THROW(shape("shape = \"elliptic_plate\"\ninner = [\"4 m\", \"1 m\", \"0 m\"]\nouter = [\"3.25 m\", \"2.75 m\", \"0 m\"]\nthickness = \"0.6 m\"\n"), InputError);
}

TEST(LayeredStrip, AlternatesItsLayersAndSplitsItsBottom) {
    const auto strip = shape("shape = \"layered_strip\"\nlength = \"25 mm\"\nwidth = \"5 mm\"\nsupport = \"10 mm\"\nthicknesses = [\"0.1 mm\", \"0.4 mm\", \"0.2 mm\"]\n");
    const Measured strip_mesh = measure(strip->mesh(1e-4, folder));
    EXPECT_NEAR(strip_mesh.volume.at("odd"), 0.025 * 0.005 * 0.3e-3, 1e-17);
    EXPECT_NEAR(strip_mesh.volume.at("even"), 0.025 * 0.005 * 0.4e-3, 1e-17);
    EXPECT_NEAR(strip_mesh.area.at("bottom_outer"), 0.010 * 0.005, 1e-14);
    EXPECT_NEAR(strip_mesh.area.at("bottom_inner"), 0.015 * 0.005, 1e-14);
    EXPECT_NEAR(strip_mesh.area.at("top"), 0.025 * 0.005, 1e-14);
    EXPECT_THROW(shape("shape = \"layered_strip\"\nlength = \"25 mm\"\nwidth = \"5 mm\"\nsupport = \"30 mm\"\nthicknesses = [\"0.1 mm\", \"0.4 mm\"]\n"), InputError);
}

TEST(ContactBlock, ItsPartsAreHalfAndQuarter) {
    for (const int sectors : {4, 2}) {
        const Measured block = measure(mesh_contact_block({.contact_radius = 1e-3, .half_width = 6e-3, .sectors = sectors}, 4e-4, folder));
        const double whole = 12e-3 * 12e-3 * 6e-3;
        EXPECT_NEAR(block.volume.at("body"), whole / sectors, 1e-12 * whole);
        EXPECT_NEAR(block.area.at("contact") * sectors, std::numbers::pi * 1e-6, 0.05 * std::numbers::pi * 1e-6);
        EXPECT_NEAR((block.area.at("contact") + block.area.at("top")) * sectors, 144e-6, 1e-15);
        EXPECT_NEAR(block.area.at("symmetry_x"), sectors == 4 ? 36e-6 : 72e-6, 1e-15);
    }
}

}  // namespace
}  // namespace cleave::geometry
