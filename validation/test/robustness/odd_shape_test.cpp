// Slivers (dihedral angles of 1e-6), bodies 10^4 times as long as wide, stiffnesses of condition 1e8: against mathematics. A linear field is
// exact in every discretisation, so that whatever a linear field loses is rounding; the bounds say how much of it there may be.

#include "validation/test/robustness/odd_bodies.hpp"

#include "solver/contact/contact_displacement.hpp"
#include "solver/contact/indentation.hpp"
#include "solver/elasticity/strain_pass.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/fragments/fragmented_body.hpp"
#include "solver/fragments/surface.hpp"
#include "solver/mesh/check.hpp"
#include "solver/particles/wpca.hpp"
#include "solver/subdivision/links.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "validation/analytic/half_space_fourier.hpp"

#include <gtest/gtest.h>

namespace cleave::robustness {
namespace {

using elasticity::test::LinearField;
using elasticity::test::triclinic;
using Eigen::Vector3d;

constexpr double sliver_height = 1e-6;
mesh::TetMesh slivers() { return sliver_cube(6, sliver_height); }

TEST(Slivers, AreThere) {
    const mesh::TetMesh mesh = slivers();
    EXPECT_LT(smallest_dihedral_angle(mesh), 2 * sliver_height);
    EXPECT_GT(smallest_dihedral_angle(mesh), 0.1 * sliver_height);
    EXPECT_NO_THROW(mesh::check(mesh, "slivers"));
    EXPECT_NEAR(mesh::total_volume(mesh), 1, 1e-13);  // a sum of 1,296
}

/// Largest error of the strain of a linear field, relative, and what the operator had to say.
struct LinearError {
    double largest = 0;
    elasticity::OperatorReport report;
};
LinearError linear_error(const mesh::TetMesh& mesh, const std::string& name, bool wpca, double length) {
    particles::Particles particles = particles::from_mesh(mesh);
    if (wpca) particles::apply_wpca(particles);
    const std::map<int, material::Stiffness> stiffness{{mesh.regions.front(), triclinic()}};
    elasticity::StrainOperator op;
    if (name == "conforming") {
        op = elasticity::conforming_operator(elasticity::make_conforming_body(mesh, particles, stiffness));
    } else {
        op = elasticity::make_strain_operator(name, particles, particles::build_neighbourhood(particles));
    }
    LinearField field;
    field.offset *= length;
    std::vector<Vector3d> displacement;
    for (const Vector3d& x : particles.position) displacement.push_back(field(x));
    LinearError error{0, op.report};
    for (const Eigen::Matrix3d& gradient : elasticity::displacement_gradients(op, displacement)) {
        const double apart = (gradient - field.gradient).norm() / field.gradient.norm();
        error.largest = std::max(error.largest, std::isfinite(apart) ? apart : INFINITY);
    }
    return error;
}

/// Rounding of u over a neighbourhood: 1e-13. `conforming` divides by the height of a tet: 1e-16 of the displacement over 1e-6 of the width.
TEST(Slivers, LinearFieldsAreExact) {
    for (const bool wpca : {false, true}) {
        for (const std::string name : {"corrected", "quadratic"}) {
            const LinearError error = linear_error(slivers(), name, wpca, 1);
            EXPECT_LT(error.largest, 1e-10) << name;
            EXPECT_EQ(error.report.fallbacks, 0) << name;
        }
        EXPECT_LT(linear_error(slivers(), "conforming", wpca, 1).largest, 1e-7);
    }
    EXPECT_GT(linear_error(slivers(), "paper", false, 1).largest, 0.1) << "twin: the printed operator is not exact";
}

elasticity::EquilibriumProblem pulled(const mesh::TetMesh& mesh, const material::Stiffness& stiffness) {
    elasticity::EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{mesh.regions.front(), stiffness}};
    const Eigen::Matrix3d stress = elasticity::test::stress_matrix(stiffness, LinearField{}.gradient);
    for (int side = elasticity::test::left; side <= elasticity::test::top; ++side) {
        if (side == elasticity::test::bottom) problem.displacements.push_back({.surface = side, .value = LinearField{}});
        else problem.tractions.push_back({side, [stress](const auto&, const Vector3d& n) -> Vector3d { return stress * n; }});
    }
    return problem;
}

/// The right displacement, or one line that says why there is none; returns the relative error, or -1 for the line.
double solved_error(const mesh::TetMesh& mesh, const material::Stiffness& stiffness) {
    elasticity::EquilibriumOptions options;
    options.tolerance = 1e-12;
    options.max_iterations = 3000;
    try {
        const double error = elasticity::test::worst_displacement(elasticity::solve_equilibrium(pulled(mesh, stiffness), options), LinearField{});
        return std::isfinite(error) ? error : INFINITY;
    } catch (const elasticity::NotConverged& error) {
        EXPECT_NE(std::string(error.what()).find("residual"), std::string::npos) << error.what();
        return -1;
    }
}

/// Traces beside a sliver of height 1e-2 still solve; of 1e-6, where stiffnesses differ by 10^12, the iteration says that it does not converge.
TEST(Slivers, EquilibriumIsExactOrToldNotToConverge) {
    const double mild = solved_error(sliver_cube(3, 1e-2), triclinic());
    EXPECT_LT(mild, 1e-7);
    EXPECT_GE(mild, 0) << "converges";
    EXPECT_LT(solved_error(sliver_cube(3, sliver_height), triclinic()), 1e-7);
}

/// Cuts through the slivers: every child positive, the sums those of the parents.
TEST(Slivers, CutsConserveVolume) {
    const mesh::TetMesh mesh = slivers();
    const std::vector<subdivision::Cut> cuts{{.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.2, 0.3}},
                                             {.centre = {0.5, 0.51, 0.47}, .normal = {-0.3, 1, 0.1}, .radius = 0.3},
                                             {.centre = {0.4, 0.5, 0.52}, .normal = {0.1, 0.2, 1}}};
    const subdivision::Subdivided out = subdivision::subdivide(mesh, cuts);
    EXPECT_GT(out.counts.three_one + out.counts.two_two, 500);
    const subdivision::Audit found = subdivision::audit(mesh, out);
    EXPECT_LE(found.volume_error, 1e-14);
    EXPECT_LE(found.stated_volume_error, 1e-14);
    EXPECT_GT(found.smallest_share, 0);
    EXPECT_GT(*std::min_element(out.volume.begin(), out.volume.end()), 0);
    EXPECT_EQ(found.unpaired + found.asymmetric + found.paired_boundary, 0);
}

