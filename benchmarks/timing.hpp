#pragma once

#include <functional>
#include <vector>

namespace cleave::benchmarks {

/// Median; of an even count the mean of the middle two. Throws std::invalid_argument for none.
double median(std::vector<double> values);

/// Seconds of one call (steady clock).
double seconds_of(const std::function<void()>& work);

/// Times of two contestants that take turns in one process, the first pass dropped.
struct PairedTimes {
    double first = 0;   ///< median seconds
    double second = 0;  ///< median seconds
    double ratio = 0;   ///< median of the paired ratios first / second: robust against drift of the machine
};
/// `prepare` runs before each call of `first`, outside the time.
PairedTimes paired_times(const std::function<void()>& first, const std::function<void()>& second, int passes,
                         const std::function<void()>& prepare = [] {});

}  // namespace cleave::benchmarks
