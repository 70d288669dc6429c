#pragma once

#include "validation/test/fuzz/target.hpp"

#include <functional>
#include <string>

namespace cleave::fuzz {

enum class Answer { accepted, refused, survivor };  ///< survivor: neither parsed nor refused in one line

/// Runs `work` in a process of its own within 2 GB; true where that ended by itself with `std::exit(0)` or by returning.
bool isolated(const std::function<void()>& work, const std::string& name);

/// Ends this process after so many seconds of its own processor time: a busy machine is no hang.
void limit_processor_time(long seconds);

/// What the target makes of the input within 2 GB and `seconds` of processor time. What a survivor did stands on stderr.
Answer answer(const Target& target, const std::string& bytes, long seconds = 10);

/// The same in this process, without limits.
Answer answer_here(const Target& target, const std::string& bytes);

/// False where a sanitizer's shadow is larger than any limit.
bool memory_is_limited();

}  // namespace cleave::fuzz
