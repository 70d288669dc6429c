#include "solver/mesh/xml_tags.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cleave::mesh {
namespace {

constexpr std::string_view blanks = " \t\r\n";

class TagReader {
public:
    TagReader(std::string_view bytes, const std::string& file, std::string_view last) : bytes_(bytes), file_(file), last_(last) {}

    std::vector<XmlTag> read() {
        while (move_to('<')) {
            if (skip_special()) continue;
            const std::string_view inside = take_tag();
            if (inside.starts_with('/')) {
                close(inside.substr(1));
            } else {
                open(inside);
                if (tags_.back().name == last_) return std::move(tags_);
            }
        }
        if (!around_.empty()) fail(fmt::format("</{}>", around_.back()));
        return std::move(tags_);
    }

private:
    [[noreturn]] void fail(const std::string& expected) const { throw InputError(file_, line_, "XML", expected); }

    void advance(std::size_t to) {
        line_ += static_cast<int>(std::count(bytes_.begin() + static_cast<long>(at_), bytes_.begin() + static_cast<long>(to), '\n'));
        at_ = to;
    }

    bool move_to(char wanted) {
        const std::size_t found = bytes_.find(wanted, at_);
        if (found == std::string_view::npos) return false;
        advance(found);
        return true;
    }

    /// <?xml ...?>, <!-- ... -->, <!DOCTYPE ...>
    bool skip_special() {
        const std::string_view rest = bytes_.substr(at_);
        if (!rest.starts_with("<?") && !rest.starts_with("<!")) return false;
        const std::string_view end = rest.starts_with("<!--") ? "-->" : ">";
        const std::size_t found = bytes_.find(end, at_);
        if (found == std::string_view::npos) fail(fmt::format("'{}'", end));
        advance(found + end.size());
        return true;
    }

    /// What stands between '<' and '>'.
    std::string_view take_tag() {
        const std::size_t begin = at_ + 1, end = bytes_.find('>', begin);
        if (end == std::string_view::npos) fail("'>' at the end of a tag");
        advance(end + 1);
        return bytes_.substr(begin, end - begin);
    }

    void close(std::string_view name) {
        name = name.substr(0, name.find_first_of(blanks));
        if (around_.empty() || around_.back() != name) fail(fmt::format("</{}>, not </{}>", around_.empty() ? "" : around_.back(), name.substr(0, 40)));
        around_.pop_back();
    }

    void open(std::string_view inside) {
        const bool empty = inside.ends_with('/');
        if (empty) inside.remove_suffix(1);
        XmlTag tag{.name = std::string(inside.substr(0, inside.find_first_of(blanks))), .parent = around_.empty() ? "" : around_.back(), .attributes = {},
                   .text = {}, .line = line_};
        inside.remove_prefix(tag.name.size());
        read_attributes(inside, tag);
        const std::size_t end = tag.name == last_ ? bytes_.size() : std::min(bytes_.find('<', at_), bytes_.size());
        tag.text = bytes_.substr(at_, end - at_);
        if (!empty) around_.push_back(tag.name);
        tags_.push_back(std::move(tag));
    }

    void read_attributes(std::string_view text, XmlTag& tag) const {
        for (std::size_t from = text.find_first_not_of(blanks); from != std::string_view::npos; from = text.find_first_not_of(blanks)) {
            text.remove_prefix(from);
            const std::size_t equals = text.find('=');
            const std::size_t open = equals == std::string_view::npos ? equals : text.find_first_not_of(blanks, equals + 1);
            if (open == std::string_view::npos || (text[open] != '"' && text[open] != '\'')) fail("attributes as name=\"value\"");
            const std::size_t close = text.find(text[open], open + 1);
            if (close == std::string_view::npos) fail("a closing quote");
            const std::string_view name = text.substr(0, std::min(equals, text.find_first_of(blanks)));
            tag.attributes[std::string(name)] = text.substr(open + 1, close - open - 1);
            text.remove_prefix(close + 1);
        }
    }

    std::string_view bytes_;
    const std::string& file_;
    std::string_view last_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<std::string> around_;
    std::vector<XmlTag> tags_;
};

}  // namespace

std::vector<XmlTag> xml_tags(std::string_view bytes, const std::string& file, std::string_view last) { return TagReader(bytes, file, last).read(); }

}  // namespace cleave::mesh
