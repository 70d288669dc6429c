#include "solver/material/material_report.hpp"

#include <gtest/gtest.h>

namespace cleave::material {
namespace {

TEST(MaterialReport, JsonCarriesTheModuli) {
    const auto json = material_json(find_material("T300/5208"));
    EXPECT_EQ(json["schema"], "cleave.material/1");
    EXPECT_NEAR(json["youngs_modulus_GPa"]["12_45deg"].get<double>(), 16.74, 0.005);
    EXPECT_DOUBLE_EQ(json["youngs_modulus_GPa"]["1"].get<double>(), 181);
    EXPECT_DOUBLE_EQ(json["youngs_modulus_Pa"]["2"].get<double>(), 10.3e9);
    EXPECT_EQ(json["planes_GPa"]["12"]["45deg"], json["youngs_modulus_GPa"]["12_45deg"]);
    EXPECT_DOUBLE_EQ(json["engineering"]["nu12"].get<double>(), 0.28);
    EXPECT_EQ(json["eigenvalues_GPa"].size(), 6u);
    EXPECT_EQ(json["strength_MPa"].get<double>(), 40);
    EXPECT_TRUE(json["toughness_J_per_m2"].is_null());
}

/// Stiffness times compliance is one, as printed.
TEST(MaterialReport, PrintedMatricesAreInverse) {
    for (const std::string& name : catalogue_names()) {
        const auto json = material_json(find_material(name));
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) {
                double sum = 0;
                for (int k = 0; k < 6; ++k)
                    sum += json["stiffness_GPa"][i][k].get<double>() * json["compliance_per_GPa"][k][j].get<double>();
                EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-10) << name << i << j;  // twelve printed digits, entries up to 200 times apart
            }
    }
}

TEST(MaterialReport, TextNamesEverything) {
    const std::string text = material_text(find_material("soda-lime glass"));
    for (const char* part : {"soda-lime glass (isotropic)", "plane 12", "Density               2500 kg/m^3", "EN 572-1"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_NE(material_text(find_material("silicon")).find("Toughness             not given"), std::string::npos);
}

}  // namespace
}  // namespace cleave::material
