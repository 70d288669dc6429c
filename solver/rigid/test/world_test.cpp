#include "solver/rigid/world.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace cleave::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A lump of spheres along an axis, centre of mass off the origin.
BodyDescription lump(int spheres = 5) {
    BodyDescription body;
    body.mass = 2;
    body.centre = {0.1, 0.02, -0.03};
    body.inertia = Vector3d(0.02, 0.03, 0.04).asDiagonal();
    body.inertia(0, 1) = body.inertia(1, 0) = 0.003;
    for (int i = 0; i < spheres; ++i) body.spheres.push_back({{0.05 * i, 0.01 * (i % 2), 0}, 0.04});
    return body;
}

BodyDescription ball(double radius = 0.05) {
    BodyDescription body;
    body.mass = 1;
    body.inertia = 0.4 * body.mass * radius * radius * Matrix3d::Identity();
    body.spheres = {{Vector3d::Zero(), radius}};
    return body;
}

Motion thrown() {
    return {.rotation = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix(), .translation = {0.3, -0.2, 2},
            .velocity = {1, 0.5, 0.2}, .angular_velocity = {3, -2, 5}};
}

TEST(World, MotionGoesInAndComesOutAsItWas) {
    World world({});
    const Motion motion = world.motion(world.add(lump(), thrown()));
    EXPECT_LT((motion.rotation - thrown().rotation).norm(), 1e-14);       // a turn by the principal axes and back
    EXPECT_LT((motion.translation - thrown().translation).norm(), 1e-14);
    EXPECT_EQ(motion.velocity, thrown().velocity);
}

TEST(World, FreeFallFollowsItsDifferenceEquation) {
    World world({});
    const BodyDescription body = lump();
    const int id = world.add(body, thrown());
    const Vector3d start = thrown().at(body.centre);
    const double dt = 1e-3;
    const int steps = 200;
    for (int i = 0; i < steps; ++i) world.step(dt);
    // v_n = v0 + g n dt, x_n = x0 + sum of dt v_k: symplectic Euler, summed in closed form; 200 roundings.
    const Vector3d g(0, 0, -9.81), expected = start + steps * dt * thrown().velocity + 0.5 * steps * (steps + 1) * dt * dt * g;
    EXPECT_LT((world.motion(id).at(body.centre) - expected).norm(), 1e-12);
    EXPECT_LT((world.motion(id).velocity - thrown().velocity - steps * dt * g).norm(), 1e-12);
}

TEST(World, HeadOnBallsExchangeMomentumByTheRestitution) {
    World world({.gravity = Vector3d::Zero(), .friction = 0, .restitution = 0.5});
    const int a = world.add(ball(), {.translation = {-0.2, 0, 0}, .velocity = {2, 0, 0}});
    const int b = world.add(ball(), {.translation = {0.2, 0, 0}, .velocity = {-1, 0, 0}});
    double impulse = 0, approach = 0;
    for (int i = 0; i < 300; ++i) {
        world.step(1e-3);
        for (const Contact& contact : world.contacts()) {
            EXPECT_EQ(contact.a, a);
            EXPECT_EQ(contact.b, b);
            EXPECT_LT((contact.normal + Vector3d::UnitX()).norm(), 1e-9);  // from b towards a
            impulse += contact.impulse;
            approach = std::max(approach, contact.approach_speed);
        }
    }
    const double va = world.motion(a).velocity[0], vb = world.motion(b).velocity[0];
    EXPECT_NEAR(va + vb, 1, 1e-12);              // momentum of equal masses
    EXPECT_NEAR(vb - va, 0.5 * 3, 1e-6);         // Newton's restitution
    EXPECT_NEAR(impulse, 2 - va, 1e-6);          // the reported impulse is the change of momentum
    EXPECT_NEAR(approach, 3, 1e-9);
}

TEST(World, WhatFallsRestsOnTheGroundAndSleeps) {
    World world({.ground = 0.0, .restitution = 0.0});
    const int id = world.add(ball(), {.translation = {0, 0, 0.2}});
    for (int i = 0; i < 5000; ++i) world.step(1e-3);
    EXPECT_NEAR(world.motion(id).translation[2], 0.05, 1e-3);  // Bullet allows a little penetration
    EXPECT_TRUE(world.sleeps(id));
}

