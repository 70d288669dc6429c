#include "validation/stress_field.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace cleave::validation {
namespace {

using nlohmann::json;

/// Points along x, 1 m apart, each of 2 m^3, all with the same stress in the finite elements.
StressPair line(std::size_t count, const Voigt& fem, const Voigt& difference) {
    StressPair pair{"sph.conforming", "fem.p2", {}, {}, {}, {}};
    Voigt particles = fem;
    for (std::size_t k = 0; k < 6; ++k) particles[k] += difference[k];
    for (std::size_t i = 0; i < count; ++i) {
        pair.position.push_back({static_cast<double>(i), 0, 0});
        pair.volume.push_back(2);
        pair.fem.push_back(fem);
        pair.particles.push_back(particles);
    }
    return pair;
}

/// What a reader makes of `scale` and `data`.
std::vector<double> unpacked(const json& packed) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, held = 0;
    for (const char c : packed["data"].get<std::string>()) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<unsigned>(letters.find(c));
        if ((held += 6) < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 0xff);
    }
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        values.push_back(packed["scale"].get<double>() * static_cast<std::int16_t>(static_cast<unsigned char>(bytes[i]) | static_cast<unsigned char>(bytes[i + 1]) << 8));
    return values;
}

const json& measure(const json& field, const std::string& name) {
    for (const json& one : field["measures"])
        if (one["name"] == name) return one;
    throw std::out_of_range(name);
}

TEST(StressField, NormsAreWeightedByVolumeOverAllPoints) {
    StressPair pair = line(2, {1e6}, {});
    pair.fem[1][0] = 2e6;
    pair.particles = pair.fem;
    pair.particles[0][0] = 3e6;
    pair.volume = {1, 3};
    const json field = json::parse(stress_field_json(pair));
    EXPECT_DOUBLE_EQ(measure(field, "xx")["fem_rms"], 1e6 * std::sqrt((1 + 3 * 4) / 4.0));
    EXPECT_DOUBLE_EQ(measure(field, "xx")["difference_rms"], 2e6 * std::sqrt(1 / 4.0));
    EXPECT_DOUBLE_EQ(measure(field, "xx")["difference_max"], 2e6);
    EXPECT_EQ(measure(field, "xx")["at"], json({0.0, 0.0, 0.0}));
    EXPECT_EQ(measure(field, "yy")["difference_max"], 0.0);
}

// sigma_yz alone is a tension of that size at 45 degrees; pressure has no tension at all.
TEST(StressField, TheLargestPrincipalStressIsTheTension) {
    const json shear = json::parse(stress_field_json(line(3, {0, 0, 0, 5e6, 0, 0}, {0, 0, 0, 1e6, 0, 0})));
    EXPECT_NEAR(measure(shear, "largest_principal")["fem_rms"], 5e6, 1e-3);
    EXPECT_NEAR(measure(shear, "largest_principal")["difference_max"], 1e6, 1e-3);
    const json pressure = json::parse(stress_field_json(line(3, {-3e6, -3e6, -1e6}, {})));
    EXPECT_NEAR(measure(pressure, "largest_principal")["fem_rms"], 1e6, 1e-3);
}

TEST(StressField, PointsAndTensorsComeBack) {
    const Voigt fem{1e6, -2e6, 3e6, 4e5, -5e5, 6e5}, difference{1e3, 2e3, -3e3, 4e2, 5e2, -6e2};
    const json field = json::parse(stress_field_json(line(3, fem, difference)));
    EXPECT_EQ(field["shown"], 3);
    const std::vector<double> position = unpacked(field["position"]), radius = unpacked(field["radius"]), stress = unpacked(field["stress"]),
                              apart = unpacked(field["difference"]);
    ASSERT_EQ(position.size(), 9U);
    ASSERT_EQ(radius.size(), 3U);
    ASSERT_EQ(stress.size(), 18U);
    ASSERT_EQ(apart.size(), 18U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(position[3 * i], static_cast<double>(i), 2 / 32767.0);
        EXPECT_NEAR(4 * std::numbers::pi / 3 * std::pow(radius[i], 3), 2, 1e-3);
        for (std::size_t k = 0; k < 6; ++k) {
            EXPECT_NEAR(stress[6 * i + k], fem[k] + difference[k], 3e6 / 32767);
            EXPECT_NEAR(apart[6 * i + k], difference[k], 3e3 / 32767);
        }
    }
}

// Solvers that agree to nine digits: their difference is still drawn, not rounded away against the stress.
TEST(StressField, ASmallDifferenceStaysSharp) {
    const json field = json::parse(stress_field_json(line(2, {1e6}, {1e-3, 5e-4})));
    const std::vector<double> apart = unpacked(field["difference"]);
    EXPECT_NEAR(apart[0], 1e-3, 1e-6);
    EXPECT_NEAR(apart[1], 5e-4, 1e-6);
}

TEST(StressField, ManyPointsAreThinnedEvenlyAndStandForTheOthers) {
    const json field = json::parse(stress_field_json(line(12001, {1e6}, {})));
    EXPECT_EQ(field["total"], 12001);
    EXPECT_EQ(field["shown"], max_field_points);
    const std::vector<double> position = unpacked(field["position"]), radius = unpacked(field["radius"]);
    ASSERT_EQ(position.size(), 3 * max_field_points);
    EXPECT_EQ(position[0], 0);
    EXPECT_NEAR(position[3 * (max_field_points - 1)], 12000, 1e-6);
    for (std::size_t k = 1; k < max_field_points; ++k) EXPECT_NEAR(position[3 * k] - position[3 * (k - 1)], 3, 1.5);
    EXPECT_NEAR(4 * std::numbers::pi / 3 * std::pow(radius[0], 3), 2 * 12001.0 / static_cast<double>(max_field_points), 1e-2);
}

TEST(StressField, TheSameFieldGivesTheSameBytes) {
    const StressPair pair = line(5000, {1e6, 2e5}, {3e3});
    EXPECT_EQ(stress_field_json(pair), stress_field_json(pair));
    EXPECT_LT(stress_field_json(pair).size(), 60 * max_field_points) << "what a page can bear";
}

TEST(StressField, NoPointsAreNoField) { EXPECT_THROW(stress_field_json(line(0, {}, {})), std::invalid_argument); }

}  // namespace
}  // namespace cleave::validation
