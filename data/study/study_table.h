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

/// Text of a value in a file, with the position of the value.
struct Word {
    std::string text;
    Position position;
};

/// Table of a TOML file, either study.toml or a campaign (list of simulations to run). If a value
/// has the wrong type or unit, or exceeds `largest_magnitude` in SI units, the function that reads
/// the value throws an InputError at the line and column of the key or value.
class StudyTable {
  public:
    /// Parses a text in TOML and returns the top level of the text as a table.
    /// @param file path of the file with the text, for error messages
    /// @param keys keys allowed on the top level
    /// @throws InputError at a syntax error and at an unknown key; for the key, the message
    ///         suggests the nearest allowed key
    static StudyTable parse(const std::string& file, const std::string& text,
                            const std::vector<std::string>& keys);

    /// Reads a TOML file and returns the top level of the file as a table.
    /// @param keys keys allowed on the top level
    /// @throws InputError if the file cannot be read, at a syntax error and at an unknown key
    static StudyTable read(const std::filesystem::path& file, const std::vector<std::string>& keys);

    /// Whether the table contains a given key.
    bool has(std::string_view key) const;
    /// Returns the position of a key's value in the file, or the position of the table if the key
    /// is missing.
    Position at(std::string_view key) const;
    /// Returns the position of the table in the TOML file.
    const Position& position() const { return position_; }
    /// Returns the name of the table with its brackets, such as "[grains]" or "[[effect]]"; empty
    /// for the top level of the file.
    const std::string& name() const { return name_; }

    /// Returns the table [key] inside the table. The result is empty if the key is missing.
    /// @param keys keys allowed in the table [key]
    /// @throws InputError if the value of the key is no table, or if the table [key] has a key that
    ///         is not allowed
    std::optional<StudyTable> table(std::string_view key,
                                    const std::vector<std::string>& keys) const;
    /// Returns all tables [[key]] inside the table, in the order of the file.
    /// @param keys keys allowed in the tables [[key]]
    /// @throws InputError if the value of the key is no list of tables, or if a table [[key]] has a
    ///         key that is not allowed
    std::vector<StudyTable> tables(std::string_view key,
                                   const std::vector<std::string>& keys) const;

    /// Returns the value of a key in SI units. The result is empty if the key is missing. The value
    /// in the file is a text with a unit of the dimension of `unit`, such as "500 um", or a plain
    /// number if `unit` is dimensionless.
    /// @throws InputError if the value has any other form
    std::optional<double> quantity(std::string_view key, std::string_view unit) const;
    /// Returns the value of a key in SI units. The result is empty if the key is missing. The value
    /// in the file is a text with a unit of the dimension of `unit`, or a plain number, which is
    /// taken to be in `unit`.
    /// @throws InputError if the value has any other form
    std::optional<double> quantity_in(std::string_view key, const Unit& unit) const;
    /// Returns the value of a required key in SI units. The value in the file is a text with a unit
    /// of the dimension of `unit`, or a plain number if `unit` is dimensionless.
    /// @throws InputError if the key is missing or the value has any other form
    double required_quantity(std::string_view key, std::string_view unit) const;
    /// Returns the positive value of a required key in SI units. The value in the file is a text
    /// with a unit of the dimension of `unit`, or a plain number if `unit` is dimensionless.
    /// @throws InputError if the key is missing, or if the value is below `smallest_magnitude` in
    ///         SI units or has any other form
    double positive_quantity(std::string_view key, std::string_view unit) const;

    /// Returns the values of a key in SI units, in the order of the file. The result is empty if
    /// the key is missing. The key has one value or an array of values. Each value is a text with a
    /// unit of the dimension of `unit`, or a plain number if `unit` is dimensionless.
    /// @throws InputError if the array is empty or a value has any other form
    std::vector<double> quantities(std::string_view key, std::string_view unit) const;

    /// Returns the value of a key, one plain number (without unit) or an array of plain numbers, in
    /// the order of the file. The result is empty if the key is missing.
    /// @throws InputError if the array is empty or a value is not a finite number
    std::vector<double> numbers(std::string_view key) const;

    /// Returns the value of a key, which must be a text. The result is empty if the key is missing.
    /// @throws InputError if the value is not a text
    std::optional<std::string> text(std::string_view key) const;
    /// Returns the value of a key, which must be true or false. The result is empty if the key is
    /// missing.
    /// @throws InputError if the value is neither true nor false
    std::optional<bool> flag(std::string_view key) const;
    /// Returns the value of a key, a text or a plain number, as a text with its position in the
    /// file. The result is empty if the key is missing. The function serves for a quantity whose
    /// dimension is not known yet.
    /// @throws InputError if the value is neither a text nor a number
    std::optional<Word> stated(std::string_view key) const;
    /// Returns the value of a key, which must be one of the texts `words`. If the key is missing,
    /// the result is the first of `words`.
    /// @throws InputError if the value is not one of `words`; the message suggests the nearest of
    ///         `words`
    std::string choice(std::string_view key, const std::vector<std::string>& words) const;
    /// Returns the texts of a key whose value is an array of texts. If the key is missing, the
    /// result is `missing`.
    /// @throws InputError if the value is not an array of texts
    std::vector<std::string> words(std::string_view key,
                                   const std::vector<std::string>& missing) const;
    /// Returns the texts of a key whose value is an array of texts, with the positions of the texts
    /// in the file. The result is empty if the key is missing.
    /// @throws InputError if the value is not an array of texts
    std::vector<Word> placed_words(std::string_view key) const;

    /// Throws an error that refuses the value of a key.
    /// @param message statement for the user of what is wrong with the value and what to do
    /// @throws InputError always, at the position of the key's value
    [[noreturn]] void refuse(std::string_view key, const std::string& message) const;

  private:
    StudyTable(std::shared_ptr<const toml::table> root, const toml::table& table,
               const std::string& file, std::string name, const std::vector<std::string>& keys);

    Position position_of(const toml::node& node) const;
    /// Returns the full name of a key of the table, such as "rig.direct" for the key "direct" in
    /// [rig].
    std::string path_of(std::string_view key) const;
    double finite_number(std::string_view key, const toml::node& node) const;
    double quantity_of(std::string_view key, const toml::node& node, std::string_view unit) const;
    double quantity_from_text(std::string_view key, const toml::node& node,
                              const Unit& expected) const;

    std::shared_ptr<const toml::table> root_;  ///< the whole TOML file, which keeps `table_` alive
    const toml::table* table_;
    std::string name_;  ///< name of the table with its brackets, such as "[grains]"
    Position position_;
};

}  // namespace pendular
