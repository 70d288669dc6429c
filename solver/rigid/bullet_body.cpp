#include "solver/rigid/bullet_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace cleave::rigid {
namespace {

// At rest is slower than Bullet's defaults say (0.8 m/s, 1 rad/s): those would freeze slow pieces in the air.
constexpr double sleep_speed = 0.03;   // m/s
constexpr double sleep_turning = 0.3;  // rad/s
/// Torque of a rolling sphere per normal force, over its radius: lone spheres come to rest, as grains do.
constexpr double rolling_share = 0.1;
constexpr double hull_margin = 1e-4;  // m

/// Right-handed principal axes.
std::pair<Eigen::Matrix3d, Eigen::Vector3d> principal(const Eigen::Matrix3d& inertia) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
    Eigen::Matrix3d axes = solver.eigenvectors();
    if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
    return {axes, solver.eigenvalues()};
}

double mean_radius(const std::vector<Sphere>& spheres) {
    double sum = 0;
    for (const Sphere& sphere : spheres) sum += sphere.radius;
    return spheres.empty() ? 0 : sum / static_cast<double>(spheres.size());
}

}  // namespace

double pair_root(double of_a_pair) { return std::sqrt(of_a_pair); }
btVector3 to_bullet(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
Eigen::Vector3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btMatrix3x3 to_bullet(const Eigen::Matrix3d& m) {
    return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}
Eigen::Matrix3d from_bullet(const btMatrix3x3& m) {
    Eigen::Matrix3d out;
    for (int row = 0; row < 3; ++row) out.row(row) = from_bullet(m[row]).transpose();
    return out;
}

BulletBody::BulletBody(int id, const BodyDescription& description, const WorldOptions& options) : id_(id), description_(description) {
    if (description.spheres.empty() && description.hull.empty()) throw std::invalid_argument("a body with a shape");
    if (!(description.mass > 0)) throw std::invalid_argument("a body of positive mass");
    std::tie(axes_, moments_) = principal(description.inertia);
    if (!(moments_[0] > 0)) throw std::invalid_argument("a body whose moments of inertia are positive");
    const double mass = description.held ? 0 : description.mass;  // Bullet's word for what does not move
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, build_shape(), description.held ? btVector3(0, 0, 0) : to_bullet(moments_));
    info.m_friction = pair_root(options.friction);
    info.m_restitution = pair_root(options.restitution);
    info.m_rollingFriction = rolling_share * mean_radius(description.spheres);
    info.m_linearSleepingThreshold = sleep_speed;
    info.m_angularSleepingThreshold = sleep_turning;
    body_ = std::make_unique<btRigidBody>(info);
    body_->setUserIndex(id);
}

btCollisionShape* BulletBody::build_shape() {
    const auto local = [&](const Eigen::Vector3d& rest) { return to_bullet(Eigen::Vector3d(axes_.transpose() * (rest - description_.centre))); };
    if (description_.spheres.empty()) {
        auto hull = std::make_unique<btConvexHullShape>();
        for (const Eigen::Vector3d& point : description_.hull) hull->addPoint(local(point), false);
        hull->setMargin(hull_margin);
        hull->recalcLocalAabb();
        shape_ = std::move(hull);
        return shape_.get();
    }
    auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(description_.spheres.size()));
    for (const Sphere& sphere : description_.spheres) {
        spheres_.push_back(std::make_unique<btSphereShape>(sphere.radius));
        compound->addChildShape(btTransform(btMatrix3x3::getIdentity(), local(sphere.centre)), spheres_.back().get());
    }
    shape_ = std::move(compound);
    return shape_.get();
}

void BulletBody::set(const Motion& motion) {
    set(BodyState{.id = id_, .basis = motion.rotation * axes_, .origin = motion.at(description_.centre), .velocity = motion.velocity,
                  .angular_velocity = motion.angular_velocity});
}

Motion BulletBody::motion() const {
    const BodyState now = state();
    Motion motion{.rotation = now.basis * axes_.transpose(), .velocity = now.velocity, .angular_velocity = now.angular_velocity};
    motion.translation = now.origin - motion.rotation * description_.centre;
    return motion;
}

void BulletBody::set(const BodyState& state) {
    const btTransform place(to_bullet(state.basis), to_bullet(state.origin));
    body_->setWorldTransform(place);
    body_->setInterpolationWorldTransform(place);
    body_->setLinearVelocity(to_bullet(description_.held ? Eigen::Vector3d::Zero() : state.velocity));
    body_->setAngularVelocity(to_bullet(description_.held ? Eigen::Vector3d::Zero() : state.angular_velocity));
    body_->setInterpolationLinearVelocity(body_->getLinearVelocity());
    body_->setInterpolationAngularVelocity(body_->getAngularVelocity());
    body_->updateInertiaTensor();
    body_->forceActivationState(state.activation);
    body_->setDeactivationTime(state.idle_time);
}

BodyState BulletBody::state() const {
    const btTransform& place = body_->getWorldTransform();
    return {.id = id_, .basis = from_bullet(place.getBasis()), .origin = from_bullet(place.getOrigin()),
            .velocity = from_bullet(body_->getLinearVelocity()), .angular_velocity = from_bullet(body_->getAngularVelocity()),
            .idle_time = body_->getDeactivationTime(), .activation = body_->getActivationState()};
}

}  // namespace cleave::rigid
