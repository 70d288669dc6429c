#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// On which side of the reference a value has to lie; the reference itself is on both.
enum class BandSide { either, below, above };

/// Acceptance interval of a check. Every limit that is given must hold.
struct Band {
    std::optional<double> relative;        ///< |value - reference| <= relative * |reference| (fields: norm of the difference)
    std::optional<double> absolute;        ///< |value - reference| <= absolute, SI
    std::optional<double> order_at_least;  ///< observed order over the ladder
    BandSide side = BandSide::either;              ///< of the reference, for a single number: one end of a bracket
    bool empty() const { return !relative && !absolute && !order_at_least && side == BandSide::either; }
};

/// What was measured, on the finest size of the ladder, and the errors of all sizes.
struct Measurement {
    std::optional<double> value;
    std::optional<double> reference;
    double relative_error = 0;
    double absolute_error = 0;
    std::optional<double> order;
};

enum class Verdict { pass, fail, info };
const char* name(Verdict verdict);
const char* name(BandSide side);

/// The only place that compares a measurement with a band. No band: info. A NaN never passes. With `must_fail` the check is a
/// twin with a deliberately wrong reference: it passes exactly where the band is missed by a finite error (a NaN would be missed
/// by anything and proves nothing).
Verdict judge(const Measurement& measurement, const Band& band, bool must_fail);

}  // namespace cleave::validation
