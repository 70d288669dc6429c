#include "solver/input/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave {
namespace {

TEST(Quantity, ConvertsToSi) {
    EXPECT_DOUBLE_EQ(parse_quantity("12 mm").value, 0.012);
    EXPECT_DOUBLE_EQ(parse_quantity("181 GPa").value, 181e9);
    EXPECT_DOUBLE_EQ(parse_quantity("-9.81 m/s^2").value, -9.81);
    EXPECT_DOUBLE_EQ(parse_quantity("2.5 g/cm^3").value, 2500);
    EXPECT_DOUBLE_EQ(parse_quantity("30 deg").value, std::numbers::pi / 6);
    EXPECT_NEAR(parse_quantity("1 psi").value, 4.4482216152605 / (0.0254 * 0.0254), 1e-9);  // lbf / in^2
}

TEST(Quantity, KeepsTrackOfTheDimension) {
    EXPECT_EQ(parse_quantity("3 N/m^2").dimension, dimension::pressure);
    EXPECT_EQ(parse_quantity("3 N m").dimension, dimension::energy);
    EXPECT_EQ(parse_quantity("1 MPa m^0.5").dimension, dimension::stress_intensity);
    EXPECT_EQ(parse_quantity("1 MPa*sqrt(m)").dimension, dimension::stress_intensity);
    EXPECT_DOUBLE_EQ(parse_quantity("1 MPa mm^0.5").value, 1e6 * std::sqrt(1e-3));
}

TEST(Quantity, RejectsWhatIsNotAFiniteNumberWithAKnownUnit) {
    for (const char* text : {"", "m", "12 parsec", "nan Pa", "inf m", "1 m^", "1 m/", "1e400 m", "1..2 m", "1 m^inf"})
        EXPECT_THROW(parse_quantity(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace cleave
