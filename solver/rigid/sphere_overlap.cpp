#include "solver/rigid/world.hpp"

#include <Eigen/Geometry>

namespace cleave::rigid {
namespace {

std::vector<Sphere> moved(const std::vector<Sphere>& spheres, const Motion& motion) {
    std::vector<Sphere> out;
    for (const Sphere& sphere : spheres) out.push_back({motion.at(sphere.centre), sphere.radius});
    return out;
}

Eigen::AlignedBox3d box_of(const Sphere& sphere) {
    return {sphere.centre.array() - sphere.radius, sphere.centre.array() + sphere.radius};
}

Eigen::AlignedBox3d box_of(const std::vector<Sphere>& spheres) {
    Eigen::AlignedBox3d box;
    for (const Sphere& sphere : spheres) box.extend(box_of(sphere));
    return box;
}

std::vector<Sphere> inside(const std::vector<Sphere>& spheres, const Eigen::AlignedBox3d& box) {
    std::vector<Sphere> out;
    for (const Sphere& sphere : spheres)
        if (box.intersects(box_of(sphere))) out.push_back(sphere);
    return out;
}

}  // namespace

bool overlap(const std::vector<Sphere>& a, const Motion& motion_a, const std::vector<Sphere>& b, const Motion& motion_b) {
    const std::vector<Sphere> world_a = moved(a, motion_a), world_b = moved(b, motion_b);
    const Eigen::AlignedBox3d box_b = box_of(world_b), common = box_of(world_a).intersection(box_b);
    if (common.isEmpty()) return false;
    const std::vector<Sphere> near_b = inside(world_b, common);
    for (const Sphere& one : inside(world_a, common))
        for (const Sphere& other : near_b) {
            const double reach = one.radius + other.radius;
            if ((one.centre - other.centre).squaredNorm() < reach * reach) return true;
        }
    return false;
}

}  // namespace cleave::rigid
