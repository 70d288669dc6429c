#include "validation/test/fuzz/results_seeds.hpp"

#include "validation/results.hpp"

#include <limits>

namespace cleave::fuzz {

using namespace validation;

namespace {

Row full_row() {
    Row row;
    row.case_name = "seed";
    row.tier = "verification";
    row.quantity = "stress";
    row.component = "xx";
    row.unit = "Pa";
    row.place = "(0, 0, 1) m";
    row.solver = "sph.corrected";
    row.norm = "rms";
    row.reference_side = Side::fem;
    row.resolution = {0.1, 100, 0};
    row.measurement = {1.0, 1.01, 0.01, 0.01, 1.9};
    row.reference_source = "fem.p2";
    row.band = {.relative = 0.02, .absolute = 0.1, .order_at_least = 0.9, .side = BandSide::below};
    row.basis = "why";
    row.ladder = {{{0.2, 50, 0}, 0.04, 1.1, 0.2}, {{0.1, 100, 0}, 0.01, std::nullopt, 0.1}};
    row.convergence = Convergence{.order = 1.9, .order_of_values = std::nullopt, .extrapolated = 1.0, .uncertainty = 0.1, .asymptotic = "unknown", .why = "two sizes"};
    row.also = {{Side::mathematics, "a closed form", 1.0, 0.02, true}};
    row.artifacts = {{"seed/profile.csv", "along x", "x", "Pa"}};
    row.verdict = Verdict::pass;
    return row;
}

Row bare_row() {
    Row row;
    row.case_name = "seed";
    row.tier = "verification";
    row.quantity = "energy";
    row.solver = "fem.p2";
    row.side = Side::fem;
    row.relative = false;
    row.measurement.absolute_error = std::numeric_limits<double>::quiet_NaN();
    return row;
}

}  // namespace

FinishedCase finished_case() {
    FinishedCase finished;
    finished.result = {"seed", "verification", "about", "cleave validate seed", {{"k", "v"}}, {full_row(), bare_row()}, Verdict::pass, {"cubic"}};
    finished.seconds = 1.5;
    finished.solves = {{"fem.p2", "cholmod", 100, 300, 0, 1e-12, 0.5, 1e6}};
    return finished;
}

std::string results_seed() { return results_json({finished_case().result}, "quick"); }

}  // namespace cleave::fuzz
