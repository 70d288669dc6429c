#include "solver/elasticity/conforming_body.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/particles/neighbourhood.hpp"
#include "validation/adapters/force_checks.hpp"
#include "validation/adapters/particle_bodies.hpp"
#include "validation/adapters/sources.hpp"

#include <chrono>

namespace cleave::validation {

namespace {

/// Values of a strain operator at the particles, from given displacements.
class ParticleSource final : public FieldSource {
public:
    ParticleSource(Samples samples, double energy, double size, std::string name, std::shared_ptr<const OperatorState> state)
        : samples_(std::move(samples)), energy_(energy), size_(size), name_(std::move(name)), state_(std::move(state)) {}

    const Samples& everywhere() const override { return samples_; }
    Samples at(const std::vector<Point>&) const override {
        throw InputError("", name_, "'over' instead of 'at': particles have values where they are only");
    }
    double scalar(const std::string& quantity) const override {
        if (quantity == "energy") return energy_;
        if (state_ && is_force_quantity(quantity)) return force_quantity(*state_, quantity);
        throw InputError("", quantity, "a quantity that " + name_ + " has");
    }
    Resolution resolution() const override { return {size_, static_cast<long>(samples_.size()), 0}; }

private:
    Samples samples_;
    double energy_, size_;
    std::string name_;
    std::shared_ptr<const OperatorState> state_;
};

}  // namespace

std::unique_ptr<FieldSource> run_particles(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                           const std::function<std::vector<Point>(const std::vector<Point>&)>& displacement, SolveNote& note) {
    const auto start = std::chrono::steady_clock::now();
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    mesh::check(mesh, body.mesh_file.string());
    particles::Particles particles = particles::from_mesh(mesh, of.particles.support_factor);
    stretch_kernels(particles, of.particles);
    const std::vector<Eigen::Vector3d> u = eigen(displacement(plain(particles.position)));
    elasticity::Fields fields;
    std::shared_ptr<OperatorState> state;
    if (solver == "sph.conforming_operator") {
        const elasticity::ConformingBody conforming = elasticity::make_conforming_body(mesh, particles, stiffness_by_tag(of, body));
        std::vector<Eigen::Vector3d> trace;
        elasticity::face_displacements(conforming, u, trace);
        std::vector<Eigen::Matrix3d> gradient;
        for (int i = 0; i < particles.size(); ++i) gradient.push_back(elasticity::face_gradient(conforming, i, trace));
        fields = elasticity::fields_of_gradients(conforming, std::move(gradient));
        note.method = "conforming gradients";
    } else {
        const particles::Neighbourhood neighbourhood = particles::build_neighbourhood(particles);
        state = std::make_shared<OperatorState>(OperatorState{particles, elasticity::make_strain_operator(solver.substr(4), particles, neighbourhood),
                                                              solid_of(of, body, particles.region), u});
        fields = elasticity::evaluate(state->op, particles, state->solid, u);
        note.method = "strain operator";
    }
    note.cells = particles.size();
    note.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::make_unique<ParticleSource>(particle_samples(particles, u, fields), fields.total_energy(), size, solver, state);
}

}  // namespace cleave::validation
