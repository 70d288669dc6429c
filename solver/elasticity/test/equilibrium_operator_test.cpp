// The stiffness as a linear map: symmetry, definiteness, rigid motions, and its two forms against each other.
#include "solver/elasticity/equilibrium_assembly.hpp"
#include "solver/elasticity/equilibrium_cg.hpp"
#include "solver/elasticity/equilibrium_coarse.hpp"
#include "solver/elasticity/equilibrium_operator.hpp"
#include "solver/elasticity/test/equilibrium_bodies.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace cleave::elasticity::test {
namespace {

/// Two materials, a crack and prescribed faces: every term of the energy.
struct FullBody {
    mesh::TetMesh mesh = cracked_cube(4, 0.3);
    ConformingBody body;

    FullBody() {
        for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
            mesh.regions[tet] = mesh::tet_centroid(mesh, static_cast<int>(tet)).x() < 0.5 ? 1 : 2;
        body = make_conforming_body(mesh, {{1, triclinic(5)}, {2, triclinic(8)}});
    }

    std::vector<PrescribedFace> prescribed() const {
        std::vector<PrescribedFace> list;
        for (int f = 0; f < body.faces.size(); ++f) {
            const Face& face = body.faces.faces[f];
            if (!face.is_boundary()) continue;
            if (side_of(face.centroid) == bottom) list.push_back({f, Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero()});
            if (side_of(face.centroid) == left) list.push_back({f, {1, 0, 1}, Eigen::Vector3d::Zero()});
        }
        return list;
    }
};

Vectors times(const QuadraticEnergy& energy, const Vectors& u) {
    StiffnessOperator stiffness(energy);
    Vectors force;
    stiffness.apply(u, force);
    return force;
}

Eigen::VectorXd flat(const Vectors& v) {
    return Eigen::Map<const Eigen::VectorXd>(v.front().data(), 3 * static_cast<Eigen::Index>(v.size()));
}

TEST(CoarseSpace, matrix_is_the_projection_of_the_assembled_stiffness) {
    const FullBody full;
    const QuadraticEnergy energy = make_energy(full.body, 2, full.prescribed());
    const CoarseSpace space(energy, gradient_stencils(full.body), 40);
    const int particles = full.body.particles.size(), lumps = space.lumps();
    EXPECT_GE(lumps * 40, particles);
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(3 * particles, 6 * lumps);
    for (int i = 0; i < particles; ++i) z.block<3, 6>(3 * i, 6 * space.lump_of(i)) = space.motion(i);
    const Eigen::MatrixXd projected = z.transpose() * (assemble_stiffness(energy) * z);
    const Eigen::MatrixXd matrix = Eigen::MatrixXd(space.matrix()).selfadjointView<Eigen::Lower>();
    EXPECT_LT((matrix - projected).norm(), 1e-12 * projected.norm());
    // The correction solves the projected problem: what it leaves has nothing in the space (but for the shift of the diagonal, 1e-8).
    const Vectors r = random_vectors(particles, 3);
    Vectors correction(r.size(), Eigen::Vector3d::Zero());
    space.add_correction(r, correction);
    const Eigen::VectorXd rest = z.transpose() * (flat(r) - assemble_stiffness(energy) * flat(correction));
    EXPECT_LT(rest.norm(), 1e-5 * (z.transpose() * flat(r)).norm());
}

TEST(CoarseSpace, spares_iterations) {
    const ConformingBody body = make_conforming_body(tagged_cube(8), {{0, triclinic()}});
    std::vector<PrescribedFace> prescribed;
    for (int f = 0; f < body.faces.size(); ++f)
        if (body.faces.faces[f].is_boundary() && side_of(body.faces.faces[f].centroid) == bottom)
            prescribed.push_back({f, Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero()});
    const QuadraticEnergy energy = make_energy(body, 2, prescribed);
    const GradientStencils stencils = gradient_stencils(body);
    const std::vector<Eigen::Matrix3d> blocks = diagonal_blocks(energy, stencils);
    const CoarseSpace space(energy, stencils, 50);
    StiffnessOperator stiffness(energy);
    const auto iterations = [&](bool two_levels) {
        const LinearSystem system{[&](const Vectors& u, Vectors& f) { stiffness.apply(u, f); },
                                  [&](const Vectors& r, Vectors& z) {
                                      for (std::size_t i = 0; i < r.size(); ++i) z[i] = blocks[i].ldlt().solve(r[i]);
                                      if (two_levels) space.add_correction(r, z);
                                  }};
        Vectors u(body.particles.size(), Eigen::Vector3d::Zero());
        return conjugate_gradients(system, Vectors(u.size(), Eigen::Vector3d(0, 0, 1)), u, 1e-8, 5000).iterations;
    };
    const int one = iterations(false), two = iterations(true);
    printf("  iterations: %d with the block diagonal, %d with lumps beside it\n", one, two);
    EXPECT_LT(2 * two, one);
}

TEST(Stiffness, is_symmetric) {
    const FullBody full;
    const QuadraticEnergy energy = make_energy(full.body, 2, full.prescribed());
    const Vectors u = random_vectors(full.body.particles.size(), 1), v = random_vectors(full.body.particles.size(), 2);
    const Vectors ku = times(energy, u), kv = times(energy, v);
    EXPECT_NEAR(dot(v, ku) / std::sqrt(dot(ku, ku) * dot(v, v)), dot(u, kv) / std::sqrt(dot(ku, ku) * dot(v, v)), 1e-13);
}

TEST(Stiffness, matrix_free_form_equals_the_assembled_one) {
    const FullBody full;
    const QuadraticEnergy energy = make_energy(full.body, 2, full.prescribed());
    const Vectors u = random_vectors(full.body.particles.size(), 1);
    const Eigen::VectorXd assembled = assemble_stiffness(energy) * flat(u);
    EXPECT_LT((flat(times(energy, u)) - assembled).norm(), 1e-13 * assembled.norm());
}

TEST(Stiffness, diagonal_blocks_are_those_of_the_assembled_form) {
    const FullBody full;
    const QuadraticEnergy energy = make_energy(full.body, 2, full.prescribed());
    const Eigen::SparseMatrix<double> assembled = assemble_stiffness(energy);
    const std::vector<Eigen::Matrix3d> blocks = diagonal_blocks(energy, gradient_stencils(full.body));
    for (int i = 0; i < full.body.particles.size(); ++i) {
        const Eigen::Matrix3d block = assembled.block(3 * i, 3 * i, 3, 3);
        EXPECT_LT((blocks[i] - block).norm(), 1e-12 * block.norm());
    }
}

/// Eigenvalues of the assembled K, ascending.
Eigen::VectorXd spectrum(const QuadraticEnergy& energy) {
    const Eigen::MatrixXd stiffness = assemble_stiffness(energy);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, Eigen::EigenvaluesOnly).eigenvalues();
}

