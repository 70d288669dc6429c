#include "solver/input/command_line.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "solver/material/material_report.hpp"

#include <fmt/format.h>

namespace {

using namespace cleave;

struct Options {
    std::string material;
    bool json = false;
    bool list = false;
};

/// A file where it ends in .toml or exists and is no catalogue name ("T300/5208" looks like a path).
material::Material find(const std::string& what) {
    if (what.ends_with(".toml")) return material::read_material_file(what);
    if (material::in_catalogue(what) || !is_file(what)) return material::find_material(what);
    return material::read_material_file(what);
}

std::string answer(const Options& options) {
    if (!options.list) {
        const material::Material found = find(options.material);
        return options.json ? material::material_json(found).dump(2) + "\n" : material::material_text(found);
    }
    const std::vector<std::string> names = material::catalogue_names();
    return options.json ? nlohmann::ordered_json(names).dump(2) + "\n" : fmt::format("{}\n", fmt::join(names, "\n"));
}

int body(int argc, char** argv) {
    Options options;
    CLI::App app{"Elastic constants of a material: of the catalogue, or of a file"};
    auto* name = app.add_option("material", options.material, "a name of the catalogue, or FILE.toml");
    app.add_flag("--json", options.json, "print JSON");
    app.add_flag("--list", options.list, "names of the catalogue")->excludes(name);
    if (!parse_command_line(app, argc, argv, "command line", "cleave material NAME|FILE.toml [--json] [--list]")) return 0;
    if (!options.list && options.material.empty())
        throw InputError("", "command line", "cleave material NAME|FILE.toml [--json] [--list]");
    fmt::print("{}", answer(options));
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return cleave::run_program("cleave-material", body, argc, argv); }
