#include "solver/mesh/mesher.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/gmsh_surface.hpp"
#include "solver/mesh/netgen.hpp"
#include "solver/mesh/surface_marks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace cleave::mesh {
namespace {

/// What a mesher made, checked, with the surface's patches.
TetMesh finished(TetMesh mesh, const SurfaceMesh& surface, Mesher mesher) {
    try {
        check(mesh, name_of(mesher));
    } catch (const InputError& error) {
        throw MeshingError(fmt::format("a broken mesh came out: {}", error.what()));
    }
    mark_surface(mesh, surface);
    return mesh;
}

TetMesh made(const SurfaceMesh& surface, double size, double inner_size, Mesher mesher) {
    TetMesh mesh = mesher == Mesher::gmsh ? mesh_by_gmsh(surface, inner_size) : mesh_by_netgen(surface, size, inner_size);
    return finished(std::move(mesh), surface, mesher);
}

double miss(const TunedMesh& tuned, int target) { return std::abs(std::log(static_cast<double>(tuned.mesh.tets.size()) / target)); }

}  // namespace

const std::vector<std::string>& mesher_names() {
    static const std::vector<std::string> names{"netgen", "gmsh"};
    return names;
}

std::string name_of(Mesher mesher) { return mesher_names()[static_cast<std::size_t>(mesher)]; }

Mesher mesher_of(const std::string& name) {
    for (const Mesher mesher : {Mesher::netgen, Mesher::gmsh}) {
        if (name_of(mesher) == name) return mesher;
    }
    throw std::invalid_argument(fmt::format("one of {} (not '{}')", fmt::join(mesher_names(), ", "), name));
}

std::string version_of(Mesher mesher) {
    return fmt::format("{} {}", name_of(mesher), mesher == Mesher::netgen ? netgen_version() : GmshSession::version());
}

TetMesh mesh_surface(const SurfaceMesh& surface, double size, Mesher mesher) {
    if (!(size > 0)) throw std::invalid_argument("mesh_surface: the size must be positive");
    return made(surface, size, size, mesher);
}

TunedMesh mesh_surface_to_count(const SurfaceMesh& surface, int target, Mesher mesher) {
    // Edge of regular tets that fill the volume: a^3 / (6 sqrt 2) each.
    const double first_size = std::cbrt(6 * std::sqrt(2.0) * enclosed_volume(surface) / target);
    TunedMesh tuned = tune_count([&](double size) { return made(surface, size, size, mesher); }, first_size, target);
    if (mesher != Mesher::netgen || !misses(tuned.mesh, target) || tuned.size_of_too_few == 0) return tuned;
    // NETGEN divides sharp edges into whole parts, and where all of them get one more at the same size, the count leaps (by 2 for a box). From the
    // coarser surface, smaller tets inside fill the gap.
    const double surface_size = tuned.size_of_too_few;
    TunedMesh filled = tune_count([&](double inner) { return made(surface, surface_size, inner, mesher); }, surface_size, target);
    return miss(filled, target) < miss(tuned, target) ? filled : tuned;
}

}  // namespace cleave::mesh
