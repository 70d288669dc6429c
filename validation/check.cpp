#include "validation/check.hpp"

#include <cmath>

namespace cleave::validation {

const char* name(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass: return "pass";
        case Verdict::fail: return "fail";
        case Verdict::info: return "info";
    }
    return "fail";
}

const char* name(BandSide side) {
    switch (side) {
        case BandSide::either: return "either";
        case BandSide::below: return "below";
        case BandSide::above: return "above";
    }
    return "either";
}

namespace {
bool finite(const Measurement& m, const Band& band) {
    if (band.relative && !std::isfinite(m.relative_error)) return false;
    if (band.absolute && !std::isfinite(m.absolute_error)) return false;
    if (band.side != BandSide::either && !(m.value && m.reference && std::isfinite(*m.value) && std::isfinite(*m.reference))) return false;
    return !band.order_at_least || (m.order && std::isfinite(*m.order));
}

bool holds(const Measurement& m, const Band& band) {
    if (band.relative && !(m.relative_error <= *band.relative)) return false;
    if (band.absolute && !(m.absolute_error <= *band.absolute)) return false;
    if (band.side == BandSide::below && !(*m.value <= *m.reference)) return false;
    if (band.side == BandSide::above && !(*m.value >= *m.reference)) return false;
    return !band.order_at_least || (m.order && *m.order >= *band.order_at_least);
}
}  // namespace

Verdict judge(const Measurement& measurement, const Band& band, bool must_fail) {
    if (band.empty()) return Verdict::info;
    if (!finite(measurement, band)) return Verdict::fail;
    return holds(measurement, band) != must_fail ? Verdict::pass : Verdict::fail;
}

}  // namespace cleave::validation
