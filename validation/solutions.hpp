#pragma once

#include "validation/analytic/field.hpp"
#include "validation/case.hpp"

#include <string>
#include <vector>

namespace cleave::validation {

/// What `validate --list` tells about an analytic solution, and the keys it reads.
struct SolutionInfo {
    struct Key {
        enum class Kind { word, number, angle, quantity, vector };
        std::string name;
        Kind kind;
        std::vector<std::string> choices;  ///< of a word
        Dimension dimension;               ///< of a quantity or a vector of three
    };
    std::string name, about;
    std::vector<Key> keys;
};
const std::vector<SolutionInfo>& solutions();

/// Reads `solution = NAME` and its keys from a table; keys that are absent come from `defaults`. Throws InputError.
SolutionCall read_solution_call(TableReader& table, const std::map<std::string, SolutionCall>& defaults);
/// Reads a [solution.NAME] table.
SolutionCall read_solution_defaults(const std::string& name, TableReader& table, const TableReader& parent);

/// Makes the field for a case's material and shape. Throws InputError (a material or shape the solution is not for).
analytic::Field make_field(const SolutionCall& call, const Case& of);

/// The stiffness as plain data for validation/analytic and reference_fem.
analytic::Stiffness plain_stiffness(const material::Stiffness& stiffness);

}  // namespace cleave::validation
