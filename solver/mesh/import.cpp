#include "solver/mesh/import.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/medit_file.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/obj_file.hpp"
#include "solver/mesh/stl_file.hpp"
#include "solver/mesh/surface_check.hpp"
#include "solver/mesh/surface_marks.hpp"
#include "solver/mesh/vtu_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace cleave::mesh {
namespace {

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

Imported parsed(const std::filesystem::path& file) {
    const std::string ending = ending_of(file), name = file.string();
    const auto& known = import_endings();
    if (std::find(known.begin(), known.end(), ending) == known.end()) {
        throw InputError(name, "", fmt::format("a file that ends in one of {}", fmt::join(known, ", ")));
    }
    const std::string bytes = read_file(file);
    if (ending == ".stl") return parse_stl(bytes, name);
    if (ending == ".obj") return parse_obj(bytes, name);
    if (ending == ".mesh") return parse_medit(bytes, name);
    if (ending == ".vtu") return parse_vtu(bytes, name);
    return parse_msh(bytes, name);
}

/// Some programs order a tet's corners the other way, in all tets; that is a convention, not a fault.
void turn_over_if_all_inverted(TetMesh& mesh, const std::string& file) {
    const auto in_range = [&](const std::array<int, 4>& tet) {
        return std::all_of(tet.begin(), tet.end(), [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(); });
    };
    if (!std::all_of(mesh.tets.begin(), mesh.tets.end(), in_range)) check(mesh, file);  // says which
    bool inverted = !mesh.tets.empty();
    for (std::size_t tet = 0; inverted && tet < mesh.tets.size(); ++tet) inverted = tet_volume(mesh, static_cast<int>(tet)) < 0;
    if (!inverted) return;
    for (auto& tet : mesh.tets) std::swap(tet[0], tet[1]);
}

}  // namespace

const std::vector<std::string>& import_endings() {
    static const std::vector<std::string> endings{".msh", ".mesh", ".vtu", ".stl", ".obj"};
    return endings;
}

Imported import_mesh(const std::filesystem::path& file) {
    Imported imported = parsed(file);
    if (auto* mesh = std::get_if<TetMesh>(&imported)) {
        // A .msh goes to both solvers as it is, so nothing may be turned there.
        if (ending_of(file) != ".msh") turn_over_if_all_inverted(*mesh, file.string());
        check(*mesh, file.string());
    } else {
        auto& surface = std::get<SurfaceMesh>(imported);
        check_surface(surface, file.string());
        split_at_sharp_edges(surface);
    }
    return imported;
}

}  // namespace cleave::mesh
