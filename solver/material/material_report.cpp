#include "solver/material/material_report.hpp"

#include "solver/material/elastic_extremes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cleave::material {

namespace {

using Json = nlohmann::ordered_json;

/// Twelve digits: what inversion and rotation leave meaningful, and free of their rounding noise.
double rounded(double value) {
    return value == 0 ? 0.0 : std::stod(fmt::format("{:.12g}", value));
}

struct Plane {
    const char* name;
    int first;
    int second;
};
constexpr Plane planes[] = {{"12", 0, 1}, {"23", 1, 2}, {"13", 0, 2}};

/// Young's modulus (Pa) in a plane of the axes, `angle` in degrees from its first axis.
double modulus_in_plane(const Stiffness& c, const Plane& plane, double angle) {
    // 45 degrees exactly: equal components, not cos and sin of a rounded angle.
    const Eigen::Vector3d first = Eigen::Vector3d::Unit(plane.first), second = Eigen::Vector3d::Unit(plane.second);
    return youngs_modulus(c, angle == 45 ? Eigen::Vector3d(first + second) : angle == 0 ? first : second);
}

Json directions(const Stiffness& c, double unit) {
    Json values;
    for (int axis = 0; axis < 3; ++axis)
        values[std::to_string(axis + 1)] = rounded(youngs_modulus(c, Eigen::Vector3d::Unit(axis)) / unit);
    for (const Plane& plane : planes) values[fmt::format("{}_45deg", plane.name)] = rounded(modulus_in_plane(c, plane, 45) / unit);
    return values;
}

Json plane_values(const Stiffness& c) {
    Json values;
    for (const Plane& plane : planes)
        for (const int angle : {0, 45, 90})
            values[plane.name][fmt::format("{}deg", angle)] = rounded(modulus_in_plane(c, plane, angle) * 1e-9);
    return values;
}

Json matrix_rows(const Stiffness& m) {
    const double noise = 1e-14 * m.cwiseAbs().maxCoeff();
    Json rows = Json::array();
    for (int i = 0; i < 6; ++i) {
        Json row = Json::array();
        for (int j = 0; j < 6; ++j) row.push_back(std::abs(m(i, j)) < noise ? 0.0 : rounded(m(i, j)));
        rows.push_back(row);
    }
    return rows;
}

Json engineering_json(const Stiffness& c) {
    const EngineeringConstants k = engineering_constants(c);
    return {{"E1", rounded(k.E1 * 1e-9)}, {"E2", rounded(k.E2 * 1e-9)}, {"E3", rounded(k.E3 * 1e-9)},
            {"G23", rounded(k.G23 * 1e-9)}, {"G13", rounded(k.G13 * 1e-9)}, {"G12", rounded(k.G12 * 1e-9)},
            {"nu12", rounded(k.nu12)}, {"nu13", rounded(k.nu13)}, {"nu23", rounded(k.nu23)}};
}

Json average_json(const AggregateModuli& moduli) {
    return {{"bulk_GPa", rounded(moduli.bulk * 1e-9)}, {"shear_GPa", rounded(moduli.shear * 1e-9)},
            {"youngs_GPa", rounded(moduli.young() * 1e-9)}, {"poisson", rounded(moduli.poisson())}};
}

Json averages_json(const Stiffness& c) {
    return {{"voigt", average_json(voigt_moduli(c))}, {"reuss", average_json(reuss_moduli(c))}, {"hill", average_json(hill_moduli(c))}};
}

/// Directions to six decimals: an extreme fixes its place only to the root of the rounding.
Json direction_json(const Eigen::Vector3d& direction) {
    Json numbers = Json::array();
    for (const double x : direction) numbers.push_back(std::abs(x) < 5e-7 ? 0.0 : std::round(x * 1e6) * 1e-6);
    return numbers;
}

Json extremes_json(const Extremes& extremes, double unit) {
    const auto one = [&](const Extreme& extreme) {
        Json json{{"value", rounded(extreme.value / unit)}, {"along", direction_json(extreme.first)}};
        if (!extreme.second.isZero()) json["across"] = direction_json(extreme.second);
        return json;
    };
    return {{"min", one(extremes.smallest)}, {"max", one(extremes.largest)}};
}

Json all_extremes_json(const Stiffness& c) {
    return {{"youngs_modulus_GPa", extremes_json(youngs_modulus_extremes(c), 1e9)},
            {"shear_modulus_GPa", extremes_json(shear_modulus_extremes(c), 1e9)},
            {"poisson_ratio", extremes_json(poisson_ratio_extremes(c), 1)}};
}

Json wave_speeds_json(const Material& material) {
    if (!(material.density > 0)) return nullptr;
    Json json;
    for (const auto& [name, direction] : {std::pair{"100", Eigen::Vector3d(1, 0, 0)}, std::pair{"010", Eigen::Vector3d(0, 1, 0)},
                                          std::pair{"001", Eigen::Vector3d(0, 0, 1)}, std::pair{"110", Eigen::Vector3d(1, 1, 0)},
                                          std::pair{"101", Eigen::Vector3d(1, 0, 1)}, std::pair{"011", Eigen::Vector3d(0, 1, 1)},
                                          std::pair{"111", Eigen::Vector3d(1, 1, 1)}}) {
        const Eigen::Vector3d speeds = wave_speeds(material.stiffness, material.density, direction);
        json[name] = {rounded(speeds[0]), rounded(speeds[1]), rounded(speeds[2])};
    }
    return json;
}

Json given(double value) { return value > 0 ? Json(rounded(value)) : Json(nullptr); }

std::string matrix_text(const char* title, const Stiffness& m) {
    std::string text = fmt::format("{}\n", title);
    const double noise = 1e-12 * m.cwiseAbs().maxCoeff();
    for (int i = 0; i < 6; ++i) {
        text += " ";
        for (int j = 0; j < 6; ++j) text += fmt::format(" {:>11.5g}", std::abs(m(i, j)) < noise ? 0.0 : m(i, j));
        text += "\n";
    }
    return text;
}

std::string optional_line(const char* label, double value, const char* unit) {
    return value > 0 ? fmt::format("{:<22}{:.6g} {}\n", label, value, unit) : fmt::format("{:<22}not given\n", label);
}

std::string planes_text(const Stiffness& c) {
    std::string text = fmt::format("\nYoung's modulus (GPa)       0 deg      45 deg      90 deg\n");
    for (const Plane& plane : planes)
        text += fmt::format("  plane {:<14}{:>11.5g} {:>11.5g} {:>11.5g}\n", plane.name, modulus_in_plane(c, plane, 0) * 1e-9,
                            modulus_in_plane(c, plane, 45) * 1e-9, modulus_in_plane(c, plane, 90) * 1e-9);
    return text;
}

}  // namespace

