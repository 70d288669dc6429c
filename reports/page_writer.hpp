#pragma once

#include "reports/report_data.hpp"

#include <string>
#include <string_view>

namespace cleave::reports {

/// index.html: one file with style, program and data inside; opens without a network. The same report gives the same bytes.
std::string render_page(const Report& report);

/// JSON text that may stand inside a script element: every < is written \u003c, so that no </script> or <!-- can end it.
/// Throws InputError where a string is not UTF-8.
std::string embeddable_json(const nlohmann::json& value);

/// JavaScript that may stand inside a script element: </script and <!-- are broken by a backslash, which changes no string.
std::string embeddable_script(std::string_view script);

/// Replaces each {{name}} of the template once, in one pass: inserted text is not searched again.
/// Throws std::logic_error for a name without a value.
std::string fill_template(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values);

}  // namespace cleave::reports
