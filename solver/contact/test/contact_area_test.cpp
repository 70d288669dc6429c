#include "solver/contact/contact_area.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cleave::contact {
namespace {

using Eigen::Vector3d;

const Tet corner{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)};

Tet moved(const Tet& tet, const Vector3d& by) {
    Tet result = tet;
    for (Vector3d& x : result) x += by;
    return result;
}

/// The shadow of `corner` along z is the triangle x, y >= 0, x + y <= 1.
TEST(ContactArea, OverlapOfShadows) {
    const Vector3d up(0, 0, 1);
    EXPECT_NEAR(shadow_overlap_area(corner, corner, up), 0.5, 1e-15);
    EXPECT_NEAR(shadow_overlap_area(corner, moved(corner, {0, 0, -3}), up), 0.5, 1e-15) << "height does not count";
    EXPECT_NEAR(shadow_overlap_area(corner, moved(corner, {0.5, 0, 0}), up), 0.125, 1e-15);
    EXPECT_NEAR(shadow_overlap_area(corner, moved(corner, {2, 0, 0}), up), 0, 1e-15);
    EXPECT_NEAR(shadow_overlap_area(corner, moved(corner, {0.25, 0.25, 0}), up), 0.125, 1e-15);
    EXPECT_NEAR(shadow_overlap_area(corner, corner, {1, 1, 1}), std::sqrt(3.0) / 2, 1e-14) << "the face x + y + z = 1 is the largest shadow";
}

/// Random tets against counting points: 1/sqrt(n) with n = 1e5 is 0.3 %, of areas of order one; four of these.
TEST(ContactArea, AgreesWithCountingPoints) {
    std::mt19937 generator(9);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto random_tet = [&] {
        Tet tet;
        for (Vector3d& x : tet) x = Vector3d(uniform(generator), uniform(generator), uniform(generator));
        return tet;
    };
    const auto inside = [](const Tet& tet, double x, double y) {  // of the shadow along z: in one of the four faces' shadows
        for (int f = 0; f < 4; ++f) {
            bool left = true, right = true;
            for (int k = 0; k < 3; ++k) {
                const auto [a, b, c] = mesh::face_vertices[f];
                const std::array<int, 3> face{a, b, c};
                const Vector3d &p = tet[face[k]], &q = tet[face[(k + 1) % 3]];
                const double side = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
                left = left && side >= 0;
                right = right && side <= 0;
            }
            if (left || right) return true;
        }
        return false;
    };
    for (int trial = 0; trial < 4; ++trial) {
        const Tet first = random_tet(), second = random_tet();
        int hits = 0;
        const int count = 100000;
        for (int i = 0; i < count; ++i) {
            const double x = uniform(generator), y = uniform(generator);
            hits += inside(first, x, y) && inside(second, x, y);
        }
        const double area = shadow_overlap_area(first, second, {0, 0, 1});
        EXPECT_NEAR(area, 4.0 * hits / count, 0.025);
        EXPECT_NEAR(area, shadow_overlap_area(second, first, {0, 0, -1}), 1e-14);
    }
}

}  // namespace
}  // namespace cleave::contact
