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

/// Rows of one verdict, or all; as many as fit into `room` bytes, and how many do not.
std::string table(const Report& report, const char* only_verdict, std::size_t room) {
    std::string lines;
    int left_out = 0;
    for (const ReportSource& source : report.sources) {
        for (const json& entry : source.results["cases"]) {
            for (const json& row : entry["checks"]) {
                if (only_verdict && row["verdict"] != only_verdict) continue;
                const std::string line = line_of(entry, row);
                if (lines.size() + line.size() > room)
                    ++left_out;
                else
                    lines += line;
            }
        }
    }
    if (left_out > 0) lines += fmt::format("\n{} more stand in results.csv.\n", left_out);
    return lines.empty() ? lines : table_head + lines;
}

/// The worst numbers of all folders, with the commands that repeat them.
std::string worst_numbers(const Report& report) {
    struct Kind {
        const char *key, *title;
        double factor;
        const char* unit;
    };
    std::string lines;
    for (const Kind& kind : {Kind{"worst_particle_stress", "worst judged particle stress against the FEM", 100, " %"},
                             Kind{"recorded_particle_stress", "largest particle stress against the FEM that is only recorded", 100, " %"},
                             Kind{"worst_energy_release_rate", "worst judged energy release rate", 100, " %"}, Kind{"worst_crack_angle", "worst judged crack angle", 1, "°"}}) {
        const json* worst = nullptr;
        for (const ReportSource& source : report.sources) {
            const auto headline = source.results.find("headline");
            if (headline == source.results.end() || !headline->is_object() || !headline->contains(kind.key) || (*headline)[kind.key].is_null()) continue;
            const json& one = (*headline)[kind.key];
            if (!worst || one["error"].get<double>() > (*worst)["error"].get<double>()) worst = &one;
        }
        if (!worst) continue;
        const std::string why = worst->contains("why") ? fmt::format(" ({}: {})", text_of(*worst, "solver"), cell(text_of(*worst, "why"))) : "";
        lines += fmt::format("| {}{} | {:.2g}{} | `{}` |\n", kind.title, why, kind.factor * (*worst)["error"].get<double>(), kind.unit, cell(text_of(*worst, "command")));
    }
    return lines.empty() ? lines : "\n| | | command |\n|---|---|---|\n" + lines;
}

std::string error_of(const json& value) { return value.is_number() ? fmt::format("{:.3g}", value.get<double>()) : "–"; }

std::string changes(const Report& report, std::size_t room) {
    if (report.history.is_null()) return "";
    const json& list = report.history["changes"];
    if (list.empty()) return "\n## Since the last run\n\nNothing changed.\n";
    std::string lines = "\n## Since the last run\n\n| | case | check | error before | now | verdict before | now |\n|---|---|---|---|---|---|---|\n";
    int left_out = 0;
    for (const json& one : list) {
        const std::string line = fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", text_of(one, "kind"), cell(text_of(one, "case")), cell(text_of(one, "what")),
                                             error_of(one["before"]), error_of(one["now"]), text_of(one, "verdict_before"), text_of(one, "verdict_now"));
        if (lines.size() + line.size() > room)
            ++left_out;
        else
            lines += line;
    }
    return left_out > 0 ? lines + fmt::format("\n{} more changes stand in index.html.\n", left_out) : lines;
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
    // A comment on a pull request may have 65,536 characters.
    constexpr std::size_t missed_room = 15000, changes_room = 15000, all_room = 30000;
    const auto [pass, fail, info] = count_verdicts(report);
    std::string text = fmt::format("# Cleave cross-check\n\n{} of {} judged checks passed; {} for information.\n", pass, pass + fail, info);
    text += worst_numbers(report);
    if (fail > 0) text += "\n## Missed\n\n" + table(report, "fail", missed_room);
    text += changes(report, changes_room);
    if (pass + fail + info > 0) text += "\n## All checks\n\n<details><summary>Table</summary>\n\n" + table(report, nullptr, all_room) + "\n</details>\n";
    return text;
}

}  // namespace cleave::reports
