#pragma once

// Private to this folder: Bullet's headers need BT_USE_DOUBLE_PRECISION, and only this library is built with it.

#include "solver/rigid/world.hpp"

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace cleave::rigid {

/// What one body gets so that a pair of them has the coefficient wished for: Bullet multiplies the two.
double pair_root(double of_a_pair);

btVector3 to_bullet(const Eigen::Vector3d& v);
Eigen::Vector3d from_bullet(const btVector3& v);
btMatrix3x3 to_bullet(const Eigen::Matrix3d& m);
Eigen::Matrix3d from_bullet(const btMatrix3x3& m);

/// One body in Bullet. Bullet's frame is the principal one, at the centre of mass.
class BulletBody {
public:
    /// Throws std::invalid_argument for a body without shape, with a mass or moment of inertia that is not positive.
    BulletBody(int id, const BodyDescription& description, const WorldOptions& options);

    int id() const { return id_; }
    const BodyDescription& description() const { return description_; }
    btRigidBody& body() const { return *body_; }

    void set(const Motion& motion);
    Motion motion() const;
    void set(const BodyState& state);
    BodyState state() const;

private:
    btCollisionShape* build_shape();

    int id_;
    BodyDescription description_;
    Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< principal axes in rest coordinates, columns
    Eigen::Vector3d moments_ = Eigen::Vector3d::Zero();   ///< kg m^2
    std::vector<std::unique_ptr<btSphereShape>> spheres_;
    std::unique_ptr<btCollisionShape> shape_;
    std::unique_ptr<btRigidBody> body_;
};

}  // namespace cleave::rigid
