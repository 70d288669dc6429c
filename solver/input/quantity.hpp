#pragma once

#include <array>
#include <string>
#include <string_view>

namespace cleave {

/// Exponents of (kg, m, s) of a physical quantity (halves occur: a stress intensity is Pa m^0.5). Angles and pure
/// numbers have all three zero.
struct Dimension {
    double mass = 0;
    double length = 0;
    double time = 0;
    friend bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension area{0, 2, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension frequency{0, 0, -1};
inline constexpr Dimension mass{1, 0, 0};
inline constexpr Dimension velocity{0, 1, -1};
inline constexpr Dimension acceleration{0, 1, -2};
inline constexpr Dimension density{1, -3, 0};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension pressure{1, -1, -2};           ///< stress, stiffness
inline constexpr Dimension compliance{-1, 1, 2};          ///< 1/Pa
inline constexpr Dimension energy{1, 2, -2};
inline constexpr Dimension energy_per_area{1, 0, -2};     ///< energy release rate, toughness G_c
inline constexpr Dimension force_per_length{1, 0, -2};
inline constexpr Dimension stress_intensity{1, -0.5, -2};  ///< Pa m^0.5
inline constexpr Dimension force_density{1, -2, -2};      ///< body force, N/m^3
}  // namespace dimension

/// A number with its unit, converted to SI (angles to radians).
struct Quantity {
    double value = 0;      ///< SI
    Dimension dimension;
    bool angle = false;    ///< the unit was deg or rad
};

/// Parses "12 m", "181 GPa", "-9.81 m/s^2", "J/m^2" products, "30 deg", "0.28" (pure number).
/// Units: m mm cm um nm km, kg g mg t, s ms us Hz, N kN MN mN, Pa kPa MPa GPa TPa psi, J kJ mJ, deg rad, % ;
/// powers by ^ ("m^0.5"), products by * or a blank, quotients by / (each / divides by the next factor only).
/// Throws std::invalid_argument (what() names the unknown unit or the malformed number); NaN and infinity are malformed.
Quantity parse_quantity(std::string_view text);

/// "m", "Pa", "N/m^3", ...: the SI spelling used in messages and results.
std::string unit_name(Dimension dimension);

}  // namespace cleave
