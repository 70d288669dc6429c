#pragma once

#include "solver/input/quantity.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cleave {

namespace detail {
struct TomlDocument;  // hides toml++ from every includer
}

/// Strict reader of one TOML table: each key is asked for once, and finish() rejects keys nobody asked for, with the nearest
/// known key as a hint. Every failure is an InputError that names file, line, dotted key and what was expected.
/// Quantities are strings with a unit; the reader checks the dimension and returns SI values.
class TableReader {
public:
    /// Reads a file. Throws InputError (missing file, TOML syntax with its line).
    static TableReader from_file(const std::string& path);
    /// Reads text; `name` stands for the file in messages.
    static TableReader from_text(const std::string& text, const std::string& name);

    bool has(const std::string& key) const;
    /// Keys of this table, sorted.
    std::vector<std::string> keys() const;

    // Required values: throw where the key is missing.
    std::string string(const std::string& key);
    double number(const std::string& key);            ///< TOML integer or float
    long integer(const std::string& key);
    bool boolean(const std::string& key);
    double quantity(const std::string& key, Dimension dimension);              ///< "12 mm" -> 0.012
    double angle(const std::string& key);                                      ///< "30 deg" -> radians; the unit is required
    std::array<double, 3> vector(const std::string& key, Dimension dimension); ///< ["0 m", "0 m", "1 m"]
    std::vector<std::array<double, 3>> vectors(const std::string& key, Dimension dimension);  ///< array of vectors
    std::vector<std::string> strings(const std::string& key);                  ///< a string counts as an array of one
    std::vector<double> numbers(const std::string& key);
    std::vector<std::vector<double>> matrix(const std::string& key);           ///< array of arrays of numbers
    TableReader table(const std::string& key);
    std::vector<TableReader> tables(const std::string& key);                   ///< [[key]] or an inline array of tables

    // The same with a default where the key is missing.
    std::string string_or(const std::string& key, const std::string& fallback);
    double number_or(const std::string& key, double fallback);
    long integer_or(const std::string& key, long fallback);
    bool boolean_or(const std::string& key, bool fallback);
    double quantity_or(const std::string& key, Dimension dimension, double fallback);
    double angle_or(const std::string& key, double fallback);
    std::optional<TableReader> table_if(const std::string& key);
    std::vector<TableReader> tables_if(const std::string& key);

    /// A string out of a list of words. Throws InputError that lists them.
    std::string choice(const std::string& key, const std::vector<std::string>& allowed);
    std::string choice_or(const std::string& key, const std::vector<std::string>& allowed, const std::string& fallback);

    /// A file that exists: where the string says, or else beside the file that is read. Throws InputError.
    std::filesystem::path existing_file(const std::string& key);

    /// Any value (string, number, boolean, array) as its TOML text, unparsed: for overrides and fingerprints.
    std::string raw(const std::string& key);

    /// Throws InputError for the first key (in file order) that nobody asked for, in this table and in the tables read from it.
    void finish() const;

    /// An InputError at `key`: for checks of the caller's own.
    [[noreturn]] void fail(const std::string& key, const std::string& expected) const;

    const std::string& file() const;
    /// "geometry.half_width" for "half_width" in [geometry].
    std::string dotted(const std::string& key) const;

    /// Replaces (or adds) a value by dotted key, as `--set load.pressure="2 MPa"` does ("body[0].groups": of the first [[body]]). The text is parsed as TOML, and taken
    /// as a string where that fails. Throws InputError where a table on the way does not exist.
    void set(const std::string& dotted_key, const std::string& value_text);

private:
    explicit TableReader(std::shared_ptr<detail::TomlDocument> document);
    std::shared_ptr<detail::TomlDocument> document_;
};

}  // namespace cleave
