#pragma once

#include <chrono>
#include <ctime>

namespace cleave::simulation {

/// Adds the time of its life to a sum, s.
class Stopwatch {
public:
    explicit Stopwatch(double& sum) : sum_(sum) {}
    ~Stopwatch() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    double& sum_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The same of this process's processor time: what a busy machine does not stretch.
class ProcessorWatch {
public:
    explicit ProcessorWatch(double& sum) : sum_(sum) {}
    ~ProcessorWatch() { sum_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }
    ProcessorWatch(const ProcessorWatch&) = delete;
    ProcessorWatch& operator=(const ProcessorWatch&) = delete;

private:
    double& sum_;
    std::clock_t start_ = std::clock();
};

}  // namespace cleave::simulation
