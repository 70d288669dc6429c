// The finite element reference on the same odd bodies: every unit, slivers, 10^4 times as long as wide, condition 1e8. Linear fields are in the
// elements' space: exact to rounding, or one line says that the system is singular to rounding.

#include "validation/test/robustness/odd_bodies.hpp"

#include "reference_fem/elasticity.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/msh_file.hpp"

#include <gtest/gtest.h>

namespace cleave::robustness {
namespace {

using elasticity::test::LinearField;
using Eigen::Vector3d;

Vector3d vector(const fem::Point& x) { return {x[0], x[1], x[2]}; }
fem::Point point(const Vector3d& x) { return {x[0], x[1], x[2]}; }

fem::Stiffness plain(const material::Stiffness& c) {
    fem::Stiffness result{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) result[i][j] = c(static_cast<int>(i), static_cast<int>(j));
    return result;
}

/// The linear field by tractions on all sides but the held bottom.
fem::Problem pulled(const mesh::TetMesh& mesh, const material::Stiffness& stiffness, const std::filesystem::path& file, double unit) {
    mesh::write_msh(mesh, file);
    fem::Problem problem;
    problem.mesh_file = file;
    problem.regions = {{.id = mesh.regions.front(), .stiffness = plain(stiffness)}};
    const Eigen::Matrix3d stress = elasticity::test::stress_matrix(stiffness, LinearField{}.gradient);
    for (int side = elasticity::test::left; side <= elasticity::test::top; ++side) {
        if (side == elasticity::test::bottom) {
            problem.displacements.push_back({side, {true, true, true}, [unit](const fem::Point& x) { return point(unit * LinearField{}(vector(x) / unit)); }});
            continue;
        }
        const int axis = (side - 1) / 2, sign = side % 2 == 0 ? 1 : -1;
        problem.tractions.push_back({.surface = side, .value = [force = point(sign * stress.col(axis))](const fem::Point&) { return force; }});
    }
    return problem;
}

/// Largest error of the displacement and of the stress over the largest of each; infinite where something is not a number. Empty: one line.
std::optional<std::array<double, 2>> errors(const mesh::TetMesh& mesh, const material::Stiffness& stiffness, int degree, double unit = 1) {
    const ScratchFolder folder;
    const Eigen::Matrix3d stress = elasticity::test::stress_matrix(stiffness, LinearField{}.gradient);
    std::vector<Vector3d> u, exact_u;
    std::vector<Eigen::Matrix3d> s, exact_s;
    try {
        for (const fem::FieldSample& sample : fem::solve(pulled(mesh, stiffness, folder / "body.msh", unit), {.degree = degree}).quadrature_samples(2)) {
            u.push_back(vector(sample.displacement) / unit);
            exact_u.push_back(LinearField{}(vector(sample.position) / unit));
            s.push_back(material::stress_from_voigt(Eigen::Map<const material::Voigt>(sample.stress.data())));
            exact_s.push_back(stress);
        }
    } catch (const fem::Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        std::printf("degree %d: %s\n", degree, error.what());
        return std::nullopt;
    }
    return std::array{difference(u, exact_u), difference(s, exact_s)};
}

/// `most`: of displacement and stress.
void expect_exact(const char* what, const mesh::TetMesh& mesh, const material::Stiffness& stiffness, const std::array<double, 2>& most, double unit = 1) {
    for (const int degree : {1, 2}) {
        const auto found = errors(mesh, stiffness, degree, unit);
        if (!found) continue;
        std::printf("%s, degree %d: displacement %.1e, stress %.1e\n", what, degree, (*found)[0], (*found)[1]);
        EXPECT_LT((*found)[0], most[0]) << what << " " << degree;
        EXPECT_LT((*found)[1], most[1]) << what << " " << degree;
    }
}

TEST(OddFem, EveryUnit) {
    for (const double unit : {1e-9, 1e-6, 1e-3, 1.0, 1e3})
        expect_exact("unit", scaled(tagged_block({4, 3, 3}, {1, 0.8, 0.6}), unit), elasticity::test::triclinic(), {1e-9, 1e-9}, unit);
}

/// A bent cube: not in the elements' space, so that the answers are those of a solve and not of an interpolation.
TEST(OddFem, BendingInEveryUnit) {
    const auto solved = [](double unit) {
        const ScratchFolder folder;
        const mesh::TetMesh mesh = scaled(tagged_block({4, 3, 3}, {1, 0.8, 0.6}), unit);
        fem::Problem problem = pulled(mesh, elasticity::test::triclinic(), folder / "body.msh", unit);
        problem.tractions = {{.surface = elasticity::test::top, .value = [unit](const fem::Point& x) { return fem::Point{1e6 * x[0] / unit, 2e6, -1e6}; }}};
        problem.pressures = {{elasticity::test::right, 3e6}};
        problem.body_force = [unit](const fem::Point& x) { return fem::Point{1e6 / unit, 0, -2e6 * x[1] / unit / unit}; };
        return fem::solve(problem);
    };
    const fem::Solution one = solved(1);
    std::vector<Vector3d> u;
    for (const fem::Point& x : one.vertex_displacements()) u.push_back(vector(x));
    for (const double unit : {1e-9, 1e-6, 1e-3, 1e3}) {
        const fem::Solution other = solved(unit);
        std::vector<Vector3d> scaled_u;
        for (const fem::Point& x : other.vertex_displacements()) scaled_u.push_back(vector(x) / unit);
        EXPECT_LT(difference(scaled_u, u), 1e-9) << unit;
        EXPECT_LT(difference(other.energy() / std::pow(unit, 3), one.energy()), 1e-9) << unit;
        EXPECT_LT(difference(other.estimated_error(), one.estimated_error()), 1e-9) << unit;
        const auto here = one.recovered_at({{0.31, 0.42, 0.23}}).front().stress, there = other.recovered_at({{0.31 * unit, 0.42 * unit, 0.23 * unit}}).front().stress;
        EXPECT_LT(difference(std::vector(there.begin(), there.end()), std::vector(here.begin(), here.end())), 1e-9) << unit;
    }
}

/// The stiffness matrix has the condition of the slivers' heights, 1e6, times the mesh's.
TEST(OddFem, Slivers) {
    const mesh::TetMesh mesh = sliver_cube(4, 1e-6);
    EXPECT_LT(smallest_dihedral_angle(mesh), 2e-6);
    expect_exact("slivers", mesh, elasticity::test::triclinic(), {1e-7, 1e-5});
}

TEST(OddFem, TenThousandTimesAsLongAsWide) {
    expect_exact("plate", tagged_block({10, 10, 2}, {1, 1, 1e-4}), elasticity::test::triclinic(), {1e-6, 1e-4});
    expect_exact("rod", tagged_block({60, 2, 2}, {1, 1e-4, 1e-4}), elasticity::test::triclinic(), {1e-6, 1e-4});
}

TEST(OddFem, ConditionOfTheStiffness) {
    for (const unsigned seed : {5u, 6u}) expect_exact("condition 1e8", elasticity::test::tagged_cube(3), ill_conditioned(1e11, 1e8, seed), {1e-6, 1e-6});
}

TEST(OddFem, TwinAWrongTractionIsSeen) {
    const mesh::TetMesh mesh = elasticity::test::tagged_cube(3);
    const ScratchFolder folder;
    fem::Problem problem = pulled(mesh, elasticity::test::triclinic(), folder / "body.msh", 1);
    problem.tractions.pop_back();
    double most = 0;
    for (const fem::FieldSample& sample : fem::solve(problem).quadrature_samples(1))
        most = std::max(most, (vector(sample.displacement) - LinearField{}(vector(sample.position))).norm());
    EXPECT_GT(most, 1e-5);
}

}  // namespace
}  // namespace cleave::robustness
