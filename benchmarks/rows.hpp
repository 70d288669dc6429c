#pragma once

#include "benchmarks/bodies.hpp"
#include "benchmarks/program_options.hpp"

namespace cleave::benchmarks {

/// All rows of this program; those that count instructions by valgrind only when asked. Bodies are made when their first row runs, not here.
void register_all(Level level, bool count_instructions = false);

/// table2/...: beside the paper's Table 2.
void register_table2(Level level, Bodies& bodies);
/// subdivision/...: the engine beside pure stores, itself cold and on two threads, the plain form, VTK where it was built in.
void register_subdivision(Level level, Bodies& bodies);
/// subdivision/instructions/...: instructions per child, by valgrind's callgrind.
void register_instructions(Bodies& bodies);
/// fragments/...: removing links and finding the fragments.
void register_fragments(Level level, Bodies& bodies);
/// neighbours/... beside nanoflann, gradient/... beside a plain Eigen loop.
void register_particles(Level level, Bodies& bodies);
/// equilibrium/...: time to accuracy of the particles and of finite elements.
void register_equilibrium(Level level);
/// memory/...: peak memory per particle.
void register_memory(Level level, Bodies& bodies);
/// stress_analysis/...: what one contact costs, from the load to the cracks.
void register_stress_analysis();

}  // namespace cleave::benchmarks
