#include "validation/studies/griffith.hpp"

#include "reference_fem/elasticity.hpp"
#include "solver/elasticity/energy_release.hpp"
#include "solver/fracture/crack_tip.hpp"
#include "solver/fracture/radii.hpp"
#include "solver/material/material.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/analytic/sneddon_penny.hpp"
#include "validation/analytic/wedged_penny.hpp"
#include "validation/geometry/shape.hpp"
#include "validation/solutions.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::validation {

namespace {

using std::numbers::pi;

struct Setup {
    material::Stiffness stiffness;
    double toughness = 0;                          ///< J/m^2
    double force = 0, tension = 0;                 ///< N on each lip; Pa far away
    double radius = 0, load_radius = 0, width = 0;  ///< m: of the mesh's crack; of the disc under the force; of the cube's half
    std::shared_ptr<const geometry::Shape> shape;
    std::vector<double> radii;                     ///< m, to which the front is moved
    double size = 0;                               ///< m
};

enum class Load { point, far };

const char* place_of(Load load) { return load == Load::point ? "point load" : "far load"; }

/// The straight line through points by least squares, at x.
double line_through(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
    const auto count = static_cast<double>(xs.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) mean_x += xs[i] / count, mean_y += ys[i] / count;
    for (std::size_t i = 0; i < xs.size(); ++i) xx += std::pow(xs[i] - mean_x, 2), xy += (xs[i] - mean_x) * (ys[i] - mean_y);
    return mean_y + xy / xx * (x - mean_x);
}

/// G(a), J/m^2, of one method under one load.
using Release = std::function<double(double radius)>;

/// Where G meets the toughness near the radii examined, from either side: bisection within a factor of 1.5 beyond them.
double meeting_radius(const Release& release, const Setup& setup) {
    double low = setup.radii.front() / 1.5, high = setup.radii.back() * 1.5;
    const bool falling = release(low) > setup.toughness;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        ((release(middle) > setup.toughness) == falling ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// d ln a / d ln load of the meeting radius: G goes with the load's square, so -2 / (d ln G / d ln a).
double load_exponent(const Release& release, double radius) {
    const double step = 1e-3;
    return -2 * 2 * step / std::log(release(radius * (1 + step)) / release(radius * (1 - step)));
}

/// Radial growth of a front of radius a, fading to zero at 0.6 a from it.
elasticity::VectorField growth(double a) {
    return [a](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        const double r = std::hypot(x.x(), x.y()), share = 1 - std::hypot(r - a, x.z()) / (0.6 * a);
        return share > 0 ? Eigen::Vector3d(share * x.x() / r, share * x.y() / r, 0) : Eigen::Vector3d::Zero();
    };
}

mesh::TetMesh with_radius(const mesh::TetMesh& mesh, double from, double to) {
    mesh::TetMesh moved = mesh;
    const auto grow = growth(from);
    for (Eigen::Vector3d& x : moved.vertices) x += (to - from) * grow(x);
    return moved;
}

double core_pressure(const Setup& setup) { return setup.force / (pi * setup.load_radius * setup.load_radius); }

Release in_closed_form(const Setup& setup, Load load) {
    const material::EngineeringConstants constants = material::engineering_constants(setup.stiffness);
    if (load == Load::point)
        return [=](double a) { return analytic::wedged_penny_release(constants.E1, constants.nu12, setup.force, setup.load_radius, a); };
    return [=](double a) {
        return analytic::sneddon_penny(plain_stiffness(setup.stiffness), a, setup.tension, 1).scalars.at("energy_release_rate");
    };
}

/// A power law through values of G, by least squares of ln G over ln a.
Release power_law(std::vector<double> radius, std::vector<double> rate) {
    for (double& a : radius) a = std::log(a);
    for (double& rate_at : rate) rate_at = std::log(rate_at);
    return [radius, rate](double a) { return std::exp(line_through(radius, rate, std::log(a))); };
}

/// The eighth as finite elements see it, but for its mesh.
fem::Problem fem_problem(const Setup& setup, Load load, const geometry::Body& body) {
    fem::Problem problem;
    problem.regions = {{body.regions.at("body"), plain_stiffness(setup.stiffness)}};
    const auto fixed = [](const fem::Point&) { return fem::Point{0, 0, 0}; };
    problem.displacements = {{body.surfaces.at("left"), {true, false, false}, fixed},
                             {body.surfaces.at("front"), {false, true, false}, fixed},
                             {body.surfaces.at("ligament"), {false, false, true}, fixed}};
    if (load == Load::point)
        problem.pressures = {{body.surfaces.at("core"), core_pressure(setup)}};
    else
        problem.tractions = {{body.surfaces.at("top"), [t = setup.tension](const fem::Point&) { return fem::Point{0, 0, t}; }}};
    return problem;
}

/// Finite elements: G = dU/dA at fixed load by central differences of the energy on meshes moved half a per cent either way.
Release by_finite_elements(const Setup& setup, Load load, const geometry::Body& body, const mesh::TetMesh& mesh, StudyOutcome& outcome) {
    fem::Problem problem = fem_problem(setup, load, body);
    problem.mesh_file = body.mesh_file.string() + fmt::format(".moved{}.msh", ::getpid());
    const auto energy = [&](double a) {
        mesh::write_msh(with_radius(mesh, setup.radius, a), problem.mesh_file);
        const fem::Solution solution = fem::solve(problem);
        std::filesystem::remove(problem.mesh_file);
        const fem::SolveRecord& record = solution.record();
        outcome.solves.push_back(
            {"fem.p2", record.solver, record.cells, record.dofs, record.iterations, record.relative_residual, record.seconds});
        return 8 * solution.energy();
    };
    std::vector<double> rate;
    for (const double a : setup.radii) {
        const double low = 0.995 * a, high = 1.005 * a;
        rate.push_back((energy(high) - energy(low)) / (pi * (high * high - low * low)));
    }
    return power_law(setup.radii, rate);
}

struct ParticleRelease {
    Release release;
    double energy = 0;  ///< J, of the whole cube, at the largest radius
};

/// Particles in equilibrium: G by moved vertices at each radius.
ParticleRelease by_particles(const Setup& setup, Load load, const geometry::Body& body, const mesh::TetMesh& mesh) {
    using Place = const Eigen::Vector3d&;
    const auto fixed = [](Place) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
    const auto pull = [t = setup.tension](Place, Place) -> Eigen::Vector3d { return {0, 0, t}; };
    std::vector<double> rate;
    ParticleRelease result;
    for (const double a : setup.radii) {
        const mesh::TetMesh moved = with_radius(mesh, setup.radius, a);
        elasticity::EquilibriumProblem problem{.mesh = moved};
        problem.stiffness = {{body.regions.at("body"), setup.stiffness}};
        problem.displacements = {{body.surfaces.at("left"), {true, false, false}, fixed},
                                 {body.surfaces.at("front"), {false, true, false}, fixed},
                                 {body.surfaces.at("ligament"), {false, false, true}, fixed}};
        if (load == Load::point)
            problem.pressures = {{body.surfaces.at("core"), core_pressure(setup)}};
        else
            problem.tractions = {{body.surfaces.at("top"), pull}};
        const elasticity::EquilibriumOptions options;
        const elasticity::EquilibriumSolution solution = elasticity::solve_equilibrium(problem, options);
        const elasticity::CrackExtension extension{body.surfaces.at("lips"), growth(a)};
        rate.push_back(elasticity::energy_release(problem, options, solution, {extension}, 1e-3 * a).front().by_movement);
        result.energy = 8 * solution.strain_energy;
    }
    result.release = power_law(setup.radii, rate);
    return result;
}

class Griffith final : public Study {
public:
    Griffith(Setup setup, std::vector<double> quick_radii, std::vector<double> full_radii, double quick_size, double full_size)
        : setup_(std::move(setup)), radii_{std::move(quick_radii), std::move(full_radii)}, size_{quick_size, full_size} {}

    StudyOutcome run(const StudyContext& context) const override {
        Setup setup = setup_;
        setup.radii = radii_[context.level == "full"];
        setup.size = size_[context.level == "full"];
        const geometry::Body body = setup.shape->mesh(setup.size, context.meshes);
        const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
        StudyOutcome outcome;
        for (const Load load : {Load::point, Load::far}) {
            const Resolution resolution{setup.size, static_cast<long>(mesh.tets.size()), 0};
            record("analytic", in_closed_form(setup, load), setup, load, {}, outcome);
            record("fem.p2", by_finite_elements(setup, load, body, mesh, outcome), setup, load, resolution, outcome);
            const ParticleRelease particles = by_particles(setup, load, body, mesh);
            record("solver", particles.release, setup, load, resolution, outcome);
            record_rest(particles.release, setup, load, resolution, outcome);
            record_scaled(particles.energy, setup, load, mesh, outcome);
        }
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return {setup_.stiffness}; }

private:
    static void record(const std::string& method, const Release& release, const Setup& setup, Load load, Resolution resolution,
                       StudyOutcome& outcome) {
        const double meeting = meeting_radius(release, setup);
        outcome.values.push_back({"energy_release_rate", method, place_of(load), release(setup.radius), resolution});
        outcome.values.push_back({"equilibrium_radius", method, place_of(load), meeting, resolution});
        outcome.values.push_back({"load_exponent", method, place_of(load), load_exponent(release, meeting), resolution});
    }

    /// What solver/fracture says of a crack that starts 5 % below and 5 % above the meeting radius: how far it grows, over that radius.
    static void record_rest(const Release& release, const Setup& setup, Load load, Resolution resolution, StudyOutcome& outcome) {
        const double meeting = meeting_radius(release, setup);
        for (const double start : {0.95, 1.05}) {
            const auto found = fracture::equilibrium_radius(release, setup.toughness, start * meeting, 1.2 * meeting);
            const std::string place = fmt::format("{}, from {:g}", place_of(load), start);
            outcome.values.push_back({"rest_over_meeting", "solver", place, found.radius / meeting, resolution});
        }
    }

    /// Eq. 11 as a scaling of the energy, and the far form of a local force.
    static void record_scaled(double energy, const Setup& setup, Load load, const mesh::TetMesh& mesh, StudyOutcome& outcome) {
        const double thickness = 2 * setup.width, area = pi * setup.load_radius * setup.load_radius, no_cap = 1e300;
        const double spacing = std::cbrt(mesh::total_volume(mesh) / static_cast<double>(mesh.tets.size()));
        for (const auto& [method, exponent] : {std::pair{"printed", 1.0}, std::pair{"printed, eta 0", 0.0}}) {
            const double weight = fracture::contact_weight(area, spacing * spacing, exponent);
            const double radius = fracture::proportional_radius(energy, setup.toughness, thickness, weight, no_cap);
            const double doubled = fracture::proportional_radius(4 * energy, setup.toughness, thickness, weight, no_cap);
            outcome.values.push_back({"equilibrium_radius", method, place_of(load), radius});
            outcome.values.push_back({"load_exponent", method, place_of(load), std::log2(doubled / radius)});
        }
        if (load == Load::far) return;
        const double modulus = fracture::effective_modulus(setup.stiffness, Eigen::Vector3d::UnitZ());
        const double radius = fracture::wedged_radius(setup.force, setup.toughness, modulus, no_cap);
        outcome.values.push_back({"equilibrium_radius", "balance", place_of(load), radius});
        outcome.values.push_back({"load_exponent", "balance", place_of(load),
                                  std::log2(fracture::wedged_radius(2 * setup.force, setup.toughness, modulus, no_cap) / radius)});
    }

    Setup setup_;
    std::array<std::vector<double>, 2> radii_;
    std::array<double, 2> size_;
};

double positive(TableReader& table, const std::string& key, Dimension dimension) {
    const double value = table.quantity(key, dimension);
    if (!(value > 0)) table.fail(key, "a value above zero");
    return value;
}

/// Ascending factors of the mesh's crack radius.
std::vector<double> radii(TableReader& table, const std::string& key, double radius) {
    std::vector<double> result = table.numbers(key);
    const bool ascending = result.size() > 1 && std::is_sorted(result.begin(), result.end());
    if (!ascending || result.front() < 0.7 || result.back() > 1.4)
        table.fail(key, "two or more ascending factors of the crack's radius from 0.7 to 1.4");
    for (double& value : result) value *= radius;
    return result;
}

std::shared_ptr<const Study> read(TableReader& study) {
    Setup setup;
    TableReader material = study.table("material");
    setup.stiffness = material::read_material(material).stiffness;
    TableReader shape = study.table("geometry");
    setup.shape = geometry::read_shape(shape);
    setup.radius = setup.shape->length("crack_radius");
    setup.load_radius = setup.shape->length("load_radius");
    setup.width = setup.shape->length("half_width");
    setup.toughness = positive(study, "toughness", dimension::energy_per_area);
    setup.force = positive(study, "force", dimension::force);
    setup.tension = positive(study, "tension", dimension::pressure);
    const std::vector<double> quick = radii(study, "quick_radii", setup.radius), full = radii(study, "full_radii", setup.radius);
    return std::make_shared<Griffith>(setup, quick, full, positive(study, "quick_size", dimension::length),
                                      positive(study, "full_size", dimension::length));
}

}  // namespace

StudyInfo griffith_study() {
    return {"griffith",
            "where a penny crack rests under forces at its centre and under a far load: G(a) = G_c, and Eq. 11 as printed",
            {"material", "geometry", "toughness", "force", "tension", "quick_radii", "full_radii", "quick_size", "full_size"},
            {{"energy_release_rate", dimension::energy_per_area},
             {"equilibrium_radius", dimension::length},
             {"load_exponent", dimension::none},
             {"rest_over_meeting", dimension::none}},
            {"solver", "fem.p2", "analytic", "balance", "printed", "printed, eta 0"},
            read,
            {"analytic", "balance"}};
}

}  // namespace cleave::validation
