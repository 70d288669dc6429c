#pragma once

#include <string>
#include <string_view>

namespace cleave {

/// What toml++ must not see, since it has no defined answer to it: letters beyond ASCII outside strings and comments (TOML 1.0 has none there;
/// toml++ takes some for unreachable code), and keys of a million parts (it makes and frees a table for each by recursion, which exhausts the
/// stack). Everything else is left to toml++. Throws InputError with `name`, a file's, and the line.
void require_safe_toml(std::string_view text, const std::string& name);

}  // namespace cleave
