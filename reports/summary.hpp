#pragma once

#include "reports/report_data.hpp"

#include <string>

namespace cleave::reports {

/// summary.md: the counts, the missed checks, then every check as a Markdown table. For logs and pull requests.
std::string render_summary(const Report& report);

}  // namespace cleave::reports
