#include "solver/material/material.hpp"

#include "solver/input/input_error.hpp"
#include "solver/material/test/test_materials.hpp"

#include <gtest/gtest.h>

namespace cleave::material {
namespace {

Material read(const std::string& text) {
    TableReader reader = TableReader::from_text(text, "m.toml");
    Material material = read_material(reader);
    reader.finish();
    return material;
}

std::string message(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string carbon = R"(name = "M"
engineering = { E1 = "181 GPa", E2 = "10.3 GPa", G12 = "7.17 GPa", nu12 = 0.28, nu23 = 0.47 }
)";

TEST(ReadMaterial, FormsAgree) {
    const Stiffness expected = orthotropic(test::carbon_epoxy());
    const auto near = [&](const Stiffness& c, double tolerance) { return (c - expected).cwiseAbs().maxCoeff() < tolerance * 181e9; };
    const Material five = read(carbon);
    EXPECT_EQ(five.name, "M");
    EXPECT_EQ(five.symmetry, "transversely isotropic");
    EXPECT_TRUE(near(five.stiffness, 1e-12));
    const Material nine = read(R"(engineering = { E1 = "181 GPa", E2 = "10.3 GPa", E3 = "10.3 GPa", G23 = "3503.4013605442 MPa", )"
                               R"(G13 = "7.17 GPa", G12 = "7.17 GPa", nu12 = 0.28, nu13 = 0.28, nu23 = 0.47 })");
    EXPECT_EQ(nine.symmetry, "orthotropic");
    EXPECT_TRUE(near(nine.stiffness, 1e-12));
    const Material shear = read(R"(engineering = { E1 = "181 GPa", E2 = "10.3 GPa", G12 = "7.17 GPa", nu12 = 0.28, )"
                                R"(G23 = "3503.4013605442 MPa" })");
    EXPECT_TRUE(near(shear.stiffness, 1e-12));
}

TEST(ReadMaterial, MatrixAndTriangleAgree) {
    const Material full = read(R"(stiffness = { unit = "GPa", voigt = [[10, 4, 4, 0, 0, 1], [4, 10, 4, 0, 0, 0], [4, 4, 10, 0, 0, 0],
 [0, 0, 0, 3, 0, 0], [0, 0, 0, 0, 3, 0], [1, 0, 0, 0, 0, 3]] })");
    const Material half = read(R"(stiffness = { unit = "MPa", voigt = [[10e3, 4e3, 4e3, 0, 0, 1e3], [10e3, 4e3, 0, 0, 0], [10e3, 0, 0, 0],
 [3e3, 0, 0], [3e3, 0], [3e3]] })");
    EXPECT_EQ(full.symmetry, "general");
    EXPECT_LT((full.stiffness - half.stiffness).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_DOUBLE_EQ(full.stiffness(0, 5), 1e9);
}

TEST(ReadMaterial, RotationTurnsTheFibre) {
    const Material turned = read(carbon + R"(rotation = { axis = [0, 0, 2], angle = "90 deg" })");
    EXPECT_NEAR(engineering_constants(turned.stiffness).E2, 181e9, 1);
    EXPECT_NEAR(engineering_constants(turned.stiffness).E1, 10.3e9, 1);
    const Material twice = read(carbon + R"(rotation = [{ axis = [0, 0, 1], angle = "90 deg" }, { axis = [1, 0, 0], angle = "90 deg" }])");
    EXPECT_NEAR(engineering_constants(twice.stiffness).E3, 181e9, 1) << "the second turn carries the fibre from y to z";
    const Material plain = read(carbon);
    EXPECT_EQ(read(carbon + R"(rotation = { axis = [1, 0, 0], angle = "0 deg" })").stiffness, plain.stiffness);
}

TEST(ReadMaterial, ACatalogueNameTakesOverrides) {
    const Material glass = find_material("soda-lime glass");
    const Material tough = read("name = \"soda-lime glass\"\ntoughness = \"9 J/m^2\"\nsource = \"a test\"\n");
    EXPECT_EQ(tough.stiffness, glass.stiffness);
    EXPECT_EQ(tough.density, glass.density);
    EXPECT_DOUBLE_EQ(tough.toughness, 9);
    EXPECT_EQ(tough.sources.back().text, "a test");
}

