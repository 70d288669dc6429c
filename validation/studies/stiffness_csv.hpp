#pragma once

#include "solver/material/voigt.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::validation {

struct NamedStiffness {
    std::string name;
    material::Stiffness stiffness;  ///< Pa
};

/// Tensors from a table: one a line, the 21 constants of the upper triangle row by row, C11, C12, ..., C16, C22, ..., C66, in GPa, Voigt order
/// xx, yy, zz, yz, xz, xy. A name may stand before them ("line 7" where none does). Cells end with a comma, a semicolon or a tab and may stand
/// in double quotes; empty lines and lines that start with # do not count, nor does a first line without any number (titles).
/// Throws InputError, "FILE:LINE: expected ...": not 21 numbers, no finite number, not positive definite, a name twice, no tensor at all.
std::vector<NamedStiffness> read_stiffness_csv(const std::filesystem::path& file);

}  // namespace cleave::validation
