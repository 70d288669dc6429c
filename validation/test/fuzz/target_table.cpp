// The files of finished scenes as cleave simulate --table reads them.

#include "solver/input/input_error.hpp"
#include "solver/simulation/scene_table.hpp"
#include "validation/test/fuzz/target.hpp"

#include <exception>

namespace cleave::fuzz {

namespace {

constexpr const char* statistics =
    R"({"schema": "cleave.statistics/1", "scene": "pot_basic", "physical_particles": 6163, "subdivided_particles": 7000, "boundary_particles": 200,
 "fragments": 12, "mass": 1.5, "debris": {"below": 1e-4, "count": 3, "mass": 2e-4}})";
constexpr const char* timings =
    R"({"schema": "cleave.timings/1", "frames": 200, "threads": 2, "frame_rate": 30.5, "frame_rate_of_processor": 20.5,
 "stress_analysis": {"total_s": 0.1}, "subdivision": {"total_s": 0.2}, "crack_generation": {"total_s": 0.3}})";

void print(const std::string& of_statistics, const std::string& of_timings) {
    input_file("statistics.json", of_statistics);
    (void)simulation::scene_table({input_file("timings.json", of_timings).parent_path()});
}

/// The input stands for one of the two files, then for the other.
void print_both(const std::string& bytes) {
    std::exception_ptr refused;
    try {
        print(bytes, timings);
    } catch (const InputError&) {
        refused = std::current_exception();
    }
    try {
        print(statistics, bytes);
    } catch (const InputError&) {
        if (refused) throw;
    }
}

}  // namespace

Target table_target() { return {"table", {statistics, timings}, print_both}; }

}  // namespace cleave::fuzz
