#include "solver/elasticity/relaxation.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/adapters/particle_bodies.hpp"
#include "validation/adapters/sources.hpp"
#include "validation/solutions.hpp"

#include <Eigen/Geometry>

#include <chrono>

namespace cleave::validation {

namespace {

/// The displacement that holds the whole surface. These particles have no other boundary condition.
analytic::Field held_field(const Case& of) {
    const bool fits = of.loads.size() == 1 && of.loads[0].kind == SurfaceLoad::Kind::displacement && of.loads[0].solution &&
                      of.loads[0].on == std::vector<std::string>{"all"};
    if (!fits) of.fail("load", "displacement = [{ on = \"all\", solution = ... }] alone, for sph.relaxed_*");
    return make_field(*of.loads[0].solution, of);
}

/// The particles of tets with a face on the surface.
std::vector<bool> surface_particles(const mesh::TetMesh& mesh) {
    std::vector<bool> held(mesh.tets.size(), false);
    const std::vector<int> opposite = mesh::link_half_faces(mesh).opposite;
    for (std::size_t half = 0; half < opposite.size(); ++half)
        if (opposite[half] < 0) held[half / 4] = true;
    return held;
}

class RelaxedSource final : public FieldSource {
public:
    RelaxedSource(const Case& of, const geometry::Body& body, double size, const std::string& name)
        : file_(of.file), name_(name), size_(size) {
        const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
        mesh::check(mesh, body.mesh_file.string());
        particles::Particles particles = particles::from_mesh(mesh, of.particles.support_factor);
        const particles::Neighbourhood neighbourhood = particles::build_neighbourhood(particles);
        const std::string strain = name.substr(std::string("sph.relaxed_").size());
        const elasticity::StrainOperator op = elasticity::make_strain_operator(strain, particles, neighbourhood);
        const elasticity::Solid solid = solid_of(of, body, particles.region);
        const std::vector<Point> places = plain(particles.position);
        const analytic::Field field = held_field(of);
        elasticity::RelaxationProblem problem{op, particles, solid, loads(of, particles, places), surface_particles(mesh), {}};
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Point u = problem.held[i] ? field.displacement(places[i]) : Point{0, 0, 0};
            problem.displacement.emplace_back(u[0], u[1], u[2]);
        }
        relaxed_ = elasticity::relax(problem);
        const elasticity::Fields fields = elasticity::evaluate(op, particles, solid, relaxed_.displacement);
        samples_ = particle_samples(particles, relaxed_.displacement, fields);
        energy_ = fields.total_energy();
    }

    const Samples& everywhere() const override { return samples_; }
    Samples at(const std::vector<Point>&) const override {
        throw InputError(file_, name_, "'over' instead of 'at': particles have values where they are only");
    }
    double scalar(const std::string& quantity) const override {
        if (quantity == "energy") return energy_;
        if (quantity == "residual") return relaxed_.residual;
        throw InputError(file_, quantity, "a quantity that " + name_ + " has (energy, residual)");
    }
    Resolution resolution() const override { return {size_, static_cast<long>(samples_.size()), 3 * static_cast<long>(samples_.size())}; }
    const elasticity::Relaxation& relaxed() const { return relaxed_; }

private:
    /// Body force times volume, N.
    static std::vector<Eigen::Vector3d> loads(const Case& of, const particles::Particles& particles, const std::vector<Point>& places) {
        std::vector<Point> density(places.size(), of.body_force);
        if (of.body_force_solution) {
            const analytic::Field field = make_field(*of.body_force_solution, of);
            if (!field.body_force) of.fail(of.body_force_solution->where, "a solution with a body force");
            for (std::size_t i = 0; i < places.size(); ++i) density[i] = field.body_force(places[i]);
        }
        std::vector<Eigen::Vector3d> load = eigen(density);
        for (std::size_t i = 0; i < load.size(); ++i) load[i] *= particles.volume[i];
        return load;
    }

    std::string file_, name_;
    double size_, energy_ = 0;
    elasticity::Relaxation relaxed_;
    Samples samples_;
};

}  // namespace

std::unique_ptr<FieldSource> run_relaxation(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                            SolveNote& note) {
    const auto start = std::chrono::steady_clock::now();
    auto source = std::make_unique<RelaxedSource>(of, body, size, solver);
    note.method = "forces of Eq. 9, damped relaxation";
    note.cells = source->resolution().particles;
    note.dofs = source->resolution().dofs;
    note.iterations = source->relaxed().steps;
    note.residual = source->relaxed().residual;
    note.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return source;
}

}  // namespace cleave::validation
