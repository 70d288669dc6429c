#include "benchmarks/rows.hpp"

namespace cleave::benchmarks {

void register_all(Level level, bool count_instructions) {
    Bodies bodies;
    register_table2(level, bodies);
    register_subdivision(level, bodies);
    register_fragments(level, bodies);
    register_particles(level, bodies);
    register_equilibrium(level);
    register_stress_analysis();
    register_memory(level, bodies);
    if (count_instructions) register_instructions(bodies);
}

}  // namespace cleave::benchmarks
