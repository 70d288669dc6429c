// From a nanometre to a kilometre the same dimensionless answers: stiffness and stress stay, lengths go with the unit, and with them forces
// (its square), energies (its cube) and toughness. An absolute tolerance hidden anywhere would show. 1e-9 is the bound: the units are no
// powers of two, so every number is rounded anew, and condition numbers of 1e4 (of neighbourhoods, of an equilibrium) multiply 1e-16.

#include "validation/test/robustness/odd_bodies.hpp"

#include "solver/contact/contact_displacement.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/indentation.hpp"
#include "solver/elasticity/energy_release.hpp"
#include "solver/elasticity/strain_pass.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/fragments/fragmented_body.hpp"
#include "solver/fragments/mass_properties.hpp"
#include "solver/fragments/surface.hpp"
#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/particles/wpca.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <gtest/gtest.h>

namespace cleave::robustness {
namespace {

using elasticity::test::triclinic;
using Eigen::Vector3d;

constexpr double same = 1e-9;

class Scale : public testing::TestWithParam<double> {
protected:
    double unit() const { return GetParam(); }
};
std::string unit_name(const testing::TestParamInfo<double>& info) {
    return info.param == 1e-9 ? "nanometre" : info.param == 1e-6 ? "micrometre" : info.param == 1e-3 ? "millimetre" : "kilometre";
}
INSTANTIATE_TEST_SUITE_P(Units, Scale, testing::Values(1e-9, 1e-6, 1e-3, 1e3), unit_name);

/// A displacement without any symmetry, of lengths in `unit`: gradients of 1e-3.
Vector3d wavy(const Vector3d& x, double unit) {
    const Vector3d y = x / unit;
    return 1e-3 * unit * Vector3d(std::sin(2 * y[0] + y[1]), y[0] * y[1] - y[2] * y[2], std::cos(y[1] - 1.5 * y[2]) + y[0]);
}

/// All a strain operator makes of the wavy displacement in a body of irregular cells.
struct Strained {
    particles::Neighbourhood neighbourhood;
    elasticity::Fields fields;
    elasticity::OperatorReport report;
};
Strained strained(const std::string& name, double unit, bool wpca) {
    const mesh::TetMesh mesh = scaled(tagged_block({6, 5, 4}, {1, 0.8, 0.5}), unit);
    particles::Particles particles = particles::from_mesh(mesh);
    if (wpca) particles::apply_wpca(particles);
    std::vector<Vector3d> displacement;
    for (const Vector3d& x : particles.position) displacement.push_back(wavy(x, unit));
    const elasticity::Solid solid = elasticity::uniform_solid(triclinic(), particles.size());
    Strained result;
    elasticity::StrainOperator op;
    if (name == "conforming") {
        op = elasticity::conforming_operator(elasticity::make_conforming_body(mesh, particles, {{0, triclinic()}}));
    } else {
        result.neighbourhood = particles::build_neighbourhood(particles);
        op = elasticity::make_strain_operator(name == "pass" ? "corrected" : name, particles, result.neighbourhood);
    }
    if (name == "pass") elasticity::StrainPass(particles, result.neighbourhood.lists, solid).evaluate(displacement, result.fields);
    else result.fields = elasticity::evaluate(op, particles, solid, displacement);
    result.report = op.report;
    return result;
}

TEST_P(Scale, StrainOperators) {
    for (const std::string name : {"paper", "corrected", "quadratic", "conforming", "pass"})
        for (const bool wpca : {false, true}) {
            const Strained one = strained(name, 1, wpca), other = strained(name, unit(), wpca);
            EXPECT_EQ(one.neighbourhood.lists.index, other.neighbourhood.lists.index) << name;
            EXPECT_EQ(one.report.raised_supports, other.report.raised_supports) << name;
            EXPECT_EQ(one.report.fallbacks, other.report.fallbacks) << name;
            EXPECT_LT(difference(other.fields.gradient, one.fields.gradient), same) << name;
            EXPECT_LT(difference(other.fields.stress, one.fields.stress), same) << name;
            EXPECT_LT(difference(times(std::pow(unit(), -3), other.fields.energy), one.fields.energy), same) << name;
        }
}

TEST(ScaleTwin, AnotherShapeIsNotTheSame) {
    const Strained one = strained("corrected", 1, false);
    std::vector<double> energies = one.fields.energy;
    energies.back() *= 1 + 3e-9;
    EXPECT_GT(difference(strained("corrected", 1e-9, true).fields.gradient, one.fields.gradient), 1e-3);
    EXPECT_LT(difference(energies, one.fields.energy), 3.1e-9);
    energies.back() = NAN;
    EXPECT_EQ(difference(energies, one.fields.energy), INFINITY);
}

/// A cracked cube of triclinic material, pulled, its crack under pressure, with a body force.
struct CrackedCube {
    mesh::TetMesh mesh;
    elasticity::EquilibriumProblem problem;
    elasticity::EquilibriumSolution solution;