TEST(Slivers, FragmentsCloseAroundTheirVolume) {
    fragments::FragmentedBody body(slivers());
    body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.2, 0.3}}}, 0);
    const std::vector<int> pieces = body.current_fragments();
    ASSERT_GE(pieces.size(), 2u);
    double total = 0;
    for (const int piece : pieces) {
        double volume = 0;
        for (const int particle : body.fragment(piece).particles) volume += body.volume(particle);
        EXPECT_NEAR(fragments::enclosed_volume(fragments::surface(body, body.fragment(piece))), volume, 1e-10);
        total += volume;
    }
    EXPECT_NEAR(total, 1, 1e-13);
}

/// A plate, a rod, both 10^4 times as long as thin, of stretched cells.
const std::map<std::string, std::pair<std::array<int, 3>, Vector3d>> long_bodies{
    {"plate", {{12, 12, 2}, {1, 1, 1e-4}}}, {"rod", {{60, 2, 2}, {1, 1e-4, 1e-4}}}, {"plate_of_thin_cells", {{6, 6, 6}, {1, 1, 1e-4}}}};

class LongBody : public testing::TestWithParam<std::string> {
protected:
    mesh::TetMesh mesh() const {
        const auto& [cells, extent] = long_bodies.at(GetParam());
        return tagged_block(cells, extent);
    }
};
INSTANTIATE_TEST_SUITE_P(Shapes, LongBody, testing::Values("plate", "rod", "plate_of_thin_cells"), [](const auto& info) { return info.param; });

/// An operator that cannot span the three directions says so (fallbacks, poor supports); without a word it must be exact. The displacement
/// across a plate is 1e-4 of that along it, and loses as many digits.
TEST_P(LongBody, LinearFieldsAreExactOrReported) {
    for (const std::string name : {"corrected", "quadratic", "conforming"})
        for (const bool wpca : {false, true}) {
            const LinearError error = linear_error(mesh(), name, wpca, 1);
            RecordProperty(name + (wpca ? "_wpca" : ""), std::to_string(error.largest));
            RecordProperty(name + (wpca ? "_wpca" : "") + "_fallbacks", error.report.fallbacks);
            if (name != "conforming" && error.report.fallbacks > 0) continue;
            EXPECT_LT(error.largest, 1e-7) << name << (wpca ? ", WPCA" : "");
        }
}

TEST_P(LongBody, CutsConserveVolume) {
    const Vector3d extent = long_bodies.at(GetParam()).second;
    const mesh::TetMesh body = mesh();
    const subdivision::Subdivided out =
        subdivision::subdivide(body, {{.centre = 0.51 * extent, .normal = {1, 0.3, 0.2}}, {.centre = 0.47 * extent, .normal = {1e-4, 2e-4, 1}}});
    EXPECT_GT(out.counts.three_one + out.counts.two_two, 10);
    const subdivision::Audit found = subdivision::audit(body, out);
    EXPECT_LE(found.volume_error, 1e-14);
    EXPECT_GT(found.smallest_share, 0);
    EXPECT_EQ(found.unpaired + found.asymmetric + found.paired_boundary, 0);
}

