// The finite element reference reads meshes with code of its own: a file that both accept must be the same body for both.

#include "reference_fem/mesh.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/test/fuzz/mesh_seeds.hpp"
#include "validation/test/fuzz/target.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace cleave::fuzz {

namespace {

fem::Mesh read_by_fem(const std::string& file) try {
    fem::Mesh mesh = fem::read_msh(file);
    fem::check_cells(mesh);
    (void)fem::FaceTable(mesh);
    (void)fem::connected_parts(mesh);
    return mesh;
} catch (const fem::Error& error) {
    throw InputError("", "", error.what());
}

mesh::TetMesh read_by_solver(const std::string& file) {
    mesh::TetMesh mesh = mesh::read_msh(file);
    mesh::check(mesh, file);
    return mesh;
}

/// Both accept it: tet by tet the same corners and region.
void require_same(const fem::Mesh& fem, const mesh::TetMesh& solver) {
    if (fem.cells.size() != solver.tets.size()) throw std::logic_error(fmt::format("{} tets for the FEM, {} for the solver", fem.cells.size(), solver.tets.size()));
    for (std::size_t tet = 0; tet < solver.tets.size(); ++tet) {
        if (fem.cell_regions[tet] != solver.regions[tet])
            throw std::logic_error(fmt::format("tet {}: region {} for the FEM, {} for the solver", tet + 1, fem.cell_regions[tet], solver.regions[tet]));
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                if (fem.vertices[static_cast<std::size_t>(fem.cells[tet][corner])][static_cast<std::size_t>(axis)] !=
                    solver.vertices[static_cast<std::size_t>(solver.tets[tet][corner])][axis])
                    throw std::logic_error(fmt::format("tet {}: corners that differ", tet + 1));
    }
}

void read_by_both(const std::string& bytes) {
    const std::string file = input_file("input.msh", bytes).string();
    const fem::Mesh by_fem = read_by_fem(file);
    require_same(by_fem, read_by_solver(file));
}

}  // namespace

Target fem_msh_target() { return {"fem_msh", msh_seeds(), read_by_both}; }

}  // namespace cleave::fuzz
