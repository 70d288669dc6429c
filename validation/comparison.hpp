#pragma once

#include "validation/results.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// What one side says: the solver (of mathematics: the source), and its number where it has one.
struct Statement {
    std::string by;
    std::optional<double> value;
};

/// How far two sides are apart. `row` points at the row that judged it (band, basis, verdict); none: measured for the record only.
struct Difference {
    double error = 0;
    bool relative = true;
    std::optional<std::size_t> row;
};

/// One line of the central table: a quantity at a place as the particles, the finite elements and mathematics have it.
struct Comparison {
    std::string quantity, component, unit, place;
    std::optional<Statement> particles, fem, mathematics;
    std::optional<Difference> particles_fem, particles_mathematics, fem_mathematics;
    std::vector<std::size_t> rows;  ///< that it was made of, must-fail twins left out
};

/// The lines of a case's rows: one per quantity, place and particle solver beside the best finite elements; finite elements alone where no
/// particles were asked. Differences come from the rows (judged first, then `also`); between single numbers the missing ones are taken.
/// Norms of fields are never subtracted: the norm of a difference is not the difference of norms.
std::vector<Comparison> compare_sides(const std::vector<Row>& rows);

}  // namespace cleave::validation
