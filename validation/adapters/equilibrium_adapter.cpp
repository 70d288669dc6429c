#include "solver/elasticity/stress_intensity.hpp"
#include "solver/fracture/crack_tip.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/adapters/crack_station.hpp"
#include "validation/adapters/particle_bodies.hpp"
#include "validation/adapters/sources.hpp"
#include "validation/solutions.hpp"

#include <Eigen/Geometry>

#include <chrono>
#include <cmath>
#include <optional>
#include <random>

namespace cleave::validation {

namespace {

using elasticity::EquilibriumProblem;

Point plain(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
Eigen::Vector3d eigen(const Point& p) { return {p[0], p[1], p[2]}; }

elasticity::VectorField displacement_field(const SurfaceLoad& load, const Case& of) {
    if (!load.solution) return [value = eigen(load.vector)](const Eigen::Vector3d&) { return value; };
    return [field = make_field(*load.solution, of)](const Eigen::Vector3d& x) { return eigen(field.displacement(plain(x))); };
}

/// A constant traction, or sigma n of an analytic solution.
elasticity::SurfaceField traction_field(const SurfaceLoad& load, const Case& of) {
    if (!load.solution) return [value = eigen(load.vector)](const Eigen::Vector3d&, const Eigen::Vector3d&) { return value; };
    return [field = make_field(*load.solution, of)](const Eigen::Vector3d& x, const Eigen::Vector3d& n) {
        const Voigt s = field.stress(plain(x));
        Eigen::Matrix3d stress;
        stress << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
        return Eigen::Vector3d(stress * n);
    };
}

void add_loads(EquilibriumProblem& problem, const Case& of, const geometry::Body& body) {
    for (const SurfaceLoad& load : of.loads)
        for (const int tag : surface_tags(load, body, of)) switch (load.kind) {
                case SurfaceLoad::Kind::pressure: problem.pressures.push_back({tag, load.pressure}); break;
                case SurfaceLoad::Kind::traction: problem.tractions.push_back({tag, traction_field(load, of)}); break;
                case SurfaceLoad::Kind::displacement: problem.displacements.push_back({tag, load.components, displacement_field(load, of)});
            }
    if (of.body_force_solution) {
        const analytic::Field field = make_field(*of.body_force_solution, of);
        if (!field.body_force) of.fail(of.body_force_solution->where, "a solution with a body force");
        problem.body_force = [field](const Eigen::Vector3d& x) { return eigen(field.body_force(plain(x))); };
    } else if (of.body_force != std::array<double, 3>{}) {
        problem.body_force = [value = eigen(of.body_force)](const Eigen::Vector3d&) { return value; };
    }
}

EquilibriumProblem make_problem(const Case& of, const geometry::Body& body, const mesh::TetMesh& mesh) {
    if (!of.supports.empty() || !of.lines.empty()) of.fail("load", "loads and displacements on surfaces for sph.conforming (particles have no nodes)");
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = stiffness_by_tag(of, body);
    for (const auto& [name, tag] : body.regions)
        if (const double density = material_of(of, name).density; density > 0) problem.density[tag] = density;
    problem.free_body = of.free_body;
    add_loads(problem, of, body);
    return problem;
}

/// Every vertex moved in a random direction (seeded) by `distance`, m.
mesh::TetMesh jiggled(mesh::TetMesh mesh, double distance) {
    std::mt19937_64 engine(7);
    for (Eigen::Vector3d& x : mesh.vertices) {
        Eigen::Vector3d direction;
        for (int k = 0; k < 3; ++k) direction[k] = static_cast<double>(engine() >> 11) * 0x1p-52 - 1;
        x += distance * direction.normalized();
    }
    return mesh;
}

class EquilibriumSource final : public FieldSource {
public:
    EquilibriumSource(const Case& of, const geometry::Body& body, double size, bool recovered)
        : of_(of), body_(body), size_(size), mesh_(mesh::read_msh(body.mesh_file)) {
        mesh::check(mesh_, body.mesh_file.string());
        if (of.particles.link_penalty) options_.link_penalty = *of.particles.link_penalty;
        if (of.particles.residual_tolerance) options_.tolerance = *of.particles.residual_tolerance;
        solution_ = solve(mesh_);
        samples_ = particle_samples(solution_.body->particles, solution_.displacement, recovered ? solution_.recovered : solution_.fields);
    }

    const Samples& everywhere() const override { return samples_; }
    Samples at(const std::vector<Point>&) const override {
        throw InputError(of_.file, "sph.conforming", "'over' instead of 'at': particles have values where they are only");
    }
    double scalar(const std::string& quantity) const override {
        if (quantity == "energy") return solution_.strain_energy + solution_.link_energy;
        if (quantity == "external_work") return solution_.external_work;
        if (quantity == "residual") return solution_.report.residual;
        if (quantity == "vertex_sensitivity") {
            const double moved = solve(jiggled(mesh_, 1e-9 * size_)).strain_energy;
            return std::abs(moved - solution_.strain_energy) / solution_.strain_energy;
        }
        if (quantity == "patch_residual") return patch_residual();
        if (quantity == "acceleration_balance") return acceleration_balance();
        if (quantity == "energy_release_rate") return energy_release().by_movement;
        if (quantity == "energy_release_rate_domain") return energy_release().by_domain_integral;
        if (quantity == "crack_opening") return crack_opening();
        throw InputError(of_.file, quantity, "a quantity that sph.conforming has");
    }
    double at_front(const std::string& quantity, const std::string& component, const Point& place) const override {
        const Station& at = station(place);
        if (quantity == "energy_release_rate_at") return at.domain;
        if (at.station.front.loop > 0) throw std::invalid_argument("a straight front for the stress intensities of sph.conforming");
        if (quantity == "energy_release_rate_from_k") return at.intensities.energy_release;
        if (quantity == "energy_release_gap") return std::abs(at.intensities.energy_release / at.domain - 1);
        if (quantity == "crack_direction") return component == "hoop_size" ? std::abs(direction(at, "hoop")) : direction(at, component);
        return at.intensities.k[component == "II" ? 0 : component == "I" ? 1 : 2];
    }
    Resolution resolution() const override { return {size_, static_cast<long>(samples_.size()), 3 * static_cast<long>(samples_.size())}; }
    const elasticity::EquilibriumReport& report() const { return solution_.report; }

private:
    elasticity::EquilibriumSolution solve(const mesh::TetMesh& mesh) const {
        try {
            return elasticity::solve_equilibrium(make_problem(of_, body_, mesh), options_);
        } catch (const std::invalid_argument& error) {
            throw InputError(of_.file, "sph.conforming", std::string("a problem that can be solved: ") + error.what());
        } catch (const elasticity::NotConverged& error) {
            throw InputError(of_.file, "sph.conforming", std::string("a stiffness and a mesh of better condition: ") + error.what());
        }
    }

    /// The residual of the exact field at the particles, nothing solved.
    double patch_residual() const {
        if (!of_.particles.solution) of_.fail("particles.solution", "the exact field that patch_residual puts in (the key is missing)");
        const analytic::Field field = make_field(*of_.particles.solution, of_);
        std::vector<Eigen::Vector3d> exact;
        for (const Eigen::Vector3d& x : solution_.body->particles.position) exact.push_back(eigen(field.displacement(plain(x))));
        return elasticity::balance_residual(make_problem(of_, body_, mesh_), exact, options_);
    }

    /// |load - sum m a| over |load|, and the same for moments about the origin, the larger: the surface loads are integrated here anew.
    double acceleration_balance() const {
        Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
        double size_of_force = 0, size_of_moment = 0;
        const auto add = [&](const Eigen::Vector3d& x, const Eigen::Vector3d& f) {
            force += f, moment += x.cross(f);
            size_of_force += f.norm(), size_of_moment += x.norm() * f.norm();
        };
        const EquilibriumProblem problem = make_problem(of_, body_, mesh_);
        for (const elasticity::BoundaryTrace& face : solution_.boundary) {
            for (const elasticity::Traction& t : problem.tractions)
                if (t.surface == face.surface) add(face.position, face.area * t.value(face.position, face.normal));
            for (const elasticity::Pressure& p : problem.pressures)
                if (p.surface == face.surface) add(face.position, -face.area * p.value * face.normal);
        }
        const particles::Particles& particles = solution_.body->particles;
        for (std::size_t i = 0; i < solution_.acceleration.size(); ++i) {
            const auto density = problem.density.find(particles.region[i]);
            const double mass = (density == problem.density.end() ? 1 : density->second) * particles.volume[i];
            add(particles.position[i], -mass * solution_.acceleration[i]);
        }
        return std::max(force.norm() / size_of_force, moment.norm() / size_of_moment);
    }

    struct Station {
        CrackStation station;
        double domain = 0;
        elasticity::StressIntensities intensities;
    };

    const Station& station(const Point& place) const {
        const auto found = stations_.find(place);
        if (found != stations_.end()) return found->second;
        Station result{station_near(*of_.shape, place), 0, {}};
        const EquilibriumProblem problem = make_problem(of_, body_, mesh_);
        const elasticity::CrackExtension extension = extend(result.station.growth);
        result.domain = elasticity::energy_release(problem, options_, solution_, {extension}, growth_step()).front().by_domain_integral;
        if (result.station.front.loop == 0) result.intensities = elasticity::stress_intensities(problem, solution_, straight_front(result.station), extension);
        return stations_.emplace(place, result).first->second;
    }

    static Eigen::Matrix3d axes_of(const CrackStation& station) {
        Eigen::Matrix3d axes;
        for (int k = 0; k < 3; ++k) axes.col(k) = eigen(station.place.axes[k]);
        return axes;
    }
    static elasticity::StraightFront straight_front(const CrackStation& station) { return {eigen(station.place.position), axes_of(station)}; }

    double direction(const Station& at, const std::string& criterion) const {
        using enum fracture::TipCriterion;
        const Eigen::Vector3d& k = at.intensities.k;
        const auto toughness = fracture::Toughness::weak_plane(1, eigen(of_.toughness.weak_normal), of_.toughness.ratio);
        return fracture::kink_direction(solution_.body->solid.of(0), axes_of(at.station), {.I = k[1], .II = k[0], .III = k[2]},
                                        criterion == "hoop" ? hoop : criterion == "energy" ? energy : weighted_hoop, toughness)
            .angle;
    }

    elasticity::CrackExtension extend(const std::function<Point(const Point&)>& growth) const {
        return {body_.surfaces.at(of_.shape->crack_fronts().front().lips), [growth](const Eigen::Vector3d& x) { return eigen(growth(plain(x))); }};
    }
    double growth_step() const { return 1e-3 * of_.shape->crack_fronts().front().reach; }

    const elasticity::EnergyRelease& energy_release() const {
        if (release_) return *release_;
        const elasticity::CrackExtension extension = extend(whole_growth(*of_.shape));
        release_ = elasticity::energy_release(make_problem(of_, body_, mesh_), options_, solution_, {extension}, growth_step()).front();
        return *release_;
    }

    /// Mean over the lips within 0.3 radii of the centre, each face scaled by the ellipse sqrt(1 - r^2/a^2) it should lie on.
    double crack_opening() const {
        const Eigen::Vector3d normal = eigen(station_near(*of_.shape, {}).place.axes[1]);
        const double a = of_.shape->length("crack_radius");
        const int lips = body_.surfaces.at(of_.shape->crack_fronts().front().lips);
        std::array<double, 2> sum{}, weight{};  // lips by the side their normal points to
        for (const elasticity::BoundaryTrace& face : solution_.boundary) {
            const double r = face.position.norm();
            if (face.surface != lips || r > 0.3 * a) continue;
            const std::size_t lip = face.normal.dot(normal) > 0 ? 0 : 1;
            sum[lip] -= face.area * face.displacement.dot(face.normal) / std::sqrt(1 - r * r / (a * a));
            weight[lip] += face.area;
        }
        return sum[0] / weight[0] + sum[1] / weight[1];
    }

    const Case& of_;
    geometry::Body body_;
    double size_;
    mesh::TetMesh mesh_;
    elasticity::EquilibriumOptions options_;
    elasticity::EquilibriumSolution solution_;
    mutable std::optional<elasticity::EnergyRelease> release_;  // asked for twice, evaluated once
    Samples samples_;
    mutable std::map<Point, Station> stations_;
};

}  // namespace

std::unique_ptr<FieldSource> run_equilibrium(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                             SolveNote& note) {
    const auto start = std::chrono::steady_clock::now();
    auto source = std::make_unique<EquilibriumSource>(of, body, size, solver == "sph.conforming_recovered");
    note.method = "conforming, preconditioned conjugate gradients";
    note.cells = source->resolution().particles;
    note.dofs = source->resolution().dofs;
    note.iterations = source->report().iterations;
    note.residual = source->report().residual;
    note.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return source;
}

}  // namespace cleave::validation
