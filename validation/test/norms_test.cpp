#include "validation/expression.hpp"
#include "validation/norms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace cleave::validation {
namespace {

Samples constant(double factor, std::size_t points) {
    Samples samples;
    for (std::size_t i = 0; i < points; ++i) {
        samples.position.push_back({static_cast<double>(i), 0, 0});
        samples.weight.push_back(1.0 + static_cast<double>(i));
        samples.displacement.push_back({factor * 3, factor * 4, 0});
        samples.stress.push_back({factor, 0, 0, 0, 0, factor});
        samples.strain.push_back({factor, 0, 0, 0, 0, 2 * factor});
    }
    return samples;
}

TEST(Norms, OfAConstantFactorAreThatFactor) {
    const Samples reference = constant(1, 7), method = constant(1.02, 7);
    for (const char* norm : {"rms", "max", "p95"})
        for (const char* quantity : {"displacement", "stress", "strain"})
            EXPECT_NEAR(compare({quantity, ""}, method, reference, norm).error, 0.02, 1e-14) << quantity << " " << norm;
    EXPECT_NEAR(compare({"displacement", ""}, method, reference, "rms").reference, 5, 1e-14);
}

TEST(Norms, AreFrobeniusNormsOfTheTensor) {
    // sigma = [[1, 1, 0], [1, 0, 0], 0]: |sigma|^2 = 3; engineering strain 2 in xy is the same tensor.
    const Samples samples = constant(1, 1);
    EXPECT_NEAR(compare({"stress", ""}, samples, samples, "max").value, std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(compare({"strain", ""}, samples, samples, "max").value, std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(compare({"strain", "xy"}, samples, samples, "max").value, 2, 1e-14);
}

TEST(Norms, RmsIsWeightedByVolumeAndP95IgnoresTheWorstFive) {
    Samples reference = constant(1, 2), method = reference;
    method.weight = {1, 3};
    method.stress[0][0] = 2;  // error 1 on a quarter of the volume, |sigma|^2 = 3
    EXPECT_NEAR(compare({"stress", ""}, method, reference, "rms").error, std::sqrt(0.25 / 3), 1e-14);
    EXPECT_NEAR(compare({"stress", ""}, method, reference, "max").error, std::sqrt(1.0 / 3), 1e-14);
    method.weight = {1, 99};
    EXPECT_NEAR(compare({"stress", ""}, method, reference, "p95").error, 0, 1e-14);
}

TEST(Norms, RefuseWhatWouldLookLikeAgreement) {
    EXPECT_THROW(compare({"stress", ""}, Samples{}, Samples{}, "rms"), std::invalid_argument);
    EXPECT_THROW(compare({"stress", ""}, constant(0, 2), constant(0, 2), "rms"), std::invalid_argument);
    EXPECT_THROW(compare({"stress", "zx"}, constant(1, 2), constant(1, 2), "rms"), std::invalid_argument);
    EXPECT_THROW(compare({"stress", ""}, constant(1, 2), constant(1, 2), "median"), std::invalid_argument);
    Samples broken = constant(1, 2);
    broken.stress[1][0] = std::nan("");
    EXPECT_TRUE(std::isnan(compare({"stress", ""}, broken, constant(1, 2), "max").error));
}

TEST(Order, OfAPowerLawIsItsExponent) {
    EXPECT_NEAR(observed_order({0.4, 0.2, 0.1}, {3 * 0.4 * 0.4, 3 * 0.2 * 0.2, 3 * 0.1 * 0.1}), 2, 1e-12);
    EXPECT_TRUE(std::isnan(observed_order({0.1}, {1})));
    EXPECT_TRUE(std::isnan(observed_order({0.2, 0.1}, {1, 0})));
    EXPECT_TRUE(std::isnan(observed_order({0.2, 0.1}, {1, std::nan("")})));
}

const Coordinates coordinates{{"x", [](const Point& p) { return p[0]; }},
                              {"r", [](const Point& p) { return std::hypot(p[0], p[1]); }},
                              {"a", [](const Point&) { return 2.0; }}};

TEST(Region, ChainsComparisons) {
    const Region ring("1.2 < r/a <= 3 and x > -0.5*a", coordinates);
    EXPECT_TRUE(ring.contains({3, 0, 0}));
    EXPECT_FALSE(ring.contains({2.3, 0, 0}));
    EXPECT_TRUE(ring.contains({6, 0, 0}));
    EXPECT_FALSE(ring.contains({6.01, 0, 0}));
    EXPECT_FALSE(ring.contains({-3, 0, 0}));
    EXPECT_TRUE(Region("", coordinates).contains({0, 0, 0}));
}

TEST(Region, RejectsWhatItCannotRead) {
    for (const char* text : {"r/a", "1 < q", "1 < r/a <", "1 < r and", "r = 1", "1 < 2 x", "< 1", "1 < r or r > 3", "1 < $", "r < 1e999", "r < 1e-999"})
        EXPECT_THROW(Region(text, coordinates), std::invalid_argument) << text;
    EXPECT_TRUE(Region(std::string(900, '-') + "1 > 0", coordinates).contains({0, 0, 0}));
    EXPECT_THROW(Region(std::string(1'000'000, '-') + "1 > 0", coordinates), std::invalid_argument);
    EXPECT_NEAR(parse_term("x/a", coordinates)({3, 0, 0}), 1.5, 1e-15);
    EXPECT_THROW(parse_term("x/a > 1", coordinates), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::validation
