// The numbers that vertices and tets happen to have mean nothing. Sums run in the order of the numbers, so results differ by rounding: some
// hundred terms of 1e-16, times the condition of a neighbourhood (up to 1e3): 1e-10 is the bound, seen are 1e-13 to 1e-12. What is chosen
// (who is in a group, which plane cracks) must not differ at all: equal distances are settled by places, never by numbers.

#include "validation/test/robustness/odd_bodies.hpp"

#include "solver/contact/contact_displacement.hpp"
#include "solver/elasticity/strain_pass.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/material/test/test_materials.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/particles/wpca.hpp"

#include <gtest/gtest.h>

namespace cleave::robustness {
namespace {

using elasticity::test::triclinic;
using Eigen::Vector3d;

constexpr double same = 1e-10;

/// An irregular block, and one of equal cells, where many distances are equal but for rounding: tenths are no doubles.
mesh::TetMesh irregular() { return tagged_block({9, 8, 5}, {0.9, 0.8, 0.5}); }
mesh::TetMesh regular() {
    mesh::TetMesh mesh = mesh::test::kuhn_cube(10);
    elasticity::test::tag_boundary(mesh);
    for (int& region : mesh.regions) region = 0;
    return mesh;
}

/// Particles with their operator, everything by the numbers of one mesh.
struct Body {
    mesh::TetMesh mesh;
    particles::Particles particles;
    particles::Neighbourhood neighbourhood;
    elasticity::StrainOperator op;
    elasticity::Solid solid;
    std::map<int, material::Stiffness> stiffness;

