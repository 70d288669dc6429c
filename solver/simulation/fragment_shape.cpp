#include "solver/simulation/fragment_shape.hpp"

#include <cmath>
#include <numbers>

namespace cleave::simulation {
namespace {

std::array<float, 3> single(const Eigen::Vector3d& x) { return {static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])}; }

}  // namespace

Shape shape_of(const fragments::Surface& surface) {
    Shape shape;
    for (const Eigen::Vector3d& point : surface.points) shape.points.push_back(single(point));
    for (const fragments::SurfaceFace& face : surface.faces) {
        const auto number = [&](int k) { return static_cast<std::uint32_t>(face.points[static_cast<std::size_t>(k)]); };
        (face.crack ? shape.crack : shape.outer).push_back({number(0), number(1), number(2)});
    }
    return shape;
}

Shape ball_shape(double radius) {
    constexpr std::uint32_t meridians = 32, parallels = 16;
    Shape shape;
    for (std::uint32_t j = 0; j <= parallels; ++j)
        for (std::uint32_t i = 0; i < meridians; ++i) {
            const double polar = std::numbers::pi * j / parallels, azimuth = 2 * std::numbers::pi * i / meridians;
            shape.points.push_back(single(radius * Eigen::Vector3d(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar))));
        }
    for (std::uint32_t j = 0; j < parallels; ++j)
        for (std::uint32_t i = 0; i < meridians; ++i) {
            const std::uint32_t a = j * meridians + i, b = j * meridians + (i + 1) % meridians, c = a + meridians, d = b + meridians;
            if (j > 0) shape.outer.push_back({a, c, b});
            if (j + 1 < parallels) shape.outer.push_back({b, c, d});
        }
    return shape;
}

}  // namespace cleave::simulation
