// What cleave report reads: results.json, and the samples beside it.

#include "reports/artifact_table.hpp"
#include "reports/history.hpp"
#include "reports/page_writer.hpp"
#include "reports/report_data.hpp"
#include "reports/summary.hpp"
#include "validation/test/fuzz/results_seeds.hpp"
#include "validation/test/fuzz/target.hpp"

namespace cleave::fuzz {

namespace {

constexpr const char* samples = "# along x\nx,fem,sph\n0,1,1.5\n1,nan,\n2,1e-3,-2\n";

/// All but the fixed parts of the page, which are megabytes.
void draw(const std::string& bytes) {
    static const std::filesystem::path beside = input_file("seed/profile.csv", samples);
    const std::filesystem::path folder = input_file("results.json", bytes).parent_path();
    reports::Report report = reports::load_report({folder});
    report.history = reports::read_history({folder}, report);
    for (const reports::ReportSource& source : report.sources) {
        (void)reports::embeddable_json(source.results);
        (void)reports::embeddable_json(source.artifacts);
    }
    (void)reports::embeddable_json(report.history);
    (void)reports::render_summary(report);
}

}  // namespace

Target report_target() { return {"report", {results_seed()}, draw}; }

Target samples_target() {
    return {"samples", {samples}, [](const std::string& bytes) { (void)reports::embeddable_json(reports::parse_artifact(bytes)); }};
}

}  // namespace cleave::fuzz
