#include "validation/studies/contact_plate.hpp"

#include "reference_fem/elasticity.hpp"
#include "validation/geometry/mesh_cache.hpp"
#include "validation/solutions.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::validation {

namespace {

constexpr int body_tag = 1, patch_tag = 1;

void build(const ContactPlate& plate) {
    const double w = plate.half_width;
    const int box = gmsh::model::occ::addBox(-w, -w, 0, 2 * w, 2 * w, plate.thickness);
    const int disk = gmsh::model::occ::addDisk(0, 0, 0, 1, 1);
    gmsh::vectorpair out;
    std::vector<gmsh::vectorpair> pieces;  // of the box, then of the disk
    gmsh::model::occ::fragment({{3, box}}, {{2, disk}}, out, pieces);
    gmsh::model::occ::synchronize();
    gmsh::model::addPhysicalGroup(3, {pieces[0].front().second}, body_tag);
    gmsh::model::addPhysicalGroup(2, {pieces[1].front().second}, patch_tag);
    gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
    gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
    gmsh::option::setNumber("Mesh.MeshSizeMax", plate.half_width);
    gmsh::model::mesh::setSizeCallback([plate](int, int, double x, double y, double z) {
        const double distance = std::hypot(x, y, z);
        return plate.size + plate.near_growth * std::clamp(distance - 1.2, 0.0, 1.8) + plate.growth * std::max(0.0, distance - 3);
    });
}

}  // namespace

std::filesystem::path contact_plate_mesh(const ContactPlate& plate, const std::filesystem::path& folder) {
    const std::string recipe = fmt::format("contact_plate 2 {} {} {} {} {}", plate.half_width, plate.thickness, plate.size, plate.near_growth, plate.growth);
    return geometry::cached_mesh(folder, "contact_plate", recipe, [&] { build(plate); });
}

fem::Solution solve_contact_plate(const std::filesystem::path& mesh, const material::Stiffness& stiffness, SolveNote& note) {
    fem::Problem problem;
    problem.mesh_file = mesh.string();
    fem::Region region;
    region.id = body_tag;
    region.stiffness = plain_stiffness(stiffness);
    region.density = 1;
    problem.regions.push_back(region);
    fem::Traction pressure;
    pressure.surface = patch_tag;
    pressure.value = [](const fem::Point& x) {
        const double rest = 1 - x[0] * x[0] - x[1] * x[1];
        return fem::Point{0, 0, rest > 0 ? 1.5 / std::numbers::pi * std::sqrt(rest) : 0};
    };
    problem.tractions.push_back(pressure);
    problem.free_body = true;
    fem::Options options;
    options.tolerance = 1e-8;
    fem::Solution solution = fem::solve(problem, options);
    const fem::SolveRecord& record = solution.record();
    note = {"fem.p2", record.solver, record.cells, record.dofs, record.iterations, record.relative_residual, record.seconds};
    return solution;
}

}  // namespace cleave::validation
