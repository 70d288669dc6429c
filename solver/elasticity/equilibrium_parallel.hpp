#pragma once

#include "solver/parallel/for_each.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::elasticity {

using Vectors = std::vector<Eigen::Vector3d>;

/// body(i) for i in [0, count) on all threads. The calls must be independent: then the result does not depend on the threads.
template <class Body>
void parallel_for_each(int count, const Body& body) {
    constexpr std::size_t grain = 256;  // a body takes well below a microsecond
    parallel::for_each(count, body, grain);
}

/// sum of a_i . b_i, in blocks of a fixed size that are added in order: the same bits for any number of threads.
double dot(const Vectors& a, const Vectors& b);

}  // namespace cleave::elasticity
