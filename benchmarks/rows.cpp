#include "benchmarks/rows.hpp"

namespace cleave::benchmarks {

void register_all(Level level) {
    Bodies bodies;
    register_table2(level, bodies);
    register_subdivision(level, bodies);
    register_fragments(level, bodies);
}

}  // namespace cleave::benchmarks