TEST_P(LongBody, EquilibriumIsExactOrToldNotToConverge) {
    const double error = solved_error(mesh(), triclinic());
    RecordProperty("error", std::to_string(error));
    EXPECT_LT(error, 1e-6);
}

constexpr double condition = 1e8;

TEST(StiffAndSoft, ConditionIsAsAsked) {
    const material::Voigt moduli = material::kelvin_moduli(ill_conditioned(1e11, condition, 5));
    EXPECT_NEAR(moduli[5] / 1e11, 1, 1e-12);
    EXPECT_NEAR(moduli[0] / 1e3, 1, 1e-6) << "rounding of 1e-16 times the condition";
}

TEST(StiffAndSoft, ComplianceInverts) {
    const material::Stiffness c = ill_conditioned(1e11, condition, 5);
    // 1e-16 times the condition.
    EXPECT_LT((material::compliance(c) * c - material::Stiffness::Identity()).norm(), 1e-6);
}

TEST(StiffAndSoft, EquilibriumIsExactOrToldNotToConverge) {
    for (const unsigned seed : {5u, 6u}) {
        const double error = solved_error(elasticity::test::tagged_cube(4), ill_conditioned(1e11, condition, seed));
        RecordProperty("error_" + std::to_string(seed), std::to_string(error));
        EXPECT_LT(error, 1e-3);
    }
}

/// Five constants of a transversely isotropic solid, the axis along z; shear along the axis 10^8 times softer.
material::Stiffness soft_in_shear() {
    material::Stiffness c = material::isotropic(1e11, 0.25);
    c(3, 3) = c(4, 4) = 1e3;
    return material::checked_stiffness(c);
}

/// physics.md, 6: M = 2 sqrt{[(C11 C33 - C13^2)/C11] / [1/C44 + 2/(sqrt(C11 C33) + C13)]}.
TEST(StiffAndSoft, IndentationModulusIsThatOfTransverseIsotropy) {
    const material::Stiffness c = soft_in_shear();
    const double closed = 2 * std::sqrt((c(0, 0) * c(2, 2) - c(0, 2) * c(0, 2)) / c(0, 0) / (1 / c(3, 3) + 2 / (std::sqrt(c(0, 0) * c(2, 2)) + c(0, 2))));
    EXPECT_NEAR(contact::indentation_modulus(c, Vector3d::UnitZ()) / closed, 1, 1e-6);
}

analytic::Stiffness plain(const material::Stiffness& c) {
    analytic::Stiffness result{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) result[i][j] = c(static_cast<int>(i), static_cast<int>(j));
    return result;
}

/// Against the surface impedance of Barnett and Lothe, which solves no eigenvalue problem: another way through the same half-space. Its own
/// integrals stop converging beyond a condition of some 10^4.
TEST(StiffAndSoft, HalfSpaceEqualsItsFourierTransform) {
    const material::Stiffness c = ill_conditioned(1e11, 1e3, 5);
    const contact::HalfSpace space(c, Vector3d::UnitZ());
    const analytic::FourierHalfSpace fourier(plain(c));
    for (const double phi : {0.1, 0.9, 2.2}) EXPECT_NEAR(contact::surface_compliance(space, phi) / fourier.surface_compliance(phi), 1, 1e-8) << phi;
}

/// All but incompressible: bulk over shear modulus 10^8. The closed form against Stroh's, whose roots are all but equal.
TEST(StiffAndSoft, IncompressibleHalfSpaceBothWays) {
    const double bulk = 1e11, shear = 1e3, lambda = bulk - 2 * shear / 3;
    material::Stiffness c = material::Stiffness::Zero();
    c.topLeftCorner<3, 3>().setConstant(lambda);
    c.diagonal() << lambda + 2 * shear, lambda + 2 * shear, lambda + 2 * shear, shear, shear, shear;
    const contact::ContactLoad load{.force = {2, -1, 5}, .radius = 0.7};
    const auto closed = contact::half_space_field(c, load, {.form = contact::HalfSpaceForm::closed});
    const auto stroh = contact::half_space_field(c, load, {.form = contact::HalfSpaceForm::stroh});
    for (const Vector3d& x : {Vector3d(0.5, 0.3, 0.7), Vector3d(-1.2, 0.4, 0.6), Vector3d(2, -1, 3)}) {
        const Vector3d u = closed.displacement(x), v = stroh.displacement(x);
        EXPECT_LT((u - v).norm(), 1e-3 * u.norm()) << x.transpose();
    }
}

}  // namespace
}  // namespace cleave::robustness
