#include "reports/page_writer.hpp"

#include "reports/page_assets.hpp"
#include "solver/input/input_error.hpp"

#include <stdexcept>

namespace cleave::reports {

using nlohmann::json;

namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
}

json to_json(const Report& report) {
    json sources = json::array();
    for (const ReportSource& source : report.sources) {
        sources.push_back({{"folder", source.folder},
                           {"results", source.results},
                           {"bench", source.bench},
                           {"timings", source.timings},
                           {"provenance", source.provenance},
                           {"artifacts", source.artifacts},
                           {"fields", source.fields},
                           {"scenes", source.scenes}});
    }
    return {{"schema", "cleave.report/1"}, {"sources", sources}, {"history", report.history}};
}

const std::string& value_of(std::string_view name, const std::vector<std::pair<std::string_view, std::string>>& values) {
    for (const auto& [key, value] : values) {
        if (key == name) return value;
    }
    throw std::logic_error("page template: no value for " + std::string(name));
}

}  // namespace

std::string embeddable_json(const json& value) {
    std::string text;
    try {
        text = value.dump();
    } catch (const json::type_error&) {
        throw InputError("results", "", "text in UTF-8");
    }
    replace_all(text, "<", "\\u003c");
    return text;
}

std::string embeddable_script(std::string_view script) {
    std::string text(script);
    replace_all(text, "</script", "<\\/script");
    replace_all(text, "<!--", "<\\!--");
    return text;
}

std::string fill_template(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values) {
    std::string page;
    std::size_t at = 0;
    for (std::size_t open; (open = text.find("{{", at)) != std::string_view::npos;) {
        const std::size_t close = text.find("}}", open);
        if (close == std::string_view::npos) throw std::logic_error("page template: {{ without }}");
        page += text.substr(at, open - at);
        page += value_of(text.substr(open + 2, close - open - 2), values);
        at = close + 2;
    }
    page += text.substr(at);
    return page;
}

std::string render_page(const Report& report) {
    return fill_template(page_template(), {{"style", std::string(page_style())},
                                           {"data", embeddable_json(to_json(report))},
                                           {"script", embeddable_script(page_script())}});
}

}  // namespace cleave::reports
