#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/input_error.h"

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace pendular {

class Unit;

/// Text of a value in a file, with its position.
struct Word {
    std::string text;
    Position position;
};

/// Table of a TOML file, either study.toml or a campaign. Values are read by key:
/// - A missing key gives an empty result unless stated otherwise.
/// - A quantity is a text with a unit of the dimension of `unit`, such as "500 um", or a plain
///   number if `unit` is dimensionless. The result is in SI units.
/// - A value of any other form, or beyond `largest_magnitude` in SI units, throws an InputError at
///   its line and column, as does a key that is not among the allowed `keys` of its table; the
///   message then suggests the nearest allowed key. Only further errors are listed below.
class StudyTable {
  public:
    /// Parses a text in TOML and returns its top level.
    /// @param file path of the file with the text, for error messages
    /// @throws InputError at a syntax error
    static StudyTable parse(const std::string& file, const std::string& text,
                            const std::vector<std::string>& keys);

    /// Reads a TOML file and returns its top level.
    /// @throws InputError if the file cannot be read, and at a syntax error
    static StudyTable read(const std::filesystem::path& file, const std::vector<std::string>& keys);

    bool has(std::string_view key) const;
    /// Whether the value of a key is a table.
    bool holds_table(std::string_view key) const;
    /// Returns the position of a key's value, or of the table if the key is missing.
    Position at(std::string_view key) const;
    const Position& position() const { return position_; }
    /// Returns the name with its brackets, such as "[grains]" or "[[effect]]"; empty for the top
    /// level of the file.
    const std::string& name() const { return name_; }

    /// Returns the table [key] inside the table.
    std::optional<StudyTable> table(std::string_view key,
                                    const std::vector<std::string>& keys) const;
    /// Returns the table [key] inside the table, with any keys, for the caller to check.
    std::optional<StudyTable> open_table(std::string_view key) const;
    /// Returns the keys of the table, sorted.
    std::vector<std::string> keys() const;
    /// Returns all tables [[key]] inside the table, in the order of the file.
    std::vector<StudyTable> tables(std::string_view key,
                                   const std::vector<std::string>& keys) const;

    /// Returns a quantity in SI units.
    std::optional<double> quantity(std::string_view key, std::string_view unit) const;
    /// Returns a quantity in SI units. A plain number is taken to be in `unit`.
    std::optional<double> quantity_in(std::string_view key, const Unit& unit) const;
    /// Returns a quantity in SI units.
    /// @throws InputError if the key is missing
    double required_quantity(std::string_view key, std::string_view unit) const;
    /// Returns a quantity in SI units.
    /// @throws InputError if the key is missing or the value is below `smallest_magnitude`
    double positive_quantity(std::string_view key, std::string_view unit) const;

    /// Returns one quantity or an array of them in SI units, in the order of the file.
    /// @throws InputError if the array is empty
    std::vector<double> quantities(std::string_view key, std::string_view unit) const;

    /// Returns one plain number (without unit) or an array of them, in the order of the file.
    /// @throws InputError if the array is empty
    std::vector<double> numbers(std::string_view key) const;

    std::optional<std::string> text(std::string_view key) const;
    std::optional<bool> flag(std::string_view key) const;
    /// Returns a text or a plain number as text, for a quantity whose dimension is not known yet.
    std::optional<Word> stated(std::string_view key) const;
    /// Returns the value of a key, which must be one of `words`, or the first of them if the key is
    /// missing.
    std::string choice(std::string_view key, const std::vector<std::string>& words) const;
    /// Returns an array of texts, or `missing` if the key is missing.
    std::vector<std::string> words(std::string_view key,
                                   const std::vector<std::string>& missing) const;
    /// Returns an array of texts with their positions.
    std::vector<Word> placed_words(std::string_view key) const;

    /// Throws an InputError at the position of a key's value.
    /// @param message what is wrong with the value and what to do
    [[noreturn]] void refuse(std::string_view key, const std::string& message) const;

  private:
    StudyTable(std::shared_ptr<const toml::table> root, const toml::table& table,
               const std::string& file, std::string name, const std::vector<std::string>& keys);

    Position position_of(const toml::node& node) const;
    /// Returns the full name of a key, such as "rig.direct" for the key "direct" in [rig].
    std::string path_of(std::string_view key) const;
    double finite_number(std::string_view key, const toml::node& node) const;
    double quantity_of(std::string_view key, const toml::node& node, std::string_view unit) const;
    double quantity_from_text(std::string_view key, const toml::node& node,
                              const Unit& expected) const;

    std::shared_ptr<const toml::table> root_;  ///< the whole TOML file, which keeps `table_` alive
    const toml::table* table_;
    std::string name_;
    Position position_;
};

}  // namespace pendular
