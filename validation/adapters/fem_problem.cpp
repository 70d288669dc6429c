#include "validation/adapters/fem_problem.hpp"

#include "validation/adapters/sources.hpp"
#include "validation/solutions.hpp"

namespace cleave::validation {

namespace {

fem::VectorField field_of(const SurfaceLoad& load, const Case& of) {
    if (!load.solution) return [value = load.vector](const fem::Point&) { return value; };
    return make_field(*load.solution, of).displacement;
}

/// A constant traction, or sigma n of an analytic solution.
fem::Traction traction_of(const SurfaceLoad& load, int tag, const Case& of) {
    if (!load.solution) return {tag, [value = load.vector](const fem::Point&) { return value; }, {}};
    const analytic::Field field = make_field(*load.solution, of);
    if (!field.stress) of.fail(load.solution->where, "a solution that gives a stress");
    return {tag, {}, field.stress};
}

void add_surface_load(fem::Problem& problem, const SurfaceLoad& load, int tag, const Case& of) {
    switch (load.kind) {
        case SurfaceLoad::Kind::pressure: problem.pressures.push_back({tag, load.pressure}); break;
        case SurfaceLoad::Kind::displacement: problem.displacements.push_back({tag, load.components, field_of(load, of)}); break;
        case SurfaceLoad::Kind::traction: problem.tractions.push_back(traction_of(load, tag, of));
    }
}

void add_line(fem::Problem& problem, const LineCondition& line, const geometry::Body& body) {
    const fem::Line on{body.surfaces.at(line.on[0]), body.surfaces.at(line.on[1])};
    const auto value = [vector = line.vector](const fem::Point&) { return vector; };
    if (line.load)
        problem.line_loads.push_back({on, value});
    else
        problem.line_displacements.push_back({on, line.components, value});
}

}  // namespace

fem::Problem fem_problem(const Case& of, const geometry::Body& body) {
    fem::Problem problem;
    problem.mesh_file = body.mesh_file.string();
    for (const auto& [name, tag] : body.regions) {
        const material::Material& material = material_of(of, name);
        problem.regions.push_back({.id = tag, .stiffness = plain_stiffness(material.stiffness), .density = material.density});
    }
    for (const SurfaceLoad& load : of.loads)
        for (const int tag : surface_tags(load, body, of)) add_surface_load(problem, load, tag, of);
    for (const LineCondition& line : of.lines) add_line(problem, line, body);
    for (const PointSupport& support : of.supports) problem.supports.push_back({support.at, support.components, support.vector});
    problem.free_body = of.free_body;
    if (of.body_force_solution) {
        problem.body_force = make_field(*of.body_force_solution, of).body_force;
        if (!problem.body_force) of.fail(of.body_force_solution->where, "a solution with a body force");
    } else if (of.body_force != std::array<double, 3>{}) {
        problem.body_force = [value = of.body_force](const fem::Point&) { return value; };
    }
    return problem;
}

}  // namespace cleave::validation
