#include "solver/elasticity/strain.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/particles/neighbourhood.hpp"
#include "validation/adapters/sources.hpp"

#include <chrono>

namespace cleave::validation {

namespace {

Point plain(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Voigt plain(const material::Voigt& v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }

class ParticleSource final : public FieldSource {
public:
    ParticleSource(Samples samples, double energy, double size, std::string name)
        : samples_(std::move(samples)), energy_(energy), size_(size), name_(std::move(name)) {}

    const Samples& everywhere() const override { return samples_; }
    Samples at(const std::vector<Point>&) const override {
        throw InputError("", name_, "'over' instead of 'at': strain operators have values at particles only");
    }
    double strain_energy() const override { return energy_; }
    Resolution resolution() const override { return {size_, static_cast<long>(samples_.size()), 0}; }

private:
    Samples samples_;
    double energy_, size_;
    std::string name_;
};

/// One material per region of the body.
elasticity::Solid solid_of(const Case& of, const geometry::Body& body, const std::vector<int>& regions) {
    elasticity::Solid solid;
    std::map<int, int> index;
    for (const auto& [name, tag] : body.regions) {
        index[tag] = static_cast<int>(solid.stiffness.size());
        solid.stiffness.push_back(material_of(of, name).stiffness);
    }
    for (const int tag : regions) solid.material.push_back(index.at(tag));
    return solid;
}

}  // namespace

std::unique_ptr<FieldSource> run_particles(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                           const std::function<std::vector<Point>(const std::vector<Point>&)>& displacement, SolveNote& note) {
    const auto start = std::chrono::steady_clock::now();
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    mesh::check(mesh, body.mesh_file.string());
    particles::Particles particles = particles::from_mesh(mesh, of.particles.support_factor);
    const particles::Neighbourhood neighbourhood = particles::build_neighbourhood(particles);
    const elasticity::StrainOperator op = elasticity::make_strain_operator(solver.substr(4), particles, neighbourhood);
    Samples samples;
    for (const Eigen::Vector3d& x : particles.position) samples.position.push_back(plain(x));
    samples.weight = particles.volume;
    samples.displacement = displacement(samples.position);
    std::vector<Eigen::Vector3d> u;
    for (const Point& p : samples.displacement) u.emplace_back(p[0], p[1], p[2]);
    const elasticity::Fields fields = elasticity::evaluate(op, particles, solid_of(of, body, particles.region), u);
    for (const material::Voigt& strain : fields.strain) samples.strain.push_back(plain(strain));
    for (const material::Voigt& stress : fields.stress) samples.stress.push_back(plain(stress));
    note.method = "strain operator";
    note.cells = particles.size();
    note.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::make_unique<ParticleSource>(std::move(samples), fields.total_energy(), size, solver);
}

}  // namespace cleave::validation
