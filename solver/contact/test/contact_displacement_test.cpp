#include "solver/contact/contact_displacement.hpp"

#include "solver/input/input_error.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace cleave::contact {
namespace {

using Eigen::Vector3d;

struct Cube {
    mesh::TetMesh mesh;
    particles::Particles particles;
    std::map<int, material::Stiffness> stiffness{{0, material::isotropic(70e9, 0.2)}};

    explicit Cube(int n) : mesh(particles::test::box_mesh(n, 0.15)), particles(particles::from_mesh(mesh)) {}
    ContactBody body() const { return {mesh, particles, stiffness}; }
    std::vector<int> within(const Vector3d& point, double radius) const {
        std::vector<int> ids;
        for (int i = 0; i < particles.size(); ++i)
            if ((particles.position[i] - point).norm() < radius) ids.push_back(i);
        return ids;
    }
};

const ContactLoad on_top{.point = {0.5, 0.5, 1}, .inward = {0, 0, -1}, .force = {0, 0, -1e6}, .radius = 0.2};

TEST(ContactDisplacement, HalfSpaceIsTheField) {
    const Cube cube(4);
    const auto displacement = contact_displacement(displacement_source("half_space"), cube.body(), on_top);
    const std::vector<int> ids{3, 17, 5};
    std::vector<Vector3d> values(3);
    displacement(ids, values);
    const HalfSpaceField field = half_space_field(cube.stiffness.at(0), on_top);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(values[k], field.displacement(cube.particles.position[ids[k]]));
}

/// A free body keeps no net force: mass times acceleration is the contact's force, and below the patch the body is pressed together.
TEST(ContactDisplacement, EquilibriumCarriesTheForce) {
    const Cube cube(6);
    const elasticity::EquilibriumSolution solution = contact_equilibrium(cube.body(), on_top);
    Vector3d inertia = Vector3d::Zero();
    for (int i = 0; i < cube.particles.size(); ++i) inertia += cube.particles.volume[i] * solution.acceleration[i];  // density 1
    EXPECT_LT((inertia - on_top.force).norm(), 1e-8 * on_top.force.norm());
    // The stress half a cube down balances the inertia of the lower half, which is half the force: sum of V sigma_zz over a thin layer.
    double force = 0, volume = 0;
    for (int i = 0; i < cube.particles.size(); ++i)
        if (std::abs(cube.particles.position[i][2] - 0.5) < 0.09) {
            force += cube.particles.volume[i] * solution.fields.stress[i][2];
            volume += cube.particles.volume[i];
        }
    EXPECT_NEAR(force / volume / on_top.force[2], 0.5, 0.05);  // the layer is not thin: 0.09 of the height either way
}

/// Force and balance do not depend on how the mesh meets the patch, nor on a patch smaller than a face.
TEST(ContactDisplacement, SmallPatchesLoadTheNearestFace) {
    const Cube cube(3);
    ContactLoad load = on_top;
    load.radius = 1e-6;
    const elasticity::EquilibriumSolution solution = contact_equilibrium(cube.body(), load);
    Vector3d inertia = Vector3d::Zero();
    for (int i = 0; i < cube.particles.size(); ++i) inertia += cube.particles.volume[i] * solution.acceleration[i];
    EXPECT_LT((inertia - load.force).norm(), 1e-8 * load.force.norm());
}

/// Both words describe the same contact: a fifth of a cube's width below a patch, the vertical strain they give agrees to a half
/// (the cube is no half-space, its particles are as large as the patch); the sign twin does not.
TEST(ContactDisplacement, TheTwoSourcesAgreeNearTheContact) {
    const Cube cube(8);
    const Vector3d deep(0.5, 0.5, 0.72), shallow(0.5, 0.5, 0.88);
    const auto shortening = [&](DisplacementSource source) {
        const auto displacement = contact_displacement(source, cube.body(), on_top);
        double mean[2]{};
        for (const int side : {0, 1}) {
            const std::vector<int> ids = cube.within(side ? deep : shallow, 0.1);
            std::vector<Vector3d> values(ids.size());
            displacement(ids, values);
            for (const Vector3d& u : values) mean[side] += u[2] / static_cast<double>(ids.size());
        }
        return mean[0] - mean[1];
    };
    const double by_half_space = shortening(DisplacementSource::half_space), by_equilibrium = shortening(DisplacementSource::equilibrium);
    EXPECT_LT(by_half_space, 0);
    EXPECT_NEAR(by_equilibrium / by_half_space, 1, 0.5);
}

TEST(ContactDisplacement, UnknownWordsAreRejected) {
    EXPECT_THROW(displacement_source("halfspace"), InputError);
    Cube cube(3);
    cube.stiffness.clear();
    EXPECT_THROW(contact_displacement(DisplacementSource::half_space, cube.body(), on_top), std::invalid_argument);
    EXPECT_THROW(contact_displacement(DisplacementSource::equilibrium, cube.body(), on_top), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::contact
