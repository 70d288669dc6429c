#include "benchmarks/timing.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace cleave::benchmarks {

double median(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("median: of at least one value");
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

PairedTimes paired_times(const std::function<void()>& first, const std::function<void()>& second, int passes,
                         const std::function<void()>& prepare) {
    std::vector<double> firsts, seconds, ratios;
    for (int pass = 0; pass <= passes; ++pass) {
        prepare();
        const double a = seconds_of(first), b = seconds_of(second);
        if (pass == 0) continue;
        firsts.push_back(a);
        seconds.push_back(b);
        ratios.push_back(a / b);
    }
    return {median(firsts), median(seconds), median(ratios)};
}

}  // namespace cleave::benchmarks