TEST(ReadMaterial, BadValuesNameTheirKey) {
    EXPECT_EQ(message("density = \"1 kg/m^3\"\n"), "m.toml:1: expected a catalogue name, or one of stiffness, engineering, cubic");
    EXPECT_TRUE(contains(message("name = \"granite\"\n"), "m.toml:1: name: expected a material of the catalogue ("));
    EXPECT_EQ(message(carbon + "cubic = { C11 = \"1 GPa\", C12 = \"0 GPa\", C44 = \"1 GPa\" }\n"),
              "m.toml:3: cubic: expected only one of stiffness, engineering, cubic");
    EXPECT_EQ(message("engineering = { E = \"70 GPa\", nu = 0.5 }\n"),
              "m.toml:1: engineering.nu: expected a Poisson's ratio above -1 and below 0.5 (not 0.5)");
    EXPECT_EQ(message("engineering = { E = \"-70 GPa\", nu = 0.2 }\n"), "m.toml:1: engineering.E: expected a modulus above zero");
    EXPECT_EQ(message("engineering = { E = \"70 GPa\", mu = 0.2 }\n"),
              "m.toml:1: engineering.nu: expected a finite number (the key is missing; 'mu' in line 1 looks like it)");
    EXPECT_EQ(message("engineering = { E = \"70 GPa\", nu = 0.2, G = \"1 GPa\" }\n"),
              "m.toml:1: engineering.G: expected a known key; did you mean 'E'?");
    EXPECT_TRUE(contains(message("cubic = { C11 = \"1 GPa\", C12 = \"2 GPa\", C44 = \"1 GPa\" }\n"),
                         "m.toml:1: cubic: expected a positive definite stiffness (smallest eigenvalue -1 GPa)"));
    EXPECT_TRUE(contains(message("engineering = { E1 = \"181 GPa\", E2 = \"10 GPa\", G12 = \"7 GPa\", nu12 = 4.3, nu23 = 0.4 }\n"),
                         "engineering.nu12: expected a Poisson's ratio within +-4.254"));
    const std::string moduli = "E1 = \"181 GPa\", E2 = \"10 GPa\", G12 = \"7 GPa\"";
    EXPECT_TRUE(contains(message("engineering = { " + moduli + ", nu12 = 0.3, nu23 = 0.4, G23 = \"9 GPa\" }\n"),
                         "engineering.nu23: expected -0.4444 = E2 / (2 G23) - 1"));
    EXPECT_TRUE(contains(message("stiffness = { voigt = [[1, 2], [3, 4]], unit = \"GPa\" }\n"), "stiffness.voigt: expected six rows"));
    EXPECT_TRUE(contains(message("stiffness = { voigt = [[1]], unit = \"kg\" }\n"), "stiffness.unit: expected a unit of pressure"));
    EXPECT_TRUE(contains(message(carbon + "strength = \"0 MPa\"\n"), "m.toml:3: strength: expected a value above zero"));
    EXPECT_TRUE(contains(message(carbon + "rotation = { axis = [0, 0, 0], angle = \"1 deg\" }\n"),
                         "rotation.axis: expected three numbers"));
}

TEST(ReadMaterial, AStiffnessThatIsNoneIsRejected) {
    const auto matrix = [](const std::string& c12, const std::string& c66) {
        return "stiffness = { unit = \"GPa\", voigt = [[10, " + c12 + ", 4, 0, 0, 0], [4, 10, 4, 0, 0, 0], [4, 4, 10, 0, 0, 0], "
               "[0, 0, 0, 3, 0, 0], [0, 0, 0, 0, 3, 0], [0, 0, 0, 0, 0, " + c66 + "]] }\n";
    };
    EXPECT_EQ(message(matrix("4", "3")), "accepted");
    EXPECT_EQ(message(matrix("4.1", "3")), "m.toml:1: stiffness.voigt: expected a symmetric stiffness");
    EXPECT_EQ(message(matrix("4", "-3")), "m.toml:1: stiffness.voigt: expected a positive definite stiffness (smallest eigenvalue -6 GPa)");
}

TEST(ReadMaterial, TheTableOfACaseFile) {
    TableReader reader = TableReader::from_text("[material]\n" + carbon + "strenght = \"1 MPa\"\n", "case.toml");
    TableReader table = reader.table("material");
    read_material(table);
    try {
        reader.finish();
        FAIL() << "the misspelt key must be rejected";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), "case.toml:4: material.strenght: expected a known key; did you mean 'strength'?");
    }
}

}  // namespace
}  // namespace cleave::material
