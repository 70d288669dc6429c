#pragma once

#include <functional>
#include <vector>

namespace cleave::benchmarks {

/// Median; of an even count the mean of the middle two. Throws std::invalid_argument for none.
double median(std::vector<double> values);

/// How uncertain the median of these values is, relative to it: half the distance between the quartiles over the root of their count.
double relative_noise(std::vector<double> values);

/// Seconds of one call on the calling thread (its processor time): what others do on the machine is not counted, though the caches
/// they take are. Equal to the time on the wall for one thread on a machine of its own.
double seconds_of(const std::function<void()>& work);

/// Seconds of one call on the wall (steady clock): for work on several threads.
double wall_seconds_of(const std::function<void()>& work);

/// Times of two contestants that take turns in one process, the first pass dropped.
struct PairedTimes {
    double first = 0;   ///< median seconds
    double second = 0;  ///< median seconds
    double ratio = 0;   ///< median of the paired ratios first / second: robust against drift of the machine
    double noise = 0;   ///< relative_noise of the ratios
};
/// `prepare` runs before each call of `first`, outside the time.
PairedTimes paired_times(const std::function<void()>& first, const std::function<void()>& second, int passes,
                         const std::function<void()>& prepare = [] {}, double (*clock)(const std::function<void()>&) = seconds_of);

/// What is timed, and what makes it possible once more (outside the time).
struct Contestant {
    std::function<void()> work;
    std::function<void()> prepare = [] {};
};
/// The same where each contestant runs untimed right before it is timed, both alike: the caches hold what they can of its own data, and
/// not what the other one left there.
PairedTimes warm_paired_times(const Contestant& first, const Contestant& second, int passes);

}  // namespace cleave::benchmarks
