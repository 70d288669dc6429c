#include "solver/particles/wpca.hpp"

#include "solver/particles/neighbourhood.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace cleave::particles {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A slab of two layers of cells 0.75 high: spacing (0.75 / 6)^(1/3) = 0.5, so its thickness of 1.5 is 3 spacings.
mesh::TetMesh slab(const test::Grading& bend) {
    return test::lattice_mesh({24, 24, 2}, 0.2, [&](const Vector3d& x) { return bend(Vector3d(x[0] - 12, x[1] - 12, 0.75 * (x[2] - 1))); });
}

const test::Grading flat = [](const Vector3d& x) { return x; };

/// Onto a sphere of radius 20 (40 spacings): the normal at a point is its direction from the centre (0, 0, -20).
const test::Grading dome = [](const Vector3d& x) -> Vector3d {
    const double angle = std::hypot(x[0], x[1]) / 20, radius = 20 + x[2];
    const Vector3d along = angle > 0 ? Vector3d(x[0], x[1], 0).normalized() : Vector3d::Zero();
    return radius * (std::sin(angle) * along + std::cos(angle) * Vector3d::UnitZ()) - Vector3d(0, 0, 20);
};

/// Angles (deg, ascending) between the last axis and the true normal, of particles at least r_w from the rim.
std::vector<double> normal_errors(const test::Grading& bend, double window, const std::function<Vector3d(const Vector3d&)>& normal) {
    const Particles particles = from_mesh(slab(bend));
    const CellGrid grid(particles.position, suitable_cell(particles));
    std::vector<double> errors;
    for (int i = 0; i < particles.size(); ++i) {
        const Vector3d& x = particles.position[i];
        if (std::max(std::abs(x[0]), std::abs(x[1])) > 8) continue;
        const double cosine = std::abs(local_shape(particles, grid, i, window).axes.col(2).dot(normal(x)));
        errors.push_back(std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

double quantile(const std::vector<double>& sorted, double q) { return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))]; }

TEST(Wpca, FindsTheNormalOfASlab) {
    const auto up = [](const Vector3d&) { return Vector3d::UnitZ(); };
    const auto errors = normal_errors(flat, 4, up);
    RecordProperty("p95_slab", std::to_string(quantile(errors, 0.95)));
    EXPECT_LT(quantile(errors, 0.95), 3);
    const auto narrow = normal_errors(flat, 2, up);
    RecordProperty("median_narrow", std::to_string(quantile(narrow, 0.5)));
    EXPECT_GT(quantile(narrow, 0.5), 6) << "must fail twin: a window of 2 spacings sees too little";
}

TEST(Wpca, FindsTheNormalOfAShell) {
    const auto errors = normal_errors(dome, 4, [](const Vector3d& x) { return Vector3d(x + Vector3d(0, 0, 20)).normalized(); });
    RecordProperty("p95_dome", std::to_string(quantile(errors, 0.95)));
    EXPECT_LT(quantile(errors, 0.95), 3);
}

/// det G = h^-3 exactly, the shape within its limits, and the normal has the largest entry of G (the shortest half axis).
TEST(Wpca, KeepsTheVolumeOfTheSupport) {
    Particles particles = from_mesh(slab(dome));
    const std::vector<double> before = particles.support_radius;
    const WpcaReport report = apply_wpca(particles);
    for (int i = 0; i < particles.size(); ++i) {
        EXPECT_EQ(particles.support_radius[i], before[i]);
        EXPECT_NEAR(particles.tensor[i].determinant() * std::pow(before[i], 3), 1, 1e-12);
        const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(particles.tensor[i]);
        EXPECT_LT(solver.eigenvalues()(2) / solver.eigenvalues()(0), 4 * (1 + 1e-12));
        const Vector3d& x = particles.position[i];
        if (std::max(std::abs(x[0]), std::abs(x[1])) < 8) {
            EXPECT_GT(std::abs(solver.eigenvectors().col(2).dot((x + Vector3d(0, 0, 20)).normalized())), 0.99);
        }
    }
    EXPECT_EQ(report.clamped, 0);
    EXPECT_LT(report.isotropic, particles.size() / 50);
}

/// Two particles, volumes 1 and 2, one spacing apart, window 2: weights 1 and 2 (1 - 1/8) = 7/4, mean 7/11, variance 7/11 * 4/11.
TEST(Wpca, CovarianceByHand) {
    const Particles particles = from_points({{5, 5, 5}, {5, 6, 5}, {5, 7.01, 5}}, {1, 2, 9}, 1);
    const LocalShape shape = local_shape(particles, CellGrid(particles.position, 1), 0, 2);
    EXPECT_NEAR(shape.variances(0), 28.0 / 121, 1e-15);
    EXPECT_NEAR(shape.variances(1), 0, 1e-15);
    EXPECT_NEAR(std::abs(shape.axes(1, 0)), 1, 1e-15);
}

TEST(Wpca, RelativeAxes) {
    WpcaOptions options;
    const Vector3d axes = relative_axes({16, 4, 1}, options);
    EXPECT_NEAR(axes.prod(), 1, 1e-15);
    EXPECT_NEAR(axes(0) / axes(2), 4, 1e-14);
    EXPECT_NEAR(axes(1) / axes(2), 2, 1e-14);
    EXPECT_NEAR(relative_axes({100, 4, 1e-9}, options)(0) / relative_axes({100, 4, 1e-9}, options)(2), 4, 1e-14) << "clamped";
    EXPECT_EQ(relative_axes({1.49, 1.2, 1}, options), Vector3d::Ones()) << "noise";
    EXPECT_NE(relative_axes({1.51, 1.2, 1}, options), Vector3d::Ones());
}

