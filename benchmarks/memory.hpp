#pragma once

#include <cstddef>
#include <functional>

namespace cleave::benchmarks {

/// Bytes of resident memory that a call added at its highest point to what the process held before (Linux: the high-water mark of
/// /proc/self/status, set back first). Throws EnvironmentError where the system does not let it be set back.
std::size_t peak_bytes_of(const std::function<void()>& work);

}  // namespace cleave::benchmarks
