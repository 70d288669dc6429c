#include "reports/results_check.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace cleave::reports {

using nlohmann::json;

namespace {

constexpr std::string_view schema = "cleave.results/1";
constexpr std::array<std::string_view, 3> verdicts = {"pass", "fail", "info"};

/// One object of the document with its place in it, for messages.
struct Node {
    const json& value;
    const std::string& file;
    std::string key;

    std::string at(const std::string& name) const { return key.empty() ? name : key + "." + name; }
    [[noreturn]] void fail(const std::string& name, const std::string& expected) const {
        throw InputError(file, at(name), expected);
    }
    const json* find(const std::string& name) const {
        const auto it = value.find(name);
        return it == value.end() || it->is_null() ? nullptr : &*it;
    }
};

void require_object(const Node& node) {
    if (!node.value.is_object()) throw InputError(node.file, node.key, "an object {...}");
}

std::string require_string(const Node& node, const std::string& name) {
    const json* found = node.find(name);
    if (!found || !found->is_string()) node.fail(name, "a string");
    return found->get<std::string>();
}

void require_verdict(const Node& node) {
    const std::string word = require_string(node, "verdict");
    if (std::find(verdicts.begin(), verdicts.end(), word) == verdicts.end()) node.fail("verdict", "pass, fail or info");
}

void allow(const Node& node, const std::string& name, bool (json::*is_kind)() const noexcept, const char* expected) {
    const json* found = node.find(name);
    if (found && !(found->*is_kind)()) node.fail(name, std::string(expected) + " or null");
}

void check_each(const Node& node, const std::string& name, bool required, void (*check)(const Node&)) {
    const json* list = node.find(name);
    if (!list && !required) return;
    if (!list || !list->is_array()) node.fail(name, "an array [...]");
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Node item{(*list)[i], node.file, fmt::format("{}[{}]", node.at(name), i)};
        require_object(item);
        check(item);
    }
}

void check_ladder_step(const Node& step) {
    const json* size = step.find("size");
    if (!size || !size->is_number()) step.fail("size", "a number");
    allow(step, "error", &json::is_number, "a number");
}

void check_artifact(const Node& artifact) { require_string(artifact, "file"); }

void check_row(const Node& row) {
    for (const char* name : {"quantity", "solver"}) require_string(row, name);
    require_verdict(row);
    for (const char* name : {"value", "reference", "error", "order"}) allow(row, name, &json::is_number, "a number");
    for (const char* name : {"case", "tier", "component", "unit", "place", "reference_source", "error_kind", "basis"}) {
        allow(row, name, &json::is_string, "a string");
    }
    for (const char* name : {"band", "resolution"}) allow(row, name, &json::is_object, "an object {...}");
    allow(row, "must_fail", &json::is_boolean, "true, false");
    check_each(row, "ladder", false, check_ladder_step);
    check_each(row, "artifacts", false, check_artifact);
}

void check_case(const Node& entry) {
    require_string(entry, "name");
    for (const char* name : {"tier", "about", "command"}) allow(entry, name, &json::is_string, "a string");
    allow(entry, "parameters", &json::is_object, "an object {...}");
    check_each(entry, "checks", true, check_row);
}

/// Worst numbers by name: each null or an object with its error.
void check_headline(const Node& root) {
    allow(root, "headline", &json::is_object, "an object {...}");
    const json* headline = root.find("headline");
    if (!headline) return;
    for (const auto& [name, worst] : headline->items()) {
        if (worst.is_null()) continue;
        const Node one{worst, root.file, "headline." + name};
        require_object(one);
        const json* error = one.find("error");
        if (!error || !error->is_number()) one.fail("error", "a number");
    }
}

/// Where the writer's own counts stand, they must be those of the rows: a cut or edited file shows here.
void check_counts(const Node& root) {
    const json* counts = root.find("counts");
    if (!counts) return;
    for (const std::string_view verdict : verdicts) {
        std::size_t rows = 0;
        for (const json& entry : root.value["cases"]) {
            for (const json& row : entry["checks"]) rows += row["verdict"] == verdict;
        }
        if (!counts->is_object() || counts->value(std::string(verdict), json()) != rows) {
            root.fail(fmt::format("counts.{}", verdict), fmt::format("{}, the number of such checks", rows));
        }
    }
}

}  // namespace

void check_results(const json& results, const std::string& file) {
    const Node root{results, file, ""};
    require_object(root);
    const json* found = root.find("schema");
    if (!found || *found != schema) root.fail("schema", fmt::format("\"{}\"", schema));
    allow(root, "level", &json::is_string, "a string");
    check_each(root, "cases", true, check_case);
    check_headline(root);
    check_counts(root);
}

}  // namespace cleave::reports
