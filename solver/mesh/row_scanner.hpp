#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cleave::mesh {

/// Walks through the rows and words of a text mesh file and turns every fault into an InputError with file and line.
class RowScanner {
public:
    RowScanner(std::string_view text, std::string name);

    /// Moves to the next row that is not blank; false at the end of the file.
    bool next_row();
    /// next_row where a row must follow: throws at the end of the file, because `what` is still missing.
    void needed_row(const char* what);
    /// needed_row inside a section of a .msh file: throws where a row starts with '$', too.
    void row(const char* what);
    /// The current row without its line end, outer blanks removed.
    std::string_view text() const { return row_; }

    /// The next word of the row; empty where there is none.
    std::string_view word();
    /// What is left of the row, outer blanks removed.
    std::string_view rest();
    /// The next word of the row as a number. Throws where there is none, or it is not an integer of this range / not finite.
    long integer(const char* what);
    double real(const char* what);
    /// An integer from 0 to what the rest of the file can hold at one byte an entry, and to the limit of our indices: a count
    /// that passes is safe to reserve.
    std::size_t count(const char* what);
    /// Throws where words are left on the row.
    void end_row(const char* what);

    [[noreturn]] void fail(const std::string& key, const std::string& expected) const;
    const std::string& name() const { return name_; }
    int line() const { return line_; }

private:
    std::string_view text_;
    std::string name_;
    std::size_t position_ = 0;  ///< of the next row
    std::string_view row_;
    std::string_view rest_;  ///< of the row
    int line_ = 0;
};

}  // namespace cleave::mesh