/// Deep inside a block there is no direction to find: kernels stay isotropic.
TEST(Wpca, NoiseInsideABlockIsIsotropic) {
    Particles particles = from_mesh(test::box_mesh(10));
    const WpcaReport report = apply_wpca(particles);
    int inner = 0;
    for (int i = 0; i < particles.size(); ++i) {
        if (!test::is_inner(particles.position[i], 4 * particles.spacing[i])) continue;
        ++inner;
        EXPECT_LT((particles.tensor[i] * particles.support_radius[i] - Matrix3d::Identity()).norm(), 1e-12);
    }
    EXPECT_GT(inner, 20);
    EXPECT_GE(report.isotropic, inner);
}

TEST(Wpca, SupportsHoldTheTargetCount) {
    Particles particles = from_mesh(slab(flat));
    WpcaOptions options;
    options.target_neighbours = 40;
    apply_wpca(particles, options);
    const NeighbourLists lists = find_neighbours(particles);
    for (int i = 0; i < particles.size(); ++i) EXPECT_EQ(lists.of(i).size(), 40u) << i;

    Particles few = from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {1, 1, 1, 1}, 1);
    apply_wpca(few, options);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(find_neighbours(few).of(i).size(), 3u) << "all there are";
}

/// The user's factors act on the axes found: the last on the normal. A factor of 2 there doubles the reach along it.
TEST(Wpca, UserScalesTheAxes) {
    Particles plain = from_mesh(slab(flat)), scaled = plain;
    apply_wpca(plain);
    WpcaOptions options;
    options.scale = {1, 1, 2};
    apply_wpca(scaled, options);
    const CellGrid grid(plain.position, 1);
    for (int i = 0; i < plain.size(); i += 97) {
        const Matrix3d axes = local_shape(plain, grid, i, options.window).axes;
        const auto reach = [&](const Particles& p, int k) { return 1 / (p.tensor[i] * axes.col(k)).norm(); };
        EXPECT_NEAR(reach(scaled, 2) / reach(plain, 2), 2, 1e-10);
        EXPECT_NEAR(reach(scaled, 0) / reach(plain, 0), 1, 1e-10);
        EXPECT_NEAR(scaled.tensor[i].determinant() * std::pow(scaled.support_radius[i], 3), 1, 1e-12);
    }
}

/// A wire one cell thick, its cells four times longer than wide: spacing (4/6)^(1/3) = 0.87 widths.
mesh::TetMesh wire() {
    return test::lattice_mesh({40, 1, 1}, 0.2, [](const Vector3d& x) -> Vector3d { return {4 * x[0], x[1], x[2]}; });
}

/// Particles of the wire, off its ends, whose support holds fewer others than a strain needs.
int starved(const Particles& particles) {
    const NeighbourLists lists = find_neighbours(particles);
    int count = 0;
    for (int i = 0; i < particles.size(); ++i) {
        const bool inner = particles.position[i][0] > 16 && particles.position[i][0] < 144;
        count += inner && static_cast<int>(lists.of(i).size()) < SupportRule{}.least_neighbours;
    }
    return count;
}

/// Fig. 1: along a wire the isotropic kernel finds too few neighbours, the one stretched along the wire enough, at the same det G.
TEST(Wire, TheStretchedKernelFindsEnoughNeighbours) {
    Particles particles = from_mesh(wire());
    const int inner = 6 * 32;
    EXPECT_GT(starved(particles), inner * 9 / 10);

    Particles given = particles;  // axes as one would write them down for an elementary shape
    const Vector3d axes(std::pow(4, 2.0 / 3), std::pow(4, -1.0 / 3), std::pow(4, -1.0 / 3));
    for (int i = 0; i < given.size(); ++i) given.tensor[i] = tensor_from_axes(Matrix3d::Identity(), given.support_radius[i] * axes);
    EXPECT_EQ(starved(given), 0);

    Particles found = particles;  // axes found by WPCA
    WpcaOptions options;
    options.window = 8;
    apply_wpca(found, options);
    EXPECT_EQ(starved(found), 0);
}

/// A plate one cell thick, cells four times wider than high: the plate's normal is the short axis.
TEST(Wire, ThePlateKernelToo) {
    const auto mesh = test::lattice_mesh({20, 20, 1}, 0.2, [](const Vector3d& x) -> Vector3d { return {x[0], x[1], 0.25 * x[2]}; });
    Particles particles = from_mesh(mesh);
    apply_wpca(particles);
    for (int i = 0; i < particles.size(); ++i) {
        const Vector3d& x = particles.position[i];
        if (std::min({x[0], x[1], 20 - x[0], 20 - x[1]}) < 4) continue;
        const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(particles.tensor[i]);
        EXPECT_GT(std::abs(solver.eigenvectors().col(2)[2]), 0.99);
        EXPECT_NEAR(solver.eigenvalues()(2) / solver.eigenvalues()(0), 4, 1e-9) << "clamped";
    }
}

}  // namespace
}  // namespace cleave::particles
