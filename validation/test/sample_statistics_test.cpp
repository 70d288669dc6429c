#include "validation/studies/sample_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::validation {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(SampleStatistics, StudentsIntervalOfTwenty) {
    std::vector<double> values;
    for (int i = 0; i < 20; ++i) values.push_back(i);
    const Estimate found = estimate(values);
    EXPECT_DOUBLE_EQ(found.mean, 9.5);
    // t = 2.0930 for 19 degrees of freedom (any table), standard deviation sqrt(35).
    EXPECT_NEAR(found.interval, 2.0930 * std::sqrt(35.0 / 20), 1e-3);
    EXPECT_TRUE(std::isinf(estimate({1}).interval));
    EXPECT_EQ(estimate({2, 2, 2}).interval, 0);
}

TEST(SampleStatistics, AxesAreTakenModuloHalfATurn) {
    std::vector<Eigen::Vector2d> axes;
    for (const double angle : {170.0, 190.0, -8.0, 8.0}) axes.push_back(doubled(3 * std::cos(angle * degree), 3 * std::sin(angle * degree)));
    const AxialEstimate found = axial_estimate(axes);
    EXPECT_NEAR(found.mean, 0, 1e-12);
    EXPECT_NEAR(found.spread, std::sqrt(82.0) * degree, 0.02 * std::sqrt(82.0) * degree);  // small angles: their root mean square; the cosine gives 2 %
    EXPECT_NEAR(found.interval, 1.96 * std::sqrt(328.0 / 3 / 4) * degree, 0.05 * 1.96 * std::sqrt(328.0 / 3 / 4) * degree);
}

TEST(SampleStatistics, EvenlySpreadAxesHaveNoMean) {
    std::vector<Eigen::Vector2d> axes;
    for (int k = 0; k < 8; ++k) axes.push_back(doubled(std::cos(k * 22.5 * degree), std::sin(k * 22.5 * degree)));
    const AxialEstimate found = axial_estimate(axes);
    EXPECT_GT(found.spread, 90 * degree);    // unbounded, but for rounding
    EXPECT_GT(found.interval, 90 * degree);
}

}  // namespace
}  // namespace cleave::validation
