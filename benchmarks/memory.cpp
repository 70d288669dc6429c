#include "benchmarks/memory.hpp"

#include "solver/input/input_error.hpp"

#include <malloc.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace cleave::benchmarks {
namespace {

/// A field of /proc/self/status, which counts in KiB.
std::size_t status_bytes(const std::string& field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(field + ":")) return 1024 * std::strtoull(line.c_str() + field.size() + 1, nullptr, 10);
    }
    throw EnvironmentError("/proc/self/status has no " + field + ": peak memory cannot be read");
}

/// The high-water mark becomes what is resident now (proc(5): clear_refs, 5).
void forget_peak() {
    std::ofstream clear("/proc/self/clear_refs");
    clear << 5 << std::flush;
    if (!clear) throw EnvironmentError("/proc/self/clear_refs cannot be written: peak memory cannot be read");
}

}  // namespace

std::size_t peak_bytes_of(const std::function<void()>& work) {
    ::malloc_trim(0);  // what earlier work freed must not come back uncounted
    forget_peak();
    const std::size_t before = status_bytes("VmRSS");
    work();
    const std::size_t peak = status_bytes("VmHWM");
    return peak > before ? peak - before : 0;
}

}  // namespace cleave::benchmarks
