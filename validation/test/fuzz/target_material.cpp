#include "solver/material/catalogue_data.hpp"
#include "solver/material/material_report.hpp"
#include "validation/test/fuzz/target.hpp"

namespace cleave::fuzz {

namespace {

constexpr const char* turned = R"([material]
stiffness = { voigt = [[166, 64, 64, 0, 0, 0], [166, 64, 0, 0, 0], [166, 0, 0, 0], [80, 0, 0], [80, 0], [80]], unit = "GPa" }
rotation = [{ axis = [0, 0, 1], angle = "30 deg" }, { axis = [1, 1, 0], angle = "0.5 rad" }]
density = "2.33 g/cm^3"
strength = "1 GPa"
toughness = "4 J/m^2"
sources = { stiffness = "a table" }
)";

}  // namespace

Target material_target() {
    Target target{"material", {turned, "name = \"x\"\nengineering = { E = \"70 GPa\", nu = 0.2 }\n"}, [](const std::string& bytes) {
                      const material::Material found = material::read_material_file(input_file("input.toml", bytes).string());
                      (void)material::material_text(found);  // not the JSON: its search for extremes takes seconds under the sanitizers
                  }};
    for (const material::CatalogueFile& file : material::catalogue_files()) target.seeds.push_back(file.text);
    return target;
}

}  // namespace cleave::fuzz
