#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// One size of a ladder: what the method gave there and how far that is from the reference. Either may be missing (NaN error).
struct Refinement {
    double h = 0;  ///< representative size, any unit
    std::optional<double> value;
    double error = 0;
};

/// What a ladder of meshes tells about the limit h -> 0.
struct Convergence {
    std::optional<double> order;            ///< of the errors: least squares over log error against log h; from two sizes on
    std::optional<double> order_of_values;  ///< p of f = f0 + C h^p through the values; from three sizes on
    std::optional<double> extrapolated;     ///< f0, Richardson's extrapolation
    std::optional<double> uncertainty;      ///< grid convergence index times |f| on the finest mesh, in the unit of the value
    std::string asymptotic;                 ///< "stated", "denied" or "unknown"
    std::string why;
};

/// Factor of safety of the grid convergence index for three meshes and more (Roache 1994; ASME V&V 20-2009, Sect. 2-4.1).
constexpr double grid_safety_factor = 1.25;

/// The study of one ladder, coarse to fine. Nothing where it has fewer than two sizes, or sizes that do not fall.
/// Three values: f0 and p are those of the curve through them (Roache 1994). More: least squares (Eca and Hoekstra 2014), and the
/// uncertainty includes the fit's standard deviation. Values that oscillate or move apart have no extrapolation.
/// The asymptotic range is stated where the errors of neighbouring sizes fall with orders within a quarter of the observed one (three
/// sizes or more; without errors, four values whose triplets agree as well); denied where they do not.
std::optional<Convergence> study_convergence(const std::vector<Refinement>& ladder);

}  // namespace cleave::validation
