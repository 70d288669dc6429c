#include "solver/fracture/toughness.hpp"

#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::fracture {
namespace {

const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();

TEST(Toughness, UniformKnowsNoDirection) {
    const Toughness toughness = Toughness::uniform(8);
    for (const Eigen::Vector3d& n : {x, y, Eigen::Vector3d(0.6, 0, 0.8)}) EXPECT_EQ(toughness.energy(n), 8);
}

TEST(Toughness, WeakPlaneAfterSaouma) {
    const Toughness toughness = Toughness::weak_plane(8, 3 * z, 2);
    EXPECT_DOUBLE_EQ(toughness.energy(z), 8) << "in the weak plane";
    EXPECT_DOUBLE_EQ(toughness.energy(x), 8 * 4) << "across it: K twice, G four times";
    const double angle = 0.4;
    const Eigen::Vector3d tilted(std::sin(angle), 0, std::cos(angle));
    EXPECT_NEAR(toughness.intensity_ratio(tilted), std::pow(std::cos(angle), 2) + 2 * std::pow(std::sin(angle), 2), 1e-14);
    EXPECT_DOUBLE_EQ(toughness.energy(tilted), toughness.energy(-tilted)) << "a plane has two normals";
}

TEST(Toughness, FibreMakesEveryPlaneAlongItWeak) {
    const Toughness toughness = Toughness::fibre(8, x, 3);
    EXPECT_DOUBLE_EQ(toughness.energy(y), 8);
    EXPECT_DOUBLE_EQ(toughness.energy(z), 8);
    EXPECT_DOUBLE_EQ(toughness.energy(x), 8 * 9) << "across the fibre";
}

TEST(Toughness, TableInterpolatesItsAngles) {
    const double quarter = std::numbers::pi / 2;
    const Toughness toughness = Toughness::weak_plane(8, z, 1).with_table({0, quarter / 2, quarter}, {1, 1.2, 2});
    EXPECT_DOUBLE_EQ(toughness.intensity_ratio(z), 1);
    EXPECT_NEAR(toughness.intensity_ratio(Eigen::Vector3d(1, 0, 1).normalized()), 1.2, 1e-12);
    EXPECT_NEAR(toughness.intensity_ratio(x), 2, 1e-12);
    EXPECT_NEAR(toughness.intensity_ratio(Eigen::Vector3d(std::sin(quarter * 0.75), 0, std::cos(quarter * 0.75))), 1.6, 1e-12);
    EXPECT_THROW(toughness.with_table({0, 1}, {1, 2}), std::invalid_argument) << "must reach 90 degrees";
    EXPECT_THROW(toughness.with_table({0, quarter}, {1, -2}), std::invalid_argument);
}

Brittleness read(const std::string& text, double strength = 4e7, double toughness = 8) {
    TableReader table = TableReader::from_text(text, "scene.toml");
    const Brittleness result = read_brittleness(table, strength, toughness, material::isotropic(7e10, 0.25));
    table.finish();
    return result;
}

TEST(Brittleness, ReadsItsKeys) {
    EXPECT_NEAR(read("").strain_limit, 4e7 / 7e10, 1e-15) << "strength over Young's modulus";
    EXPECT_DOUBLE_EQ(read("strain_limit = 0.002\nstrength = \"50 MPa\"").strain_limit, 0.002);
    EXPECT_DOUBLE_EQ(read("toughness = \"3 J/m^2\"\nweak_plane = { normal = [0, 2, 0], ratio = 2 }").toughness.energy(x), 12);
    EXPECT_NEAR(read("fibre = { direction = [1, 0, 0], angle = [\"0 deg\", \"90 deg\"], ratio = [1, 2] }").toughness.energy(x), 32, 1e-9);
}

TEST(Brittleness, RejectsWhatAUserCanMend) {
    EXPECT_THROW(read("", 0), InputError) << "a material without strength";
    EXPECT_THROW(read("strength = \"-1 MPa\""), InputError);
    EXPECT_THROW(read("weak_plane = { normal = [0, 0, 0], ratio = 2 }"), InputError);
    EXPECT_THROW(read("weak_plane = { normal = [0, 1, 0], ratios = 2 }"), InputError) << "a misspelt key";
    EXPECT_THROW(read("weak_plane = { normal = [0, 1, 0], angle = [\"0 deg\", \"80 deg\"], ratio = [1, 2] }"), InputError);
    EXPECT_THROW(read("weak_plane = { normal = [0, 1, 0], ratio = 2 }\nfibre = { direction = [1, 0, 0], ratio = 2 }"), InputError);
}

}  // namespace
}  // namespace cleave::fracture
