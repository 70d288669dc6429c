#pragma once

#include "validation/results.hpp"

namespace cleave::validation {

/// Over what a ladder's order is taken and judged.
enum class OrderOver {
    none,   ///< no order is judged; what convergence tells is over the sizes asked for
    count,  ///< N^(-1/3), N the number of tets: a mesh generator meets the size asked for only roughly
    size    ///< the sizes asked for
};

/// Representative sizes of a ladder, m: (finest size) (N_finest / N)^(1/3) over the count; else the sizes asked for, or by N where those do
/// not fall. Zeros where neither falls.
std::vector<double> representative_sizes(const std::vector<LadderStep>& ladder, OrderOver over);

/// Once a row has all its sizes: representative sizes, convergence and the observed order to be judged.
void finish_ladder(Row& row, OrderOver over);

}  // namespace cleave::validation
