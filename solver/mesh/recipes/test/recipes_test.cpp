#include "solver/mesh/recipes/recipes.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/obj_file.hpp"
#include "solver/mesh/recipes/pot.hpp"
#include "solver/mesh/recipes/tai_chi.hpp"
#include "solver/mesh/recipes/test/test_bodies.hpp"
#include "solver/mesh/recipes/window.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <Eigen/Geometry>
#include <gmsh.h>
#include <gtest/gtest.h>


#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::mesh {
namespace {

using test::expect_sound;
using test::recipe;
using test::region_volumes;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// Volume of the revolved pot by Pappus: 2 pi times the first moment of the profile about the axis, the profile's curves as polygons.
double pappus_volume(const PotShape& shape) {
    const GmshSession session;
    session.new_model("profile");
    return session.run([&] {
        const int face = add_pot_profile(shape);
        gmsh::model::occ::synchronize();
        gmsh::vectorpair curves;
        gmsh::model::getBoundary({{2, face}}, curves, true, true);
        double moment = 0;
        for (const auto& [dimension, tag] : curves) {
            std::vector<double> low, high, at, points;
            gmsh::model::getParametrizationBounds(dimension, std::abs(tag), low, high);
            constexpr int parts = 4000;
            for (int i = 0; i <= parts; ++i) at.push_back(low[0] + (high[0] - low[0]) * i / parts);
            gmsh::model::getValue(dimension, std::abs(tag), at, points);
            double sum = 0;  // of r^2 / 2 dz along the curve (Green's theorem for the moment of r dr dz)
            for (int i = 0; i < parts; ++i) {
                const double r = points[3 * i], s = points[3 * i + 3], dz = points[3 * i + 5] - points[3 * i + 2];
                sum += (r * r + r * s + s * s) / 6 * dz;
            }
            moment += tag > 0 ? sum : -sum;
        }
        return 2 * pi * std::abs(moment);
    });
}

TEST(Pot, HasTheVolumeOfPappus) {
    const Body body = pot(6163);
    // Chords of the mesh's edge h = 0.012 m cut off h^2 / 12R of outer walls and add it to inner ones (R about 0.1): what is left is the difference,
    // half the wall over R of 2 h^2 / (12 R wall) = 1.5 %, and the foot's and rim's corners: under 1 % in all.
    EXPECT_NEAR(total_volume(body.mesh), pappus_volume({}), 0.01 * pappus_volume({}));
}

TEST(Window, IsASlabToTheLastDigit) {
    BodySource source = recipe("window", 1743);
    source.mesher = Mesher::gmsh;
    const Body body = make_body(source);
    expect_sound(body, 1743);
    const WindowShape shape;
    EXPECT_NEAR(total_volume(body.mesh), shape.width * shape.height * shape.thickness, 1e-13);
    EXPECT_GT(body.record.smallest_dihedral, 10 * degree);
    EXPECT_EQ(body.mesh.region_names.at(1), "window");
}

TEST(TaiChi, HalvesAreEqualAndDotsLieInTheOtherHalf) {
    const Body body = make_body(recipe("tai_chi", 3880));
    expect_sound(body, 3880);
    const TaiChiShape shape;
    const std::map<int, double> volumes = region_volumes(body.mesh);
    ASSERT_EQ(volumes.size(), 2u);
    // The figure turned by half a turn swaps the materials, so each has half of the disc; facets of edge h cut (h/R)^2 / 6 off the rim, 0.4 % at
    // h = 0.15 R, and shift less than that between the halves.
    const double half = pi * shape.radius * shape.radius * shape.thickness / 2;
    for (const auto& [region, volume] : volumes) EXPECT_NEAR(volume, half, 0.004 * half) << region;
    // The rounded cusps: the classical figure gives flat tets of 2 degrees there.
    EXPECT_GT(body.record.smallest_dihedral, 8 * degree);
    const double middle = (shape.radius - shape.neck) / 2;
    for (std::size_t tet = 0; tet < body.mesh.tets.size(); ++tet) {
        const Eigen::Vector3d x = tet_centroid(body.mesh, static_cast<int>(tet));
        const double from_upper = std::hypot(x[0], x[1] - middle), from_lower = std::hypot(x[0], x[1] + middle);
        int wanted = 0;  // 0: near a border
        if (from_upper < 0.8 * shape.dot_radius) wanted = 1;
        else if (from_upper < middle - 0.15 * shape.radius && from_upper > 1.2 * shape.dot_radius) wanted = 2;
        if (from_lower < 0.8 * shape.dot_radius) wanted = 2;
        if (x[0] > 0.9 * shape.radius) wanted = 1;
        EXPECT_TRUE(wanted == 0 || body.mesh.regions[tet] == wanted) << x.transpose();
    }
}

TEST(Pet, CoarseOneIsHollow) {
    const Body body = make_body(recipe("pet", 4000));
    expect_sound(body, 4000);
    // Three closed surfaces without handles, the outside and two cavities: V - E + F = 6, with E = 3F/2.
    std::vector<bool> used(body.mesh.vertices.size(), false);
    for (const SurfaceTriangle& triangle : body.mesh.surface) {
        for (const int vertex : triangle.vertices) used[vertex] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), true) - static_cast<long>(body.mesh.surface.size()) / 2, 6);
}

