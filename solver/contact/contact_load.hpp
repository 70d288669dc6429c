#pragma once

#include <Eigen/Core>

namespace cleave::contact {

/// One contact as the body feels it. The force is spread over the contact patch like Hertz's pressure, sqrt(1 - r^2/a^2), its tangential
/// part too; a point force where the radius is zero.
struct ContactLoad {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();      ///< m, on the surface: centre of the patch
    Eigen::Vector3d inward = Eigen::Vector3d::UnitZ();    ///< unit normal of the surface, into the body
    Eigen::Vector3d force = Eigen::Vector3d::Zero();      ///< N, on the body; inward . force > 0 where it pushes
    double radius = 0;                                    ///< m, of the circle of contact; of an ellipse the half axis along `axis`
    double other_radius = 0;                              ///< m, the half axis across `axis`; 0: a circle
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();       ///< tangent along which `radius` is measured; needed by ellipses only
};

/// Axes of a surface: columns two tangents and the inward normal, right-handed. The first tangent follows `along` (its tangential part)
/// where that is not zero, else an axis chosen from the normal alone. Throws std::invalid_argument for a normal of length zero.
Eigen::Matrix3d surface_axes(const Eigen::Vector3d& inward, const Eigen::Vector3d& along = Eigen::Vector3d::Zero());

}  // namespace cleave::contact
