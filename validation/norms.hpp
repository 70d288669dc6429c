#pragma once

#include "validation/samples.hpp"

#include <string>

namespace cleave::validation {

/// What is compared: a quantity with its component ("" for the whole vector or tensor, in the Frobenius norm).
struct Observable {
    std::string quantity;   ///< displacement | strain | stress
    std::string component;  ///< "", or x..z for displacement, xx..xy for tensors
};

/// The observable at one point, as components whose plain Euclidean norm is the norm of the vector or tensor (shear weighted
/// by sqrt 2, engineering shear strain halved first).
std::vector<double> observe(const Observable& observable, const Samples& samples, std::size_t point);

struct FieldError {
    double value = 0;      ///< norm of the method's field
    double reference = 0;  ///< norm of the reference field
    double error = 0;      ///< norm of the difference / norm of the reference
};

/// Compares two fields at the same points. norm: rms (weighted by volume), max, p95 (the error that 95 % of the volume stays
/// below, over the rms of the reference). Throws std::invalid_argument for an unknown norm, no points, or a zero reference.
FieldError compare(const Observable& observable, const Samples& method, const Samples& reference, const std::string& norm);

/// Least-squares slope of log(error) over log(size); NaN where an error is zero or NaN, or with fewer than two sizes.
double observed_order(const std::vector<double>& sizes, const std::vector<double>& errors);

}  // namespace cleave::validation
