#pragma once

#include "validation/case.hpp"

namespace cleave::validation {

/// Reads one [[check]] of a case. Throws InputError.
Check read_check(TableReader& table, const std::map<std::string, SolutionCall>& defaults, const Case& of);

/// Reads one [[check]] of a case with a [study]. Throws InputError.
Check read_study_check(TableReader& table, const StudyInfo& study);

/// Reads one [[profile]] of a case. Throws InputError.
Profile read_profile(TableReader& table, const std::map<std::string, SolutionCall>& defaults, const Case& of);

/// The side that a check's reference stands for; none where it has none.
std::optional<Side> reference_side(const Check& check, const Case& of);

/// The solvers that checks may name.
const std::vector<std::string>& solver_names();

/// What a region may name: the shape's coordinates and lengths, and "size", the elements' size (m) on this step of the ladder.
Coordinates region_names(const geometry::Shape& shape, double size);

/// True for quantities of a crack's front, which have places near it.
bool is_front_quantity(const std::string& quantity);

/// True for those of the largest principal stress at a point: angle between its direction and an axis (the component), and its gap.
bool is_principal_quantity(const std::string& quantity);

/// True for quantities of the whole body, which have neither component nor place.
bool is_scalar(const std::string& quantity);

/// The quantities that checks of a body may name, each with its SI dimension.
const std::vector<QuantityInfo>& quantities();

}  // namespace cleave::validation
