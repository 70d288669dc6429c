#pragma once

#include "validation/results.hpp"

#include <string>
#include <vector>

namespace cleave::validation {

/// One cell of the matrix symmetry class x quantity x method.
struct CoverageCell {
    std::string symmetry, family;
    Side method = Side::particles;   ///< particles, fem: checks of that side; mathematics: checks whose reference is mathematics
    int checks = 0;                  ///< must-fail twins left out
    std::vector<std::string> cases;  ///< in the order of the run
    std::string why;                 ///< of an empty cell: why the shipped cases leave it so; "" where they do not
};

/// Groups of quantities of mechanics, the columns of the matrix.
const std::vector<std::string>& quantity_families();

/// The family of a quantity; "" for one that belongs to the method alone (kernels, groups, counts), which the matrix leaves out.
std::string quantity_family(const std::string& quantity);

/// What the rows of a run cover, all classes x families x methods.
std::vector<CoverageCell> coverage(const std::vector<CaseResult>& cases);

}  // namespace cleave::validation
