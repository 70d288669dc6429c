#include "reference_fem/elasticity.hpp"
#include "solver/input/input_error.hpp"
#include "validation/adapters/sources.hpp"
#include "validation/solutions.hpp"

namespace cleave::validation {

namespace {

fem::VectorField field_of(const SurfaceLoad& load, const Case& of) {
    if (!load.solution) return [value = load.vector](const fem::Point&) { return value; };
    return make_field(*load.solution, of).displacement;
}

/// Tractions of an analytic solution need the outward normal; every surface of the shipped shapes that carries one is planar, so
/// the field is built per surface by the caller. Not offered yet.
[[noreturn]] void no_traction_field(const SurfaceLoad& load, const Case& of) {
    of.fail(load.solution->where, "'vector' for a traction (solutions are for displacements)");
}

fem::Problem make_problem(const Case& of, const geometry::Body& body) {
    fem::Problem problem;
    problem.mesh_file = body.mesh_file.string();
    for (const auto& [name, tag] : body.regions) problem.regions.push_back({tag, plain_stiffness(material_of(of, name).stiffness)});
    for (const SurfaceLoad& load : of.loads)
        for (const int tag : surface_tags(load, body, of)) switch (load.kind) {
                case SurfaceLoad::Kind::pressure: problem.pressures.push_back({tag, load.pressure}); break;
                case SurfaceLoad::Kind::displacement: problem.displacements.push_back({tag, load.components, field_of(load, of)}); break;
                case SurfaceLoad::Kind::traction:
                    if (load.solution) no_traction_field(load, of);
                    problem.tractions.push_back({tag, field_of(load, of)});
            }
    if (of.body_force_solution) {
        problem.body_force = make_field(*of.body_force_solution, of).body_force;
        if (!problem.body_force) of.fail(of.body_force_solution->where, "a solution with a body force");
    } else if (of.body_force != std::array<double, 3>{}) {
        problem.body_force = [value = of.body_force](const fem::Point&) { return value; };
    }
    return problem;
}

Samples gather(const std::vector<fem::FieldSample>& list) {
    Samples samples;
    for (const fem::FieldSample& one : list) {
        samples.position.push_back(one.position);
        samples.weight.push_back(one.weight > 0 ? one.weight : 1);
        samples.displacement.push_back(one.displacement);
        samples.strain.push_back(one.strain);
        samples.stress.push_back(one.stress);
    }
    return samples;
}

class FemSource final : public FieldSource {
public:
    FemSource(fem::Solution solution, double size) : solution_(std::move(solution)), size_(size), samples_(gather(solution_.quadrature_samples(3))) {}

    const Samples& everywhere() const override { return samples_; }
    Samples at(const std::vector<Point>& points) const override { return gather(solution_.recovered_at(points)); }
    Samples inside(const std::vector<Point>& points) const override { return gather(solution_.at(points)); }
    double scalar(const std::string& quantity) const override {
        if (quantity == "energy") return solution_.energy();
        if (quantity == "external_work") return solution_.external_work();
        if (quantity == "residual") return solution_.record().relative_residual;
        throw InputError("", quantity, "a quantity that finite elements have");
    }
    Resolution resolution() const override { return {size_, solution_.record().cells, solution_.record().dofs}; }

private:
    fem::Solution solution_;
    double size_;
    Samples samples_;
};

}  // namespace

std::unique_ptr<FieldSource> run_fem(const Case& of, const geometry::Body& body, double size, const std::string& solver, SolveNote& note) {
    fem::Options options;
    options.degree = solver == "fem.p1" ? 1 : 2;
    try {
        fem::Solution solution = fem::solve(make_problem(of, body), options);
        const fem::SolveRecord& record = solution.record();
        note = {solver, record.solver, record.cells, record.dofs, record.iterations, record.relative_residual, record.seconds};
        return std::make_unique<FemSource>(std::move(solution), size);
    } catch (const fem::Error& error) {
        throw InputError(of.file, solver, std::string("a problem that can be solved: ") + error.what());
    }
}

}  // namespace cleave::validation