    Body(mesh::TetMesh of, const std::string& name, const material::Stiffness& c, bool wpca)
        : mesh(std::move(of)), particles(particles::from_mesh(mesh)), stiffness{{0, c}} {
        if (wpca) particles::apply_wpca(particles);
        solid = elasticity::uniform_solid(c, particles.size());
        if (name == "conforming") {
            op = elasticity::conforming_operator(elasticity::make_conforming_body(mesh, particles, stiffness));
            return;
        }
        neighbourhood = particles::build_neighbourhood(particles);
        op = elasticity::make_strain_operator(name, particles, neighbourhood);
    }
    std::vector<Vector3d> wavy() const {
        std::vector<Vector3d> u;
        for (const Vector3d& x : particles.position)
            u.push_back(1e-3 * Vector3d(std::sin(2 * x[0] + x[1]), x[0] * x[1] - x[2] * x[2], std::cos(x[1] - 1.5 * x[2]) + x[0]));
        return u;
    }
};

void expect_same_fields(const elasticity::Fields& one, const elasticity::Fields& other, const std::vector<int>& tet) {
    EXPECT_LT(difference(picked(other.gradient, tet), one.gradient), same);
    EXPECT_LT(difference(picked(other.strain, tet), one.strain), same);
    EXPECT_LT(difference(picked(other.stress, tet), one.stress), same);
    EXPECT_LT(difference(picked(other.energy, tet), one.energy), same);
    EXPECT_LT(difference(other.total_energy(), one.total_energy()), same);
}

TEST(Renumbered, StrainsStressesAndEnergies) {
    for (const mesh::TetMesh& mesh : {irregular(), regular()})
        for (const std::string name : {"paper", "corrected", "quadratic", "conforming"})
            for (const bool wpca : {false, true}) {
                SCOPED_TRACE(name + (wpca ? ", WPCA" : ""));
                const Renumbered numbers = renumbered(mesh, 7);
                const Body one(mesh, name, triclinic(), wpca), other(numbers.mesh, name, triclinic(), wpca);
                expect_same_fields(elasticity::evaluate(one.op, one.particles, one.solid, one.wavy()),
                                   elasticity::evaluate(other.op, other.particles, other.solid, other.wavy()), numbers.tet);
            }
}

TEST(Renumbered, TheFastStrainPass) {
    const mesh::TetMesh mesh = irregular();
    const Renumbered numbers = renumbered(mesh, 8);
    const Body one(mesh, "corrected", triclinic(), true), other(numbers.mesh, "corrected", triclinic(), true);
    elasticity::Fields fields, of_other;
    elasticity::StrainPass(one.particles, one.neighbourhood.lists, one.solid).evaluate(one.wavy(), fields);
    elasticity::StrainPass(other.particles, other.neighbourhood.lists, other.solid).evaluate(other.wavy(), of_other);
    expect_same_fields(fields, of_other, numbers.tet);
}

/// Conjugate gradients to 1e-13 of the load, condition 1e3 after the preconditioner: displacements to about 1e-11.
TEST(Renumbered, Equilibrium) {
    const mesh::TetMesh mesh = elasticity::test::cracked_cube(6, 0.34);
    const Renumbered numbers = renumbered(mesh, 9);
    const auto solved = [](const mesh::TetMesh& of) {
        elasticity::EquilibriumProblem problem{.mesh = of};
        problem.stiffness = {{0, triclinic()}};
        problem.displacements = {{.surface = elasticity::test::bottom, .value = [](const auto&) { return Vector3d::Zero(); }}};
        problem.tractions = {{elasticity::test::top, [](const auto&, const auto&) { return Vector3d(1e6, -2e6, 5e6); }}};
        problem.pressures = {{elasticity::test::crack, 4e6}};
        elasticity::EquilibriumOptions options;
        options.tolerance = 1e-13;
        return elasticity::solve_equilibrium(problem, options);
    };
    const auto one = solved(mesh), other = solved(numbers.mesh);
    EXPECT_LT(difference(picked(other.displacement, numbers.tet), one.displacement), same);
    expect_same_fields(one.fields, other.fields, numbers.tet);
    EXPECT_LT(difference(other.external_work, one.external_work), same);
}

/// One contact: its cracks in all readings.
struct Hit {
    fracture::Grouping grouping = fracture::Grouping::k_means;
    fracture::Criterion criterion = fracture::Criterion::stress;
    fracture::OuterRadius outer = fracture::OuterRadius::proportional;
    int groups = 5;
};

fracture::CrackAnalysis cracks(const Body& body, const contact::ContactLoad& load, const Hit& hit) {
    const std::vector<fracture::Brittleness> brittleness{fracture::uniform_brittleness(1e4, 800, body.solid.stiffness[0])};
    fracture::CrackGenerator generator(
        {body.particles, body.op, body.solid, brittleness, {}, fracture::mean_thickness(body.mesh), fracture::diameter(body.particles)});
    fracture::Options options;
    options.grouping = hit.grouping, options.outer_radius = hit.outer, options.groups = hit.groups;
    options.criterion = hit.criterion, options.energy_limit = 10;
    const Vector3d along = load.force - load.force.dot(load.inward) * load.inward;
    return generator.generate({load.point, load.inward, along, M_PI * load.radius * load.radius},
                              contact::contact_displacement(contact::DisplacementSource::half_space, {body.mesh, body.particles, body.stiffness}, load),
                              options);
}

std::vector<int> renamed(const std::vector<int>& members, const std::vector<int>& tet) {
    std::vector<int> names = picked(tet, members);
    std::sort(names.begin(), names.end());
    return names;
}

void expect_same_cracks(const fracture::CrackAnalysis& one, const fracture::CrackAnalysis& other, const std::vector<int>& tet) {
    ASSERT_EQ(one.points.size(), other.points.size());
    for (std::size_t p = 0; p < one.points.size(); ++p) {
        const fracture::PointAnalysis &a = one.points[p], &b = other.points[p];
        EXPECT_EQ(tet[static_cast<std::size_t>(a.nearest)], b.nearest);
        EXPECT_EQ(a.undefined, b.undefined);
        ASSERT_EQ(a.groups.size(), b.groups.size());
        for (std::size_t g = 0; g < a.groups.size(); ++g) {
            ASSERT_EQ(renamed(a.groups[g].members, tet), b.groups[g].members) << "group " << g;
            EXPECT_LT((a.groups[g].stress - b.groups[g].stress).norm(), same * a.groups[g].stress.norm());
            EXPECT_LT(difference(b.groups[g].energy, a.groups[g].energy), same);
        }
    }
    ASSERT_EQ(one.cracks.size(), other.cracks.size());
    for (std::size_t k = 0; k < one.cracks.size(); ++k) {
        const fracture::Crack &a = one.cracks[k], &b = other.cracks[k];
        EXPECT_EQ(a.group, b.group);
        EXPECT_EQ(a.centre, b.centre);
        EXPECT_LT((a.normal - b.normal).norm(), same / a.gap) << "a direction moves by the change over the gap of the principal values";
        EXPECT_LT(difference(b.principal, a.principal), same);
        EXPECT_LT(difference(b.energy, a.energy), same);
        EXPECT_LT(difference(b.outer_radius, a.outer_radius), same);
        EXPECT_LT(difference(b.inner_radius, a.inner_radius), same);
    }
}

/// Every reading of one contact, under several renumberings; returns the number of cracks compared.
std::size_t compare_contacts(const mesh::TetMesh& mesh, const Vector3d& point, const material::Stiffness& stiffness, bool wpca) {
    using fracture::Criterion, fracture::Grouping, fracture::OuterRadius;
    const contact::ContactLoad load{.point = point, .force = Vector3d(1e6, 0, 6e6), .radius = 0.05};
    const Body one(mesh, "corrected", stiffness, wpca);
    std::size_t compared = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Renumbered numbers = renumbered(mesh, seed);
        const Body other(numbers.mesh, "corrected", stiffness, wpca);
        for (const Grouping grouping : {Grouping::k_means, Grouping::azimuth, Grouping::distance})
            for (const Criterion criterion : {Criterion::stress, Criterion::strain})
                for (const OuterRadius outer : {OuterRadius::proportional, OuterRadius::balance})
                    for (const int groups : {2, 5}) {
                        SCOPED_TRACE(testing::Message() << "seed " << seed << ", grouping " << static_cast<int>(grouping) << ", " << groups << " groups");
                        const Hit hit{grouping, criterion, outer, groups};
                        const auto found = cracks(one, load, hit);
                        compared += found.cracks.size();
                        expect_same_cracks(found, cracks(other, load, hit), numbers.tet);
                        if (testing::Test::HasFailure()) return compared;
                    }
    }
    return compared;
}

TEST(Renumbered, CracksOfOneContact) {
    EXPECT_GT(compare_contacts(irregular(), {0.44, 0.37, 0}, material::isotropic(7e10, 0.22), false), 100u);
    EXPECT_GT(compare_contacts(irregular(), {0.44, 0.37, 0}, triclinic(), true), 100u);
}

/// A lattice hit at one of its vertices: distances, heights and azimuths come in equal pairs.
TEST(Renumbered, CracksWhereDistancesAreEqual) {
    EXPECT_GT(compare_contacts(regular(), {0.5, 0.5, 0}, material::isotropic(7e10, 0.22), false), 100u);
    EXPECT_GT(compare_contacts(regular(), {0.5, 0.5, 0}, triclinic(), true), 100u);
}

TEST(RenumberedTwin, NumbersReallyChangeAndAChangedBodyIsSeen) {
    mesh::TetMesh mesh = irregular();
    const Renumbered numbers = renumbered(mesh, 7);
    EXPECT_NE(numbers.mesh.tets, mesh.tets);
    const Body one(mesh, "corrected", triclinic(), false);
    mesh.vertices[mesh.vertices.size() / 2] += Vector3d(1e-8, 0, 0);
    const Body moved(mesh, "corrected", triclinic(), false);
    const auto gradient = [](const Body& body) { return elasticity::evaluate(body.op, body.particles, body.solid, body.wavy()).gradient; };
    EXPECT_GT(difference(gradient(moved), gradient(one)), same);
}

}  // namespace
}  // namespace cleave::robustness
