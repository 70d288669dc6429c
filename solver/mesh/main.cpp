#include "solver/input/command_line.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "solver/input/table_reader.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/medit_file.hpp"
#include "solver/mesh/mesh_report.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/recipes/recipes.hpp"
#include "solver/mesh/vtu_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace {

using namespace cleave;
namespace fs = std::filesystem;

constexpr const char* usage = "cleave mesh SCENE|RECIPE|FILE --out FILE.msh|.mesh|.vtu [--count N] [--mesher netgen|gmsh] [--json]";

struct Options {
    std::string source, out, mesher;
    int count = 0;
    bool json = false;
};

/// The body of a scene; where it has several, they must all be made alike.
mesh::BodySource scene_body(const fs::path& file) {
    TableReader scene = TableReader::from_file(file.string());
    std::vector<mesh::BodySource> sources;
    for (TableReader& body : scene.tables("body")) sources.push_back(mesh::read_body_source(body));
    if (sources.empty()) scene.fail("body", "at least one [[body]]");
    const bool alike = std::all_of(sources.begin(), sources.end(), [&](const auto& source) { return source == sources.front(); });
    if (!alike) scene.fail("body", "bodies made alike: one mesh has to stand for all");
    return sources.front();
}

/// A recipe's name, a scene's file or name, or a file with a body.
mesh::BodySource source_of(const std::string& what) {
    const std::vector<std::string> names = mesh::recipe_names();
    if (std::find(names.begin(), names.end(), what) != names.end()) {
        mesh::BodySource source;
        source.recipe = what;
        return source;
    }
    if (what.ends_with(".toml")) return scene_body(what);
    if (const fs::path shipped = fs::path(CLEAVE_SCENE_FOLDER) / (what + ".toml"); is_there(shipped)) return scene_body(shipped);
    if (!is_there(what)) throw InputError(what, "", fmt::format("a file, a scene, or a recipe ({})", fmt::join(names, ", ")));
    mesh::BodySource source;
    source.file = what;
    return source;
}

/// The format by the file's ending, before anything is meshed for minutes.
std::string (*writer_of(const std::string& out))(const mesh::TetMesh&) {
    if (out.ends_with(".msh")) return mesh::format_msh;
    if (out.ends_with(".mesh")) return mesh::format_medit;
    if (out.ends_with(".vtu")) return mesh::format_vtu;
    throw InputError("", "--out", fmt::format("a file that ends in .msh, .mesh or .vtu (not '{}')", out));
}

void run(const Options& options) {
    const auto write = writer_of(options.out);
    mesh::BodySource source = source_of(options.source);
    if (options.count > 0) source.particles = options.count;
    if (!options.mesher.empty()) source.mesher = mesh::mesher_of(options.mesher);
    try {
        const mesh::Body body = mesh::make_body(source);
        write_file_atomic(options.out, write(body.mesh));
        fmt::print("{}", options.json ? mesh::mesh_json(body).dump(2) + "\n" : mesh::mesh_text(body));
    } catch (const mesh::MeshingError& error) {
        throw InputError(options.source, "", fmt::format("a body that can be meshed as asked: {}", error.what()));
    }
}

int body(int argc, char** argv) {
    Options options;
    CLI::App app{"Meshes a body: a scene's, one of the paper's, or a file's"};
    app.add_option("source", options.source, "SCENE.toml or its name; a recipe: pot, window, pet, tai_chi; a file: .stl, .obj, .vtu, .mesh, .msh")->required();
    app.add_option("--out", options.out, "where to write: .msh, .mesh or .vtu")->required();
    app.add_option("--count", options.count, "tets wanted, within 2 %")->check(CLI::Range(1, 100'000'000));
    app.add_option("--mesher", options.mesher, "netgen or gmsh")->check(CLI::IsMember(mesh::mesher_names()));
    app.add_flag("--json", options.json, "print JSON");
    if (!parse_command_line(app, argc, argv, "command line", usage)) return 0;
    run(options);
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return cleave::run_program("cleave-mesh", body, argc, argv); }
