#pragma once

#include "reports/report_data.hpp"

#include <string>

namespace cleave::reports {

/// summary.md: the counts, the worst numbers, the missed checks, what changed since an earlier run, then every check as a Markdown table.
/// Short enough for a comment on a pull request: what does not fit is counted.
std::string render_summary(const Report& report);

}  // namespace cleave::reports