TEST(World, EnergyNeverGrowsOnTheGround) {
    World world({.ground = 0.0, .restitution = 0.3});
    const BodyDescription body = lump();
    Motion start = thrown();
    start.angular_velocity.setZero();
    const int id = world.add(body, start);
    const auto energy = [&] {
        const Motion m = world.motion(id);
        const Vector3d w = m.rotation.transpose() * m.angular_velocity;
        return 0.5 * body.mass * m.velocity.squaredNorm() + 0.5 * w.dot(body.inertia * w) + body.mass * 9.81 * m.at(body.centre)[2];
    };
    double before = energy();
    const double whole = before;
    for (int i = 0; i < 3000; ++i) {
        world.step(1e-3);
        EXPECT_LE(energy(), before + 2e-4 * whole) << i;  // the pushes out of a penetration lift the body, that is all
        before = energy();
    }
    EXPECT_LT(before, 0.2 * whole);
}

TEST(World, ContactsNameTheirSpheres) {
    World world({.ground = 0.0});
    const int id = world.add(lump(), {.translation = {0, 0, 0.039}});
    world.step(1e-3);
    std::vector<int> spheres;
    for (const Contact& contact : world.contacts()) {
        EXPECT_EQ(contact.a, id);
        EXPECT_EQ(contact.b, ground_body);
        EXPECT_EQ(contact.sphere_b, -1);
        EXPECT_LT((contact.normal - Vector3d::UnitZ()).norm(), 1e-12);
        EXPECT_NEAR(contact.point[0], 0.05 * contact.sphere_a, 1e-9);  // under its own sphere
        spheres.push_back(contact.sphere_a);
    }
    EXPECT_EQ(spheres, (std::vector<int>{0, 1, 2, 4}));  // four of five as deep: both ends, then the farthest from those chosen
}

/// Spheres at seeded places in a box of 10 cm.
BodyDescription heap(std::mt19937& random, int count, bool held) {
    std::uniform_real_distribution<double> place(0, 0.1), radius(0.005, 0.015);
    BodyDescription body{.mass = 1, .inertia = 1e-3 * Eigen::Matrix3d::Identity(), .spheres = {}, .hull = {}, .held = held};
    for (int i = 0; i < count; ++i) body.spheres.push_back({{place(random), place(random), place(random)}, radius(random)});
    return body;
}

/// The deepest overlap of two compounds, by every pair; negative.
double deepest(const BodyDescription& a, const Motion& motion_a, const BodyDescription& b, const Motion& motion_b) {
    double least = 0;
    for (const Sphere& one : a.spheres)
        for (const Sphere& other : b.spheres)
            least = std::min(least, (motion_a.at(one.centre) - motion_b.at(other.centre)).norm() - one.radius - other.radius);
    return least;
}

TEST(World, CompoundsTouchWhereTheirSpheresOverlapAndOnlyThere) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-0.1, 0.1), angle(0, 3);
    int touching = 0, apart = 0;
    for (int round = 0; round < 200; ++round) {
        const BodyDescription a = heap(random, 30, round % 2 == 0), b = heap(random, 6, false);
        World world({.gravity = Vector3d::Zero()});
        world.add(a, {.rotation = Eigen::AngleAxisd(angle(random), Vector3d::UnitX()).toRotationMatrix()});
        world.add(b, {.translation = {shift(random), shift(random), shift(random)}});
        const double expected = deepest(a, world.motion(0), b, world.motion(1));
        world.step(1e-9);
        ++(expected < 0 ? touching : apart);
        double found = 0;
        for (const Contact& contact : world.contacts()) found = std::min(found, contact.distance);
        EXPECT_NEAR(found, expected, 1e-9) << round;  // nothing moves in a nanosecond; the distance is Bullet's own arithmetic
        EXPECT_LE(world.contacts().size(), 4u);
    }
    EXPECT_GT(touching, 20);
    EXPECT_GT(apart, 20);
}

