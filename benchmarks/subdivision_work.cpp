#include "benchmarks/subdivision_work.hpp"

#include "solver/mesh/morton.hpp"
#include "solver/mesh/recipes/pot.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <fmt/format.h>
#include <immintrin.h>

#include <algorithm>
#include <cstddef>

namespace cleave::benchmarks {

SubdivisionCase pot_case() {
    return {"pot", mesh::pot(6163).mesh, {.centre = {0, 0, 0.12}, .normal = {1, 0, 0}}};
}

SubdivisionCase cube_case(int cells) {
    return {fmt::format("cube_{}", 6 * cells * cells * cells), mesh::in_morton_order(mesh::test::kuhn_cube(cells, 0.15)),
            {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}};
}

subdivision::Cut fixed_disc_in(int cells) {
    return {.centre = Eigen::Vector3d::Constant((cells / 2 + 0.3) / cells), .normal = {1, 0.4, 0.3}, .radius = 2.2 / cells};
}

PureStores::PureStores(int children, int points)
    : tets_(children), links_(children), centroids_(children), points_(points), volumes_(children), parents_(children) {}

void PureStores::run() {
    ++turn_;  // other values each time, so that no store may be left out
    const int children = static_cast<int>(tets_.size()), points = static_cast<int>(points_.size());
    for (int k = 0; k < points; ++k) points_[k] = {1.0 * k, 1.0 * turn_, 2.0};
    for (int k = 0; k < children; ++k) {
        tets_[k] = {k, turn_, k, turn_};
        links_[k] = {turn_, k, turn_, k};
        centroids_[k] = {1.0 * turn_, 1.0 * k, 3.0};
        volumes_[k] = 1.0 * k;
        parents_[k] = turn_ + k;
    }
}

void PureStores::run_past_caches() {
    ++turn_;
    constexpr std::size_t chunk = 512;  // children: whole lines of every array
    const __m256i value = _mm256_set1_epi32(turn_);
    const auto stream = [&](auto& array, std::size_t first, std::size_t last) {
        auto* at = reinterpret_cast<std::byte*>(array.data() + first);
        auto* end = reinterpret_cast<std::byte*>(array.data() + std::min(last, array.size()));
        for (; at + sizeof value <= end; at += sizeof value) _mm256_stream_si256(reinterpret_cast<__m256i*>(at), value);
        std::fill(at, end, std::byte(turn_));
    };
    stream(points_, 0, points_.size());
    for (std::size_t first = 0; first < tets_.size(); first += chunk) {
        stream(tets_, first, first + chunk);
        stream(links_, first, first + chunk);
        stream(centroids_, first, first + chunk);
        stream(volumes_, first, first + chunk);
        stream(parents_, first, first + chunk);
    }
    _mm_sfence();
}

std::size_t PureStores::bytes() const {
    return tets_.size() * (sizeof tets_[0] + sizeof links_[0] + sizeof centroids_[0] + sizeof volumes_[0] + sizeof parents_[0]) +
           points_.size() * sizeof points_[0];
}

}  // namespace cleave::benchmarks
