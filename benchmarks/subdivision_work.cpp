#include "benchmarks/subdivision_work.hpp"

#include "solver/mesh/recipes/pot.hpp"

#include <algorithm>

namespace cleave::benchmarks {

SubdivisionCase pot_case() {
    return {"pot", mesh::pot(6163).mesh, {.centre = {0, 0, 0.12}, .normal = {1, 0, 0}}};
}

PureStores::PureStores(int children, int points)
    : tets_(4 * static_cast<std::size_t>(children)), links_(4 * static_cast<std::size_t>(children)), parents_(children),
      centroids_(3 * static_cast<std::size_t>(children)), volumes_(children), points_(3 * static_cast<std::size_t>(points)) {}

void PureStores::run() {
    ++turn_;  // another value each time, so that no store may be left out
    for (auto* array : {&tets_, &links_, &parents_}) std::fill(array->begin(), array->end(), turn_);
    for (auto* array : {&centroids_, &volumes_, &points_}) std::fill(array->begin(), array->end(), static_cast<double>(turn_));
}

std::size_t PureStores::bytes() const {
    return sizeof(int) * (tets_.size() + links_.size() + parents_.size()) +
           sizeof(double) * (centroids_.size() + volumes_.size() + points_.size());
}

PureStores stores_like(const subdivision::Subdivided& result, const mesh::TetMesh& original) {
    return {static_cast<int>(result.mesh.tets.size()) - result.counts.uncut,
            static_cast<int>(result.mesh.vertices.size() - original.vertices.size())};
}

}  // namespace cleave::benchmarks
