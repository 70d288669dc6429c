#pragma once

#include "solver/subdivision/canonical_mesh.hpp"

#include <immintrin.h>

#include <array>

namespace cleave::subdivision {

/// Four vertices turned over: their x, their y, their z, their shortest edges.
struct FourVertices {
    Vector4 x, y, z, edge;
    FourVertices(const Vector4& a, const Vector4& b, const Vector4& c, const Vector4& d) {
        const Vector4 ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_ye = __builtin_shufflevector(a, b, 1, 5, 3, 7);
        const Vector4 cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_ye = __builtin_shufflevector(c, d, 1, 5, 3, 7);
        x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5);
        z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7);
        y = __builtin_shufflevector(ab_ye, cd_ye, 0, 1, 4, 5);
        edge = __builtin_shufflevector(ab_ye, cd_ye, 2, 3, 6, 7);
    }
};

/// A cut's plane as plain numbers.
struct CuttingPlane {
    std::array<double, 3> normal, centre;
    double tau;

    /// plane_distance, of four points or of one.
    template <class Value>
    Value distance(const Value& x, const Value& y, const Value& z) const {
        return (normal[0] * (x - centre[0]) + normal[1] * (y - centre[1])) + normal[2] * (z - centre[2]);
    }
    /// |vertex_distances| of four vertices.
    Vector4 sizes(const FourVertices& v) const {
        const Vector4 d = distance(v.x, v.y, v.z), least = tau * v.edge;
        const Vector4 size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), d);
        return size > least ? size : least;
    }
    /// vertex_distances of one vertex; x[3] is its shortest edge.
    double raised(const Vector4& x) const {
        const double d = distance(x[0], x[1], x[2]), least = tau * x[3];
        const double size = d >= 0 ? d : -d;
        const double up = size > least ? size : least;
        return d >= 0 ? up : -up;
    }
};

/// Bit i is set where lane i is at least 0 (and not NaN).
inline unsigned plus_mask(const Vector4& distances) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(distances, _mm256_setzero_pd(), _CMP_GE_OQ)));
}

}  // namespace cleave::subdivision
