#include "validation/adapters/level.hpp"

#include "validation/solutions.hpp"

#include <utility>

namespace cleave::validation {

LevelSources::LevelSources(const Case& of, double size, const std::filesystem::path& mesh_folder)
    : of_(of), size_(size), body_(of.shape->mesh(size, mesh_folder)) {}

std::vector<Point> LevelSources::displacement_at(const std::vector<Point>& points) {
    if (of_.particles.displacement != "solution") return get(of_.particles.displacement).inside(points).displacement;
    if (!of_.particles.solution) of_.fail("particles", "'solution' or 'displacement' (the strain operators need a displacement field)");
    const analytic::Field field = make_field(*of_.particles.solution, of_);
    std::vector<Point> displacement;
    for (const Point& x : points) displacement.push_back(field.displacement(x));
    return displacement;
}

const FieldSource* LevelSources::find(const std::string& solver) const {
    const auto found = sources_.find(solver);
    return found == sources_.end() ? nullptr : found->second.get();
}

FieldSource& LevelSources::get(const std::string& solver) {
    const auto found = sources_.find(solver);
    if (found != sources_.end()) return *found->second;
    SolveNote note;
    note.solver = solver;
    std::unique_ptr<FieldSource> made;
    if (solver.starts_with("fem."))
        made = run_fem(of_, body_, size_, solver, note);
    else if (solver == "sph.conforming" || solver == "sph.conforming_recovered")
        made = run_equilibrium(of_, body_, size_, solver, note);
    else if (solver.starts_with("sph.relaxed_"))
        made = run_relaxation(of_, body_, size_, solver, note);
    else
        made = run_particles(of_, body_, size_, solver, [this](const std::vector<Point>& points) { return displacement_at(points); }, note);
    notes_.push_back(note);
    return *(sources_[solver] = std::move(made));
}

}  // namespace cleave::validation