TEST(Layers, ConformToTheirPlanesAndCarryFrames) {
    BodySource source = recipe("window", 2500);
    source.layers = Layers{{0, 0, 2}, 0.01, {0, 90 * degree}};
    const Body body = make_body(source);
    expect_sound(body, 2500);
    const WindowShape shape;
    const std::map<int, double> volumes = region_volumes(body.mesh);
    ASSERT_EQ(volumes.size(), 3u);
    for (const auto& [region, volume] : volumes) EXPECT_NEAR(volume, shape.width * shape.height * 0.01, 1e-13) << region;
    for (std::size_t tet = 0; tet < body.mesh.tets.size(); ++tet) {
        for (const int vertex : body.mesh.tets[tet]) {
            const double height = body.mesh.vertices[vertex][2];
            EXPECT_GE(height, (body.mesh.regions[tet] - 1) * 0.01 - 1e-12);
            EXPECT_LE(height, body.mesh.regions[tet] * 0.01 + 1e-12);
        }
    }
    EXPECT_EQ(body.mesh.region_names.at(2), "layer 2");
    ASSERT_EQ(body.frames.size(), 3u);
    EXPECT_TRUE(body.frames.at(1).isIdentity(1e-15));
    EXPECT_TRUE((body.frames.at(2) * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-15));
    EXPECT_TRUE(body.frames.at(3).isIdentity(1e-15));
}

TEST(Layers, ObliqueOnesCutTheBodyIntoItsVolume) {
    BodySource source = recipe("window", 4000);
    source.layers = Layers{{1, 0, 0.2}, 0.2, {0}};
    const Body body = make_body(source);
    EXPECT_EQ(region_volumes(body.mesh).size(), 4u);  // |normal . x| <= 0.25 / 1.02 + ...: -0.245 to 0.251 in steps of 0.2
    EXPECT_NEAR(total_volume(body.mesh), 0.5 * 0.5 * 0.03, 1e-13);
    EXPECT_EQ(body.frames.size(), 4u);
}

TEST(Recipes, RefuseWhatTheirMesherCannot) {
    BodySource source = recipe("tai_chi", 500);
    source.mesher = Mesher::netgen;
    EXPECT_THROW(make_body(source), MeshingError);
    source = recipe("window", 500);
    source.layers = Layers{{0, 0, 1}, 0.01, {0}};
    source.mesher = Mesher::netgen;
    EXPECT_THROW(make_body(source), MeshingError);
    source.mesher.reset();
    source.layers->thickness = 1e-6;
    EXPECT_THROW(make_body(source), MeshingError);  // 30,000 layers
    EXPECT_THROW(make_body(recipe("teapot", 500)), InputError);
}

BodySource source_of(const std::string& text) {
    TableReader reader = TableReader::from_text(text, "scene.toml");
    BodySource source = read_body_source(reader);
    reader.finish();
    return source;
}

std::string complaint(const std::string& text) {
    try {
        source_of(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(BodySource, ReadsRecipes) {
    BodySource wanted = recipe("pot", 6163);
    wanted.mesher = Mesher::netgen;
    EXPECT_EQ(source_of("recipe = { name = \"pot\", particles = 6163, mesher = \"netgen\" }\n"), wanted);
    const BodySource layered = source_of("recipe = { name = \"window\", layers = { thickness = \"1 cm\", angles = [\"0 deg\", \"90 deg\"] } }\n");
    ASSERT_TRUE(layered.layers);
    EXPECT_DOUBLE_EQ(layered.layers->thickness, 0.01);
    EXPECT_DOUBLE_EQ(layered.layers->angles.at(1), pi / 2);
    EXPECT_EQ(layered.particles, 0);
}

TEST(BodySource, NamesWhatIsWrong) {
    EXPECT_EQ(complaint("a = 1\n"), "scene.toml:1: expected exactly one of 'recipe', 'mesh' and 'surface'");
    EXPECT_NE(complaint("recipe = { name = \"teapot\" }\n").find("one of pot, window, pet, tai_chi"), std::string::npos);
    EXPECT_NE(complaint("recipe = { name = \"pot\", particles = 0 }\n").find("recipe.particles: expected 1 to"), std::string::npos);
    EXPECT_NE(complaint("recipe = { name = \"pot\", partciles = 5 }\n").find("particles"), std::string::npos);
    EXPECT_NE(complaint("recipe = { name = \"pot\", mesher = \"tetgen\" }\n").find("netgen"), std::string::npos);
    EXPECT_NE(complaint("mesh = \"nowhere.vtu\"\n").find("an existing file (not 'nowhere.vtu')"), std::string::npos);
    EXPECT_NE(complaint("recipe = { name = \"pot\", layers = { thickness = \"1 cm\", angles = [\"1 m\"] } }\n").find("angles like"), std::string::npos);
    EXPECT_NE(complaint("recipe = { name = \"pot\", layers = { thickness = \"0 cm\", angles = [\"1 deg\"] } }\n").find("more than 0"), std::string::npos);
}

TEST(BodySource, SurfacesAreMeshedAndCachedTetsTakenAsTheyAre) {
    const ScratchFolder folder;
    write_file_atomic(folder / "ball.obj", format_obj(test::sphere_surface(3)));
    write_msh(test::kuhn_cube(2), folder / "cube.msh");
    const BodySource surface = source_of("surface = { file = \"" + (folder / "ball.obj").string() + "\", particles = 1500, mesher = \"gmsh\" }\n");
    const Body fresh = make_body(surface, folder / "cache");
    EXPECT_NEAR(fresh.record.count, 1500, 30);
    EXPECT_EQ(format_msh(make_body(surface, folder / "cache").mesh), format_msh(fresh.mesh));
    const BodySource tets = source_of("mesh = \"" + (folder / "cube.msh").string() + "\"\n");
    EXPECT_EQ(make_body(tets).record.count, 48);
    EXPECT_EQ(make_body(tets).record.target, 0);
    BodySource counted = tets;
    counted.particles = 100;
    EXPECT_THROW(make_body(counted), InputError);
    EXPECT_EQ(source_of("surface = \"" + (folder / "ball.obj").string() + "\"\n").file, folder / "ball.obj");
}

}  // namespace
}  // namespace cleave::mesh
