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
#include <functional>
#include <stdexcept>

namespace cleave::mesh {
namespace {

/// Tets inside the surface at any size, checked and marked.
std::function<TetMesh(double)> maker(const SurfaceMesh& surface, Mesher mesher) {
    return [&surface, mesher](double size) {
        TetMesh mesh = mesher == Mesher::gmsh ? mesh_by_gmsh(surface, size) : mesh_by_netgen(surface, size);
        try {
            check(mesh, name_of(mesher));
        } catch (const InputError& error) {
            throw MeshingError(fmt::format("a broken mesh came out: {}", error.what()));
        }
        mark_surface(mesh, surface);
        return mesh;
    };
}

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
    return maker(surface, mesher)(size);
}

TunedMesh mesh_surface_to_count(const SurfaceMesh& surface, int target, Mesher mesher) {
    // Edge of regular tets that fill the volume: a^3 / (6 sqrt 2) each.
    const double first_size = std::cbrt(6 * std::sqrt(2.0) * enclosed_volume(surface) / target);
    return tune_count(maker(surface, mesher), first_size, target);
}

}  // namespace cleave::mesh
