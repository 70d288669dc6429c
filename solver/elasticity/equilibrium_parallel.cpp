#include "solver/elasticity/equilibrium_parallel.hpp"

#include <algorithm>

namespace cleave::elasticity {

double dot(const Vectors& a, const Vectors& b) {
    constexpr int block = 4096;
    const int count = static_cast<int>(a.size()), blocks = (count + block - 1) / block;
    std::vector<double> part(blocks, 0);
    parallel::for_each(blocks, [&](int n) {
        for (int i = n * block; i < std::min(count, (n + 1) * block); ++i) part[n] += a[i].dot(b[i]);
    });
    double sum = 0;
    for (const double value : part) sum += value;
    return sum;
}

}  // namespace cleave::elasticity
