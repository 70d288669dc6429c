#include "solver/material/stiffness_reader.hpp"

#include "solver/material/stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace cleave::material {

namespace {

/// Runs a maker of stiffness.hpp; what it rejects becomes an InputError at `key`.
template <class Maker>
Stiffness made(const TableReader& reader, const std::string& key, const Maker& maker) {
    try {
        return maker();
    } catch (const std::invalid_argument& error) {
        reader.fail(key, error.what());
    }
}

double modulus(TableReader& table, const std::string& key) {
    const double value = table.quantity(key, dimension::pressure);
    if (!(value > 0)) table.fail(key, "a modulus above zero");
    return value;
}

/// A ratio of an isotropic body, or inside an isotropic plane: -1 < nu < `upper`.
double ratio_below(TableReader& table, const std::string& key, double upper) {
    const double value = table.number(key);
    if (!(value > -1) || !(value < upper))
        table.fail(key, fmt::format("a Poisson's ratio above -1 and below {:g} (not {:g})", upper, value));
    return value;
}

/// nu_ij with |nu_ij| < sqrt(E_i / E_j), the bound of a positive definite compliance (Lempriere 1968).
double coupled_ratio(TableReader& table, const std::string& key, double Ei, double Ej) {
    const double value = table.number(key);
    const double bound = std::sqrt(Ei / Ej);
    if (!(std::abs(value) < bound)) table.fail(key, fmt::format("a Poisson's ratio within +-{:.4g} (not {:g})", bound, value));
    return value;
}

/// The isotropic 2-3 plane has one constant beside E2: nu23 or G23. Given both, they must agree to 1 % (tables are rounded).
double transverse_ratio(TableReader& table, double E2) {
    if (!table.has("G23")) return ratio_below(table, "nu23", 1);
    const double implied = E2 / (2 * modulus(table, "G23")) - 1;
    if (table.has("nu23") && std::abs(ratio_below(table, "nu23", 1) - implied) > 0.01 * (1 + implied))
        table.fail("nu23", fmt::format("{:.4g} = E2 / (2 G23) - 1 (transverse isotropy), or E3, G13 and nu13 as well", implied));
    return implied;
}

GivenStiffness read_isotropic(TableReader& table) {
    const double young = modulus(table, "E");
    const double poisson = ratio_below(table, "nu", 0.5);
    return {made(table, "", [&] { return isotropic(young, poisson); }), "isotropic"};
}

GivenStiffness read_transversely_isotropic(TableReader& table) {
    const double E1 = modulus(table, "E1"), E2 = modulus(table, "E2"), G12 = modulus(table, "G12");
    const double nu12 = coupled_ratio(table, "nu12", E1, E2);
    const double nu23 = transverse_ratio(table, E2);
    return {made(table, "", [&] { return transversely_isotropic(E1, E2, G12, nu12, nu23); }), "transversely isotropic"};
}

GivenStiffness read_orthotropic(TableReader& table) {
    EngineeringConstants k;
    k.E1 = modulus(table, "E1"), k.E2 = modulus(table, "E2"), k.E3 = modulus(table, "E3");
    k.G23 = modulus(table, "G23"), k.G13 = modulus(table, "G13"), k.G12 = modulus(table, "G12");
    k.nu12 = coupled_ratio(table, "nu12", k.E1, k.E2);
    k.nu13 = coupled_ratio(table, "nu13", k.E1, k.E3);
    k.nu23 = coupled_ratio(table, "nu23", k.E2, k.E3);
    return {made(table, "", [&] { return orthotropic(k); }), "orthotropic"};
}

GivenStiffness read_engineering(TableReader& reader) {
    TableReader table = reader.table("engineering");
    if (table.has("E")) return read_isotropic(table);
    const bool full = table.has("E3") || table.has("G13") || table.has("nu13");
    return full ? read_orthotropic(table) : read_transversely_isotropic(table);
}

GivenStiffness read_cubic(TableReader& reader) {
    TableReader table = reader.table("cubic");
    const double C11 = modulus(table, "C11");
    const double C12 = table.quantity("C12", dimension::pressure);
    const double C44 = modulus(table, "C44");
    return {made(reader, "cubic", [&] { return cubic(C11, C12, C44); }), "cubic"};
}

/// "GPa" -> 1e9.
double pressure_unit(TableReader& table) {
    const std::string unit = table.string("unit");
    try {
        const Quantity one = parse_quantity("1 " + unit);
        if (one.dimension == dimension::pressure) return one.value;
    } catch (const std::invalid_argument&) {
    }
    table.fail("unit", fmt::format("a unit of pressure, as \"GPa\" (not '{}')", unit));
}

Stiffness from_full_rows(const TableReader& table, const std::vector<std::vector<double>>& rows, double unit) {
    Stiffness c;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) c(i, j) = rows[i][j] * unit;
    return made(table, "voigt", [&] { return checked_stiffness(c); });
}

Stiffness from_triangle_rows(const TableReader& table, const std::vector<std::vector<double>>& rows, double unit) {
    std::array<double, 21> constants{};
    std::size_t at = 0;
    for (const auto& row : rows)
        for (const double value : row) constants[at++] = value * unit;
    return made(table, "voigt", [&] { return from_upper_triangle(constants); });
}

GivenStiffness read_voigt(TableReader& reader) {
    TableReader table = reader.table("stiffness");
    const auto rows = table.matrix("voigt");
    const double unit = pressure_unit(table);
    bool full = rows.size() == 6, triangle = rows.size() == 6;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        full = full && rows[i].size() == 6;
        triangle = triangle && rows[i].size() == 6 - i;
    }
    if (full) return {from_full_rows(table, rows, unit), "general"};
    if (triangle) return {from_triangle_rows(table, rows, unit), "general"};
    table.fail("voigt", "six rows of six numbers, or the upper triangle as rows of 6, 5, 4, 3, 2, 1 numbers");
}

}  // namespace

std::optional<GivenStiffness> read_stiffness(TableReader& reader) {
    const std::array<std::string, 3> forms{"stiffness", "engineering", "cubic"};
    const auto count = std::count_if(forms.begin(), forms.end(), [&](const std::string& form) { return reader.has(form); });
    if (count == 0) return std::nullopt;
    if (count > 1) {
        const auto last = std::find_if(forms.rbegin(), forms.rend(), [&](const std::string& form) { return reader.has(form); });
        reader.fail(*last, "only one of stiffness, engineering, cubic");
    }
    if (reader.has("stiffness")) return read_voigt(reader);
    return reader.has("cubic") ? read_cubic(reader) : read_engineering(reader);
}

}  // namespace cleave::material
