#include "reports/history.hpp"
#include "reports/page_writer.hpp"
#include "reports/report_data.hpp"
#include "reports/summary.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

void write_report(const std::vector<std::filesystem::path>& from, const std::vector<std::filesystem::path>& earlier, const std::filesystem::path& out) {
    cleave::reports::Report report = cleave::reports::load_report(from);
    report.history = cleave::reports::read_history(earlier, report);
    // Both texts stand before the first byte is written: bad input leaves the folder as it was.
    const std::string page = cleave::reports::render_page(report);
    const std::string summary = cleave::reports::render_summary(report);
    cleave::write_file_atomic(out / "summary.md", summary);
    cleave::write_file_atomic(out / "index.html", page);
    fmt::print("{}\n", (out / "index.html").string());
}

int body(int argc, char** argv) {
    CLI::App app("Draws results as one self-contained page: OUT/index.html, and OUT/summary.md. Judges nothing.", "cleave-report");
    std::vector<std::filesystem::path> from, earlier;
    std::filesystem::path out;
    app.add_option("--from", from, "Folders with results.json (bench.json, timings.json, provenance.json, samples)")->required();
    app.add_option("--history", earlier, "Folders of earlier runs, oldest first: what changed since");
    app.add_option("--out", out, "Folder for index.html and summary.md")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        fmt::print(stderr, "cleave-report: {} (see --help)\n", error.what());
        return static_cast<int>(cleave::ExitCode::input);
    }
    write_report(from, earlier, out);
    return static_cast<int>(cleave::ExitCode::ok);
}

}  // namespace

int main(int argc, char** argv) { return cleave::run_program("cleave-report", body, argc, argv); }
