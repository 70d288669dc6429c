#include "solver/subdivision/triangle_overlap.hpp"

#include "solver/subdivision/test/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::subdivision {
namespace {

using Eigen::Vector2d;

const FlatTriangle right{Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1)};

FlatTriangle moved(FlatTriangle triangle, double x, double y) {
    for (Vector2d& corner : triangle) corner += Vector2d(x, y);
    return triangle;
}

double flat_area(const FlatTriangle& t) {
    const Vector2d u = t[1] - t[0], v = t[2] - t[0];
    return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

TEST(Overlap, KnownAreas) {
    EXPECT_DOUBLE_EQ(overlap_area(right, right), 0.5);
    EXPECT_EQ(overlap_area(right, moved(right, 2, 0)), 0);
    EXPECT_EQ(overlap_area(right, {Vector2d(1, 0), Vector2d(1, 1), Vector2d(0, 1)}), 0);  // they share an edge only
    EXPECT_NEAR(overlap_area(right, moved(right, 0.5, 0)), 0.125, 1e-16);
    EXPECT_DOUBLE_EQ(overlap_area(right, {Vector2d(-9, -9), Vector2d(9, -9), Vector2d(0, 9)}), 0.5);  // inside
    // Two triangles with a hexagon in common: a star of David of side 1, hexagon of side 1/3.
    const double h = std::sqrt(3.0) / 6;
    const FlatTriangle up{Vector2d(-0.5, -h), Vector2d(0.5, -h), Vector2d(0, 2 * h)};
    const FlatTriangle down{Vector2d(0.5, h), Vector2d(-0.5, h), Vector2d(0, -2 * h)};
    EXPECT_NEAR(overlap_area(up, down), 6 * std::sqrt(3.0) / 4 / 9, 1e-15);
}

TEST(Overlap, IsSymmetricAndSumsOverAPartition) {
    test::Random random(5);
    for (int round = 0; round < 2000; ++round) {
        FlatTriangle a, b;
        for (int i = 0; i < 3; ++i) {
            a[i] = random.in_cube(-1, 1).head<2>();
            b[i] = random.in_cube(-1, 1).head<2>();
        }
        if (flat_area(a) < 0) std::swap(a[1], a[2]);
        if (flat_area(b) < 0) std::swap(b[1], b[2]);
        EXPECT_NEAR(overlap_area(a, b), overlap_area(b, a), 1e-14);
        const Vector2d inside = (a[0] + a[1] + a[2]) / 3;
        double parts = 0;
        for (int i = 0; i < 3; ++i) parts += overlap_area({a[i], a[(i + 1) % 3], inside}, b);
        EXPECT_NEAR(parts, overlap_area(a, b), 1e-14);  // a few roundings of numbers of order 1
    }
}

TEST(FaceFrame, KeepsLengthsAndTurnsCounterClockwise) {
    test::Random random(6);
    for (int round = 0; round < 100; ++round) {
        const Triangle face{random.in_cube(-1, 1), random.in_cube(-1, 1), random.in_cube(-1, 1)};
        const FaceFrame frame(face);
        for (const Triangle& triangle : {face, Triangle{face[1], face[0], face[2]}}) {
            EXPECT_NEAR(flat_area(frame.flat(triangle)), triangle_area(face), 1e-14);
        }
    }
}

}  // namespace
}  // namespace cleave::subdivision
