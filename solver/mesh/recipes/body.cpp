#include "solver/mesh/recipes/body.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/size_tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace cleave::mesh {
namespace {

constexpr double sliver_angle = 5 * std::numbers::pi / 180;

std::optional<TetMesh> stored(const std::filesystem::path& file) {
    if (file.empty() || !std::filesystem::exists(file)) return std::nullopt;
    try {
        TetMesh mesh = read_msh(file);
        check(mesh, file.string());
        return mesh;
    } catch (const InputError&) {
        return std::nullopt;  // an older or damaged file: made again and replaced
    }
}

BodyRecord record_of(const TetMesh& mesh, const std::string& recipe, int target) {
    BodyRecord record{.recipe = recipe, .target = target, .count = static_cast<int>(mesh.tets.size()), .smallest_dihedral = 4};
    for (int tet = 0; tet < record.count; ++tet) {
        const double angle = smallest_dihedral_angle(mesh, tet);
        record.smallest_dihedral = std::min(record.smallest_dihedral, angle);
        record.slivers += angle < sliver_angle;
    }
    return record;
}

}  // namespace

Body cached_body(const std::string& name, const std::string& recipe, int target, const std::filesystem::path& folder,
                 const std::function<TetMesh()>& make) {
    const std::filesystem::path file = folder.empty() ? folder : folder / fmt::format("{}-{}.msh", name, content_hash(recipe));
    std::optional<TetMesh> mesh = stored(file);
    if (!mesh) {
        mesh = make();
        check(*mesh, name);
        if (!file.empty()) write_msh(*mesh, file);
    }
    Body body{std::move(*mesh), {}};
    body.record = record_of(body.mesh, recipe, target);
    if (misses(body.mesh, target)) {
        throw MeshingError(fmt::format("{}: {} tets, more than 2 % off the {} asked for", name, body.record.count, target));
    }
    return body;
}

}  // namespace cleave::mesh
