#include "solver/contact/contact_load.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <stdexcept>

namespace cleave::contact {

namespace {

/// The coordinate axis that is farthest from the normal.
Eigen::Vector3d far_axis(const Eigen::Vector3d& normal) {
    int smallest = 0;
    normal.cwiseAbs().minCoeff(&smallest);
    return Eigen::Vector3d::Unit(smallest);
}

}  // namespace

Eigen::Matrix3d surface_axes(const Eigen::Vector3d& inward, const Eigen::Vector3d& along) {
    const double length = inward.norm();
    if (!(length > 0) || !std::isfinite(length)) throw std::invalid_argument("an inward normal of finite length above zero");
    const Eigen::Vector3d normal = inward / length;
    Eigen::Vector3d tangent = along - normal.dot(along) * normal;
    if (tangent.norm() <= 1e-12 * along.norm()) {
        const Eigen::Vector3d axis = far_axis(normal);
        tangent = axis - normal.dot(axis) * normal;
    }
    Eigen::Matrix3d axes;
    axes.col(0) = tangent.normalized();
    axes.col(1) = normal.cross(axes.col(0));
    axes.col(2) = normal;
    return axes;
}

}  // namespace cleave::contact
