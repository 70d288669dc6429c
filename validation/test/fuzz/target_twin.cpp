// Must fail: what the fuzzers and the regression test have to report.

#include "solver/input/input_error.hpp"
#include "validation/test/fuzz/target.hpp"

#include <csignal>
#include <memory>
#include <stdexcept>

namespace cleave::fuzz {

namespace {

void hold_four_gigabytes() {
    constexpr std::size_t size = std::size_t{4} << 30;
    const auto bytes = std::make_unique<char[]>(size);
    for (std::size_t i = 0; i < size; i += 4096) static_cast<volatile char*>(bytes.get())[i] = 1;
}

void hang() {
    for (volatile int i = 0;; i = 1 - i) {
    }
}

void read(const std::string& bytes) {
    if (bytes == "throw") throw std::runtime_error("neither accepted nor refused");
    if (bytes == "memory") hold_four_gigabytes();
    if (bytes == "hang") hang();
    if (bytes == "crash") std::raise(SIGSEGV);
    if (bytes != "accept") throw InputError("", "", "something else");
}

}  // namespace

Target twin_target() { return {"twin", {"accept"}, read}; }

}  // namespace cleave::fuzz
