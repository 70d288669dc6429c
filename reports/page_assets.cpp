#include "reports/page_assets.hpp"

// CLEAVE_PAGE_* are the paths of the bundled files (CMakeLists.txt). The assembler includes the bytes as they are.
#define CLEAVE_EMBED(symbol, path)                                                        \
    asm(".section .rodata\n"                                                             \
        ".global " #symbol "_begin\n" #symbol "_begin:\n.incbin \"" path "\"\n"         \
        ".global " #symbol "_end\n" #symbol "_end:\n.byte 0\n"                          \
        ".previous\n");                                                                  \
    extern "C" const char symbol##_begin[];                                               \
    extern "C" const char symbol##_end[]

CLEAVE_EMBED(cleave_page_html, CLEAVE_PAGE_HTML);
CLEAVE_EMBED(cleave_page_css, CLEAVE_PAGE_CSS);
CLEAVE_EMBED(cleave_page_js, CLEAVE_PAGE_JS);

namespace cleave::reports {

std::string_view page_template() { return {cleave_page_html_begin, cleave_page_html_end}; }
std::string_view page_style() { return {cleave_page_css_begin, cleave_page_css_end}; }
std::string_view page_script() { return {cleave_page_js_begin, cleave_page_js_end}; }

}  // namespace cleave::reports
