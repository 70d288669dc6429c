// A libFuzzer program for the target that CLEAVE_FUZZ_TARGET names.

#include "solver/input/file_io.hpp"
#include "validation/test/fuzz/target.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>

namespace {

using namespace cleave;

const fuzz::Target& target() {
    static const fuzz::Target only = fuzz::CLEAVE_FUZZ_TARGET();
    return only;
}

/// Prints itself where the program ends, in one piece: run_fuzzer.sh reads the line.
struct Counts {
    long accepted = 0, refused = 0;
    ~Counts() { fmt::print(stderr, "cleave: {} accepted, {} refused\n", accepted, refused); }
};

}  // namespace

/// CLEAVE_FUZZ_SEEDS=DIR: writes the seeds there and ends.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    const char* folder = std::getenv("CLEAVE_FUZZ_SEEDS");
    if (folder == nullptr) return 0;
    int number = 0;
    for (const std::string& seed : target().seeds) write_file_atomic(std::filesystem::path(folder) / fmt::format("seed_{:03}", ++number), seed);
    std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Counts counts;
    ++(fuzz::accepts(target(), {reinterpret_cast<const char*>(data), size}) ? counts.accepted : counts.refused);
    return 0;
}