nlohmann::ordered_json material_json(const Material& material) {
    const Stiffness& c = material.stiffness;
    const Voigt kelvin = kelvin_moduli(c);
    Json json;
    json["schema"] = "cleave.material/1";
    json["name"] = material.name;
    json["about"] = material.about;
    json["symmetry"] = material.symmetry;
    json["youngs_modulus_GPa"] = directions(c, 1e9);
    json["youngs_modulus_Pa"] = directions(c, 1);
    json["planes_GPa"] = plane_values(c);
    json["engineering"] = engineering_json(c);
    json["stiffness_GPa"] = matrix_rows(c * 1e-9);
    json["compliance_per_GPa"] = matrix_rows(compliance(c) * 1e9);
    for (int i = 0; i < 6; ++i) json["eigenvalues_GPa"].push_back(rounded(kelvin(i) * 1e-9));
    json["hill_youngs_modulus_GPa"] = rounded(hill_youngs_modulus(c) * 1e-9);
    // An isotropic solid leaves rounding of either sign.
    json["universal_anisotropy"] = std::abs(universal_anisotropy(c)) < 1e-12 ? 0.0 : rounded(universal_anisotropy(c));
    json["averages"] = averages_json(c);
    json["extremes"] = all_extremes_json(c);
    json["wave_speeds_m_per_s"] = wave_speeds_json(material);
    json["density_kg_per_m3"] = given(material.density);
    json["strength_MPa"] = given(material.strength * 1e-6);
    json["toughness_J_per_m2"] = given(material.toughness);
    json["sources"] = Json::array();
    for (const Source& source : material.sources) json["sources"].push_back({{"property", source.property}, {"text", source.text}});
    return json;
}

std::string material_text(const Material& material) {
    const Stiffness& c = material.stiffness;
    const EngineeringConstants k = engineering_constants(c);
    const Voigt kelvin = kelvin_moduli(c) * 1e-9;
    std::string text = fmt::format("{} ({})\n", material.name.empty() ? "(unnamed)" : material.name, material.symmetry);
    if (!material.about.empty()) text += material.about + "\n";
    text += planes_text(c);
    text += fmt::format("\nE1, E2, E3 (GPa)      {:.5g}, {:.5g}, {:.5g}\n", k.E1 * 1e-9, k.E2 * 1e-9, k.E3 * 1e-9);
    text += fmt::format("G23, G13, G12 (GPa)   {:.5g}, {:.5g}, {:.5g}\n", k.G23 * 1e-9, k.G13 * 1e-9, k.G12 * 1e-9);
    text += fmt::format("nu12, nu13, nu23      {:.4g}, {:.4g}, {:.4g}\n", k.nu12, k.nu13, k.nu23);
    text += matrix_text("\nStiffness (GPa), order xx yy zz yz xz xy, engineering shear", c * 1e-9);
    text += fmt::format("eigenvalues (GPa)     {:.5g}, {:.5g}, {:.5g}, {:.5g}, {:.5g}, {:.5g}\n", kelvin(0), kelvin(1), kelvin(2),
                        kelvin(3), kelvin(4), kelvin(5));
    text += matrix_text("\nCompliance (1/GPa)", compliance(c) * 1e9) += "\n";
    text += optional_line("Density", material.density, "kg/m^3");
    text += optional_line("Strength", material.strength * 1e-6, "MPa");
    text += optional_line("Toughness", material.toughness, "J/m^2");
    for (const Source& source : material.sources)
        text += fmt::format("\n{}: {}", source.property.empty() ? "source" : source.property, source.text);
    return material.sources.empty() ? text : text + "\n";
}

}  // namespace cleave::material