TEST(World, SiblingsPassUntilTheySeparate) {
    World world({.gravity = Vector3d::Zero(), .restitution = 0});
    const int a = world.add(ball(), {.translation = {0, 0, 0}});
    const int b = world.add(ball(), {.translation = {0.06, 0, 0}, .velocity = {1, 0, 0}});
    world.ignore_until_separated({a, b});
    ASSERT_EQ(world.ignored_pairs().size(), 1u);
    for (int i = 0; i < 10; ++i) world.step(1e-3);
    EXPECT_TRUE(world.contacts().empty());
    EXPECT_EQ(world.motion(b).velocity[0], 1);  // not touched
    world.release_separated();
    EXPECT_EQ(world.ignored_pairs().size(), 1u);  // 0.07 m apart, radii 0.05
    for (int i = 0; i < 40; ++i) world.step(1e-3);
    world.release_separated();
    EXPECT_TRUE(world.ignored_pairs().empty());
}

TEST(World, OverlappingBodiesThatAreNoSiblingsPush) {  // the twin of the test above
    World world({.gravity = Vector3d::Zero(), .restitution = 0});
    world.add(ball(), {.translation = {0, 0, 0}});
    world.add(ball(), {.translation = {0.06, 0, 0}, .velocity = {1, 0, 0}});
    world.step(1e-3);
    EXPECT_FALSE(world.contacts().empty());
}

TEST(World, HeldBodiesStay) {
    World world({.gravity = Vector3d::Zero()});
    BodyDescription held = ball();
    held.held = true;
    const int a = world.add(held, {.translation = {0, 0, 0}});
    world.add(ball(), {.translation = {0.3, 0, 0}, .velocity = {-3, 0, 0}});
    for (int i = 0; i < 200; ++i) world.step(1e-3);
    EXPECT_EQ(world.motion(a).translation, Vector3d::Zero());
}

/// The state as bytes would hold it.
void expect_same(const WorldState& a, const WorldState& b) {
    ASSERT_EQ(a.bodies.size(), b.bodies.size());
    EXPECT_EQ(a.ignored_pairs, b.ignored_pairs);
    EXPECT_EQ(a.next_id, b.next_id);
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        EXPECT_EQ(a.bodies[i].origin, b.bodies[i].origin);
        EXPECT_EQ(a.bodies[i].basis, b.bodies[i].basis);
        EXPECT_EQ(a.bodies[i].velocity, b.bodies[i].velocity);
        EXPECT_EQ(a.bodies[i].angular_velocity, b.bodies[i].angular_velocity);
        EXPECT_EQ(a.bodies[i].idle_time, b.bodies[i].idle_time);
        EXPECT_EQ(a.bodies[i].activation, b.bodies[i].activation);
    }
}

TEST(World, ARestoredWorldGoesOnLikeTheRebuiltOne) {
    const WorldOptions options{.ground = 0.0};
    World world(options);
    for (int i = 0; i < 4; ++i) world.add(lump(), {.translation = {0.02 * i, 0.1 * i, 0.1 + 0.12 * i}, .angular_velocity = {1, 2, 0}});
    world.remove(1);
    for (int i = 0; i < 150; ++i) world.step(2e-3);
    const WorldState state = world.save();
    std::vector<BodyDescription> bodies;
    for (const int id : world.ids()) bodies.push_back(world.description(id));
    const auto restored = World::restored(options, bodies, state);
    world.rebuild();
    for (int i = 0; i < 300; ++i) {
        world.step(2e-3);
        restored->step(2e-3);
    }
    expect_same(world.save(), restored->save());
}

TEST(World, ABodyWithoutShapeOrMassIsRefused) {
    World world({});
    BodyDescription none = lump();
    none.spheres.clear();
    EXPECT_THROW(world.add(none, {}), std::invalid_argument);
    BodyDescription light = lump();
    light.mass = 0;
    EXPECT_THROW(world.add(light, {}), std::invalid_argument);
}

TEST(World, AHullCollidesToo) {
    World world({.ground = 0.0});
    BodyDescription cube;
    cube.mass = 1;
    cube.inertia = Matrix3d::Identity() / 600;
    for (const double x : {-0.05, 0.05})
        for (const double y : {-0.05, 0.05})
            for (const double z : {-0.05, 0.05}) cube.hull.emplace_back(x, y, z);
    const int id = world.add(cube, {.translation = {0, 0, 0.06}});
    for (int i = 0; i < 1000; ++i) world.step(1e-3);
    EXPECT_NEAR(world.motion(id).translation[2], 0.05, 2e-3);  // the hull's margin and a little penetration
}

}  // namespace
}  // namespace cleave::rigid
