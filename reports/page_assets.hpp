#pragma once

#include <string_view>

/// The page's parts, bundled at build time and linked into the program, so that it works from anywhere.
namespace cleave::reports {

std::string_view page_template();
std::string_view page_style();
std::string_view page_script();

}  // namespace cleave::reports
