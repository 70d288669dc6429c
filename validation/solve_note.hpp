#pragma once

#include <string>

namespace cleave::validation {

/// One solve, for the record in timings.json.
struct SolveNote {
    std::string solver, method;
    long cells = 0, dofs = 0;
    int iterations = 0;
    double residual = 0, seconds = 0;
    double bytes = 0;  ///< matrix and factor or preconditioner; 0 where not counted
};

}  // namespace cleave::validation
