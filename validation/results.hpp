#pragma once

#include "validation/check.hpp"
#include "validation/convergence.hpp"
#include "validation/samples.hpp"

#include <map>
#include <string>
#include <vector>

namespace cleave::validation {

/// A file beside results.json that the report draws: CSV, first column the abscissa, one column per curve.
struct Artifact {
    std::string file;  ///< relative to the results' folder
    std::string title, x, y;
};

struct LadderStep {
    Resolution resolution;
    double error = 0;
    std::optional<double> value = std::nullopt;  ///< of the method
    double h = 0;                                ///< representative size, m: see representative_sizes
};

/// Which of the three a number comes from: the method (solver/), the finite element reference, mathematics (closed forms, integrals,
/// literature).
enum class Side { particles, fem, mathematics };
const char* name(Side side);

/// The same quantity against another side of the case that no check names: measured, not judged.
struct Also {
    Side side = Side::fem;
    std::string source;
    std::optional<double> value;
    double error = 0;
    bool relative = true;
};

/// One judged comparison: a check of a case for one solver at one place.
struct Row {
    std::string case_name, tier, quantity, component, unit, place, solver;
    std::string detail{};                     ///< what the number is of within the place: of many tensors the worst one's name; usually ""
    std::string norm;                         ///< rms, max, p95: the error is the norm of a field's difference; "" for single numbers
    Side side = Side::particles;              ///< of the solver
    std::optional<Side> reference_side;       ///< none where nothing is compared
    Resolution resolution;  ///< of the finest step
    Measurement measurement;
    std::string reference_source;
    bool relative = true;   ///< error is relative (else absolute)
    Band band;
    std::string basis;      ///< why the band is that wide, or why there is none
    bool must_fail = false;
    std::vector<LadderStep> ladder;  ///< coarse to fine
    std::optional<Convergence> convergence;
    std::vector<Also> also;
    std::vector<Artifact> artifacts;
    Verdict verdict = Verdict::info;
};

struct CaseResult {
    std::string name, tier, about, command;
    std::map<std::string, std::string> parameters;
    std::vector<Row> rows;
    Verdict verdict = Verdict::info;      ///< fail if a row fails, pass if one passes and none fails
    std::vector<std::string> symmetry{};  ///< classes of the materials it used (symmetry_class), sorted, each once
};

/// The place, and the detail in brackets.
std::string place_text(const Row& row);

struct Counts {
    int pass = 0, fail = 0, info = 0;
};
Counts count(const std::vector<CaseResult>& cases);

/// The results of a run, schema cleave.results/1 (validation/results.schema.json). No timing, no machine: the same input gives
/// the same bytes.
std::string results_json(const std::vector<CaseResult>& cases, const std::string& level);
std::string results_csv(const std::vector<CaseResult>& cases);
/// JUnit: a test suite per case, a test per row; info rows are left out.
std::string junit_xml(const std::vector<CaseResult>& cases);

/// Drift against an earlier results.json, one line per row that changed, appeared or vanished. Throws InputError.
std::string drift(const std::vector<CaseResult>& cases, const std::string& old_file);

}  // namespace cleave::validation
