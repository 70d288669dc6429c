#include "reports/summary.hpp"

#include <fmt/format.h>

#include <array>

namespace cleave::reports {

using nlohmann::json;

namespace {

/// Text inside a Markdown table cell: no bars, no line ends.
std::string cell(std::string text) {
    std::string safe;
    for (const char c : text) {
        if (c == '|') safe += '\\';
        safe += c == '\n' || c == '\r' ? ' ' : c;
    }
    return safe;
}

std::string text_of(const json& row, const char* key) {
    const auto it = row.find(key);
    return it != row.end() && it->is_string() ? it->get<std::string>() : "";
}

std::string number_of(const json& row, const char* key) {
    const auto it = row.find(key);
    return it != row.end() && it->is_number() ? fmt::format("{:.4g}", it->get<double>()) : "–";
}

std::string band_of(const json& row) {
    const auto it = row.find("band");
    if (it == row.end() || !it->is_object()) return "–";
    std::string text;
    for (const auto& [key, value] : it->items()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, value.dump());
    return text;
}

bool is_twin(const json& row) { return row.value("must_fail", json(false)) == json(true); }

std::string line_of(const json& entry, const json& row) {
    const std::string verdict = text_of(row, "verdict") + (is_twin(row) ? " (must-fail twin)" : "");
    const std::string quantity = text_of(row, "quantity") + " " + text_of(row, "component");
    return fmt::format("| {} | {} | {} | {} | {} | {} {} | {} | {} | {} |\n", verdict, cell(text_of(entry, "name")), cell(quantity),
                       cell(text_of(row, "place")), cell(text_of(row, "solver")), number_of(row, "value"), cell(text_of(row, "unit")),
                       number_of(row, "reference"), number_of(row, "error"), cell(band_of(row)));
}

constexpr const char* table_head =
    "| verdict | case | quantity | place | solver | value | reference | error | band |\n"
    "|---|---|---|---|---|---|---|---|---|\n";

std::string table(const Report& report, const char* only_verdict) {
    std::string lines;
    for (const ReportSource& source : report.sources) {
        for (const json& entry : source.results["cases"]) {
            for (const json& row : entry["checks"]) {
                if (!only_verdict || row["verdict"] == only_verdict) lines += line_of(entry, row);
            }
        }
    }
    return lines.empty() ? lines : table_head + lines;
}

std::array<int, 3> count_verdicts(const Report& report) {
    std::array<int, 3> counts{};
    for (const ReportSource& source : report.sources) {
        for (const json& entry : source.results["cases"]) {
            for (const json& row : entry["checks"]) ++counts[row["verdict"] == "pass" ? 0 : row["verdict"] == "fail" ? 1 : 2];
        }
    }
    return counts;
}

}  // namespace

std::string render_summary(const Report& report) {
    const auto [pass, fail, info] = count_verdicts(report);
    std::string text = fmt::format("# Cleave cross-check\n\n{} of {} judged checks passed; {} for information.\n", pass, pass + fail, info);
    if (fail > 0) text += "\n## Missed\n\n" + table(report, "fail");
    if (pass + fail + info > 0) text += "\n## All checks\n\n" + table(report, nullptr);
    return text;
}

}  // namespace cleave::reports