TEST(Stiffness, free_body_has_six_motions_without_energy_and_no_more) {
    const ConformingBody body = make_conforming_body(tagged_cube(2), {{0, triclinic()}});
    const Eigen::VectorXd values = spectrum(make_energy(body, 2));
    EXPECT_LT(std::abs(values[5]), 1e-12 * values.maxCoeff());
    EXPECT_GT(values[6], 1e-4 * values.maxCoeff());
}

TEST(Stiffness, nitsche_keeps_a_held_body_definite_and_a_penalty_below_its_bound_does_not) {
    const ConformingBody body = make_conforming_body(tagged_cube(2), {{0, triclinic()}});
    std::vector<PrescribedFace> prescribed;
    for (int f = 0; f < body.faces.size(); ++f)
        if (body.faces.faces[f].is_boundary()) prescribed.push_back({f, Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero()});
    QuadraticEnergy energy = make_energy(body, 2, prescribed);
    EXPECT_GT(spectrum(energy)[0], 0);
    for (Eigen::Matrix3d& penalty : energy.nitsche) penalty *= 0.1 / nitsche_margin;
    EXPECT_LT(spectrum(energy)[0], 0);
}

TEST(Stiffness, rigid_motions_cost_no_force) {
    const FullBody full;
    const QuadraticEnergy energy = make_energy(full.body, 2);
    Vectors u;
    for (const Eigen::Vector3d& x : full.body.particles.position)
        u.push_back(Eigen::Vector3d(0.2, -0.1, 0.4) + Eigen::Vector3d(1, -2, 0.5).cross(x));
    const Vectors random = times(energy, random_vectors(full.body.particles.size(), 1)), force = times(energy, u);
    EXPECT_LT(std::sqrt(dot(force, force)), 1e-12 * std::sqrt(dot(random, random)));
}

TEST(Links, energy_vanishes_for_linear_fields_only) {
    const ConformingBody body = make_conforming_body(tagged_cube(3), {{0, triclinic()}});
    const QuadraticEnergy energy = make_energy(body, 2);
    Vectors linear, bent;
    for (const Eigen::Vector3d& x : body.particles.position) {
        linear.push_back(LinearField{}(x));
        bent.push_back(LinearField{}(x) * x.x());
    }
    EXPECT_LT(link_energy(energy, linear), 1e-25 * dot(linear, times(energy, linear)) + 1e-20);
    EXPECT_GT(link_energy(energy, bent), 1e-6 * dot(bent, times(energy, bent)));
}

}  // namespace
}  // namespace cleave::elasticity::test