    explicit CrackedCube(double unit) : mesh(scaled(elasticity::test::cracked_cube(6, 0.34), unit)), problem{.mesh = mesh} {
        problem.stiffness = {{0, triclinic()}};
        problem.displacements = {{.surface = elasticity::test::bottom, .value = [](const auto&) { return Vector3d::Zero(); }}};
        problem.tractions = {{elasticity::test::top, [](const auto&, const auto&) { return Vector3d(1e6, -2e6, 5e6); }}};
        problem.pressures = {{elasticity::test::crack, 4e6}};
        problem.body_force = [unit](const Vector3d& x) -> Vector3d { return Vector3d(0, 1e6, -3e6 * x[2] / unit) / unit; };
        solution = elasticity::solve_equilibrium(problem, tight());
    }
    static elasticity::EquilibriumOptions tight() {
        elasticity::EquilibriumOptions options;
        options.tolerance = 1e-12;
        return options;
    }
    double energy_release(double unit) const {
        const auto growth = [unit](const Vector3d& x) -> Vector3d {
            const Vector3d y = x / unit - Vector3d::Constant(0.5);
            const double share = std::max(0.0, 1 - 4 * y.squaredNorm());
            return share * Vector3d(y[0], y[1], 0) / 0.34;
        };
        return elasticity::energy_release(problem, tight(), solution, {{elasticity::test::crack, growth}}, 1e-4 * unit).front().by_domain_integral;
    }
};

TEST_P(Scale, EquilibriumAndEnergyRelease) {
    const CrackedCube one(1), other(unit());
    EXPECT_LT(difference(times(1 / unit(), other.solution.displacement), one.solution.displacement), same);
    EXPECT_LT(difference(other.solution.fields.stress, one.solution.fields.stress), same);
    EXPECT_LT(difference(other.solution.strain_energy / std::pow(unit(), 3), one.solution.strain_energy), same);
    EXPECT_LT(difference(other.energy_release(unit()) / unit(), one.energy_release(1)), same);
}

TEST_P(Scale, FreeBodyEquilibrium) {
    const auto solved = [](double unit) {
        const mesh::TetMesh mesh = scaled(tagged_block({4, 4, 4}, {1, 1, 1}), unit);
        const particles::Particles particles = particles::from_mesh(mesh);
        const std::map<int, material::Stiffness> stiffness{{0, triclinic()}};
        const contact::ContactLoad load{.point = unit * Vector3d(0.5, 0.5, 0), .force = unit * unit * Vector3d(1e3, 0, 4e4), .radius = 0.3 * unit};
        elasticity::EquilibriumOptions options;
        options.tolerance = 1e-12;
        return contact::contact_equilibrium({.mesh = mesh, .particles = particles, .stiffness = stiffness, .density = {{0, 2500}}}, load, options);
    };
    const auto one = solved(1), other = solved(unit());
    EXPECT_LT(difference(other.fields.stress, one.fields.stress), same);
    EXPECT_LT(difference(times(1 / unit(), other.displacement), one.displacement), same);
    EXPECT_LT(difference(times(unit(), other.acceleration), one.acceleration), same);
}

TEST_P(Scale, HalfSpaceOfContact) {
    const std::vector<Vector3d> places{{0.5, 0.3, 0.7}, {-1.2, 0.4, 0.2}, {0, 0, 0.8}, {2, -1, 3}, {0.9, 0.1, 0.01}, {-30, 50, 20}, {0.3, 0.2, 0}};
    for (const material::Stiffness& stiffness : {material::isotropic(7e10, 0.25), triclinic()})
        for (const double radius : {0.0, 1.3})
            for (const double other_radius : {0.0, 0.8}) {
                if (radius == 0 && other_radius > 0) continue;
                const auto field = [&](double unit) {
                    return contact::half_space_field(stiffness, {.force = unit * unit * Vector3d(3e6, -2e6, 5e6), .radius = unit * radius,
                                                                 .other_radius = unit * other_radius, .axis = Vector3d::UnitX()});
                };
                const auto one = field(1), other = field(unit());
                std::vector<Vector3d> u, scaled_u;
                std::vector<material::Voigt> s, scaled_s;
                for (const Vector3d& x : places) {
                    u.push_back(one.displacement(x)), scaled_u.push_back(other.displacement(unit() * x) / unit());
                    s.push_back(one.stress(x)), scaled_s.push_back(other.stress(unit() * x));
                }
                EXPECT_LT(difference(scaled_u, u), same) << radius << " " << other_radius;
                EXPECT_LT(difference(scaled_s, s), same) << radius << " " << other_radius;
            }
}

TEST_P(Scale, TabulatedHalfSpace) {
    const auto displacement = [](double unit) {
        const contact::HalfSpaceOptions options{.accuracy = 1e-4, .most_directions = 1024, .tabulated = true};
        const auto space = std::make_shared<contact::HalfSpace>(triclinic(), Vector3d::UnitZ(), options);
        const contact::HalfSpaceField field(space, {.force = unit * unit * Vector3d(3e6, -2e6, 5e6), .radius = 0.7 * unit});
        std::vector<Vector3d> values;
        for (const Vector3d& x : {Vector3d(3, 2, 1), Vector3d(-1, 0.4, 2), Vector3d(0.2, 0.1, 0.3)}) values.push_back(field.displacement(unit * x) / unit);
        return values;
    };
    EXPECT_LT(difference(displacement(unit()), displacement(1)), same);
}

TEST_P(Scale, HertzAndImpact) {
    const double u = unit(), modulus = 4e10;
    EXPECT_LT(difference(contact::hertz_contact(20 * u * u, 0.3 * u, modulus).radius / u, contact::hertz_contact(20, 0.3, modulus).radius), same);
    const auto round = contact::hertz_impact(2.5 * u * u * u, 0.3 * u, modulus, 4), one = contact::hertz_impact(2.5, 0.3, modulus, 4);
    EXPECT_LT(difference(round.peak.peak_pressure, one.peak.peak_pressure), same);
    EXPECT_LT(difference(round.duration / u, one.duration), same);
    const auto ellipse = contact::elliptical_contact(20 * u * u, 0.7 * u, 0.3 * u, modulus), of_one = contact::elliptical_contact(20, 0.7, 0.3, modulus);
    EXPECT_LT(difference(ellipse.major / u, of_one.major), same);
    EXPECT_LT(difference(ellipse.peak_pressure, of_one.peak_pressure), same);
}

/// Algorithm 1 under a Hertz contact, all readings.
fracture::CrackAnalysis cracks(double unit, fracture::Grouping grouping, fracture::OuterRadius outer) {
    const mesh::TetMesh mesh = scaled(tagged_block({10, 10, 5}, {1, 1, 0.5}), unit);
    particles::Particles particles = particles::from_mesh(mesh);
    const auto op = elasticity::make_strain_operator("corrected", particles, particles::build_neighbourhood(particles));
    const elasticity::Solid solid = elasticity::uniform_solid(material::isotropic(7e10, 0.22), particles.size());
    const std::vector<fracture::Brittleness> brittleness{fracture::uniform_brittleness(1e4, 800 * unit, solid.stiffness[0])};
    fracture::CrackGenerator generator({particles, op, solid, brittleness, {}, fracture::mean_thickness(mesh), fracture::diameter(particles)});
    const std::map<int, material::Stiffness> stiffness{{0, solid.stiffness[0]}};
    const contact::ContactLoad load{.point = unit * Vector3d(0.47, 0.52, 0), .force = unit * unit * Vector3d(1e6, 0, 6e6), .radius = 0.05 * unit};
    fracture::Options options;
    options.grouping = grouping, options.outer_radius = outer, options.groups = 5, options.energy_limit = 10;
    options.criterion = fracture::Criterion::strain;  // under a contact most groups are pressed, and stretch across
    return generator.generate({load.point, load.inward, load.force, M_PI * load.radius * load.radius},
                              contact::contact_displacement(contact::DisplacementSource::half_space, {mesh, particles, stiffness}, load), options);
}

TEST_P(Scale, CrackEnergies) {
    using fracture::Grouping, fracture::OuterRadius;
    std::size_t compared = 0;
    for (const Grouping grouping : {Grouping::k_means, Grouping::azimuth, Grouping::distance})
        for (const OuterRadius outer : {OuterRadius::proportional, OuterRadius::balance}) {
            const auto one = cracks(1, grouping, outer), other = cracks(unit(), grouping, outer);
            ASSERT_EQ(one.cracks.size(), other.cracks.size());
            compared += one.cracks.size();
            for (std::size_t k = 0; k < one.cracks.size(); ++k) {
                const fracture::Crack &a = one.cracks[k], &b = other.cracks[k];
                EXPECT_EQ(a.members, b.members);
                EXPECT_LT((a.normal - b.normal).norm(), same);
                EXPECT_LT(difference(b.principal, a.principal), same);
                EXPECT_LT(difference(b.energy / std::pow(unit(), 3), a.energy), same);
                EXPECT_LT(difference(b.outer_radius / unit(), a.outer_radius), same);
                EXPECT_LT(difference(b.inner_radius / unit(), a.inner_radius), same);
            }
        }
    EXPECT_GT(compared, 5u);
}

subdivision::Cut scaled_disc(double unit) {
    return {.centre = unit * Vector3d(0.45, 0.55, 0.3), .normal = Vector3d(0.3, -0.2, 1), .radius = 0.37 * unit};
}

TEST_P(Scale, Subdivision) {
    const auto cut = [](double unit) {
        return subdivision::subdivide(scaled(tagged_block({6, 6, 6}, {1, 1, 1}), unit),
                                      {scaled_disc(unit), {.centre = unit * Vector3d(0.5, 0.5, 0.5), .normal = {1, 0.2, 0.3}}});
    };
    const subdivision::Subdivided one = cut(1), other = cut(unit());
    EXPECT_EQ(one.counts, other.counts);
    EXPECT_GT(one.counts.three_one, 0);
    EXPECT_EQ(one.mesh.tets, other.mesh.tets);
    EXPECT_EQ(one.links.opposite, other.links.opposite);
    ASSERT_EQ(one.extra_links.size(), other.extra_links.size());
    std::vector<double> areas, scaled_areas;
    for (const auto& link : one.extra_links) areas.push_back(link.area);
    for (const auto& link : other.extra_links) scaled_areas.push_back(link.area / (unit() * unit()));
    EXPECT_LT(difference(scaled_areas, areas), same);
    EXPECT_LT(difference(times(1 / unit(), other.mesh.vertices), one.mesh.vertices), same);
    EXPECT_LT(difference(times(std::pow(unit(), -3), other.volume), one.volume), same);
    EXPECT_NO_THROW(mesh::check(other.mesh, "children"));
}

TEST_P(Scale, FragmentsAndTheirSurfaces) {
    const auto broken = [](double unit) {
        fragments::FragmentedBody body(scaled(tagged_block({6, 6, 6}, {1, 1, 1}), unit));
        fragments::Crack crack{.disc = scaled_disc(unit), .inner_radius = 0.08 * unit};
        crack.disc.radius = 2 * unit;
        body.crack(crack, 0);
        return body;
    };
    const fragments::FragmentedBody one = broken(1), other = broken(unit());
    const std::vector<int> pieces = one.current_fragments();
    ASSERT_EQ(pieces, other.current_fragments());
    ASSERT_GT(pieces.size(), 2u);
    for (const int piece : pieces) {
        const fragments::Fragment &a = one.fragment(piece), &b = other.fragment(piece);
        ASSERT_EQ(a.particles, b.particles);
        const auto density = [](int) { return 2500.0; };
        const auto mass = fragments::mass_properties(one, a, density), small = fragments::mass_properties(other, b, density);
        EXPECT_LT(difference(small.mass / std::pow(unit(), 3), mass.mass), same);
        EXPECT_LT((small.inertia / std::pow(unit(), 5) - mass.inertia).norm(), same * mass.inertia.norm());
        const fragments::Surface surface = fragments::surface(one, a), small_surface = fragments::surface(other, b);
        EXPECT_EQ(surface.faces.size(), small_surface.faces.size());
        EXPECT_LT(difference(fragments::enclosed_volume(small_surface) / std::pow(unit(), 3), fragments::enclosed_volume(surface)), same);
    }
}

TEST_P(Scale, MeshFiles) {
    const mesh::TetMesh mesh = scaled(tagged_block({3, 3, 3}, {1, 1, 1}), unit());
    EXPECT_NO_THROW(mesh::check(mesh, "block"));
    EXPECT_EQ(mesh::parse_msh(mesh::format_msh(mesh), "block").vertices, mesh.vertices);
}

}  // namespace
}  // namespace cleave::robustness
