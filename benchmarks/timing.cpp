#include "benchmarks/timing.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace cleave::benchmarks {

double median(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("median: of at least one value");
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double seconds_of(const std::function<void()>& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

double wall_seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double relative_noise(std::vector<double> values) {
    const double middle = median(values);
    std::sort(values.begin(), values.end());
    const double quartiles = values[3 * (values.size() - 1) / 4] - values[(values.size() - 1) / 4];
    return 0.5 * quartiles / std::sqrt(static_cast<double>(values.size())) / middle;
}

namespace {

/// Medians of passes, each of which gives the times of both contestants.
PairedTimes medians(const std::function<std::pair<double, double>()>& pass, int passes) {
    std::vector<double> firsts, seconds, ratios;
    pass();  // dropped
    for (int i = 0; i < passes; ++i) {
        const auto [a, b] = pass();
        firsts.push_back(a);
        seconds.push_back(b);
        ratios.push_back(a / b);
    }
    return {median(firsts), median(seconds), median(ratios), relative_noise(ratios)};
}

double warm_seconds_of(const Contestant& contestant) {
    contestant.prepare();
    contestant.work();
    contestant.prepare();
    return seconds_of(contestant.work);
}

}  // namespace

PairedTimes paired_times(const std::function<void()>& first, const std::function<void()>& second, int passes,
                         const std::function<void()>& prepare, double (*clock)(const std::function<void()>&)) {
    const auto pass = [&] {
        prepare();
        const double a = clock(first), b = clock(second);
        return std::pair(a, b);
    };
    return medians(pass, passes);
}

PairedTimes warm_paired_times(const Contestant& first, const Contestant& second, int passes) {
    const auto pass = [&] {
        const double a = warm_seconds_of(first), b = warm_seconds_of(second);
        return std::pair(a, b);
    };
    return medians(pass, passes);
}

}  // namespace cleave::benchmarks
