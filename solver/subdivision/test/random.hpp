#pragma once

#include "solver/subdivision/cut.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <random>

namespace cleave::subdivision::test {

/// Seeded random points, directions and cuts; the same on every machine (no std distribution, whose bits are not fixed).
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [low, high).
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53; }

    Eigen::Vector3d in_cube(double low, double high) {
        const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
        return {x, y, z};
    }

    Eigen::Vector3d direction() {
        Eigen::Vector3d v = in_cube(-1, 1);
        while (v.squaredNorm() > 1 || v.squaredNorm() < 1e-4) v = in_cube(-1, 1);
        return v.normalized();
    }

    /// A plane through the cube [low, high)^3, or a disc with a radius of up to half the cube.
    Cut plane(double low, double high) { return {.centre = in_cube(low, high), .normal = direction()}; }
    Cut disc(double low, double high) {
        Cut cut = plane(low, high);
        cut.radius = uniform(0.05, 0.5) * (high - low);
        return cut;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace cleave::subdivision::test
