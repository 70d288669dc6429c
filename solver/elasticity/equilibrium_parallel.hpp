#pragma once

#include <Eigen/Core>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace cleave::elasticity {

using Vectors = std::vector<Eigen::Vector3d>;

/// body(i) for i in [0, count) on all threads. The calls must be independent: then the result does not depend on the threads.
template <class Body>
void parallel_for_each(int count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<int>(0, count, 256), [&body](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i != range.end(); ++i) body(i);
    });
}

/// sum of a_i . b_i, in blocks of a fixed size that are added in order: the same bits for any number of threads.
double dot(const Vectors& a, const Vectors& b);

}  // namespace cleave::elasticity
