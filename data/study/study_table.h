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

/// Table of a TOML file, either study.toml or a campaign (list of simulations to run). Every
/// function that reads a value throws an InputError at the line and column of the key or value if
/// the value has the wrong type or unit.
class StudyTable {
  public:
    /// Parses a text in TOML and returns its top level as a table.
    /// @param file path of the file with the text, for error messages
    /// @param keys keys allowed on the top level
    /// @throws InputError at a syntax error and at an unknown key, suggesting the nearest allowed
    ///         key
    static StudyTable parse(const std::string& file, const std::string& text,
                            const std::vector<std::string>& keys);

    /// Reads a TOML file and returns its top level as a table.
    /// @param keys keys allowed on the top level
    /// @throws InputError if the file cannot be read, at a syntax error and at an unknown key
    static StudyTable read(const std::filesystem::path& file, const std::vector<std::string>& keys);

    /// Whether the table of the TOML file has a key.
    bool has(std::string_view key) const;
    /// Position of a key's value in the file, or of the table if the key is missing.
    Position at(std::string_view key) const;
    /// Position of the table in the TOML file.
    const Position& position() const { return position_; }
    /// Name of the table with its brackets, such as "[grains]" or "[[effect]]"; empty for the top
    /// level.
    const std::string& name() const { return name_; }

    /// Returns the table [key] inside this table; empty if the key is missing.
    /// @param keys keys allowed in the table
    /// @throws InputError if the value is no table or the table has a key that is not allowed
    std::optional<StudyTable> table(std::string_view key,
                                    const std::vector<std::string>& keys) const;
    /// Returns all tables [[key]] inside this table, in the order of the file.
    /// @param keys keys allowed in the tables
    /// @throws InputError if the value is no list of tables or a table has a key that is not
    ///         allowed
    std::vector<StudyTable> tables(std::string_view key,
                                   const std::vector<std::string>& keys) const;

    /// Value of a key in SI units; empty if the key is missing. The value in the file is a text
    /// with a unit of the same dimension as `unit`, such as "500 um", or a plain number if `unit`
    /// is dimensionless.
    /// @throws InputError for any other value
    std::optional<double> quantity(std::string_view key, std::string_view unit) const;
    /// Value of a key in SI units; empty if the key is missing. The value in the file is a text
    /// with a unit of the same dimension as `unit`, or a plain number, which is taken to be in
    /// `unit`.
    /// @throws InputError for any other value
    std::optional<double> quantity_in(std::string_view key, const Unit& unit) const;
    /// Value of a required key in SI units. The value in the file is a text with a unit of the same
    /// dimension as `unit`, or a plain number if `unit` is dimensionless.
    /// @throws InputError if the key is missing, and for any other value
    double required_quantity(std::string_view key, std::string_view unit) const;
    /// Positive value of a required key in SI units. The value in the file is a text with a unit of
    /// the same dimension as `unit`, or a plain number if `unit` is dimensionless.
    /// @throws InputError if the key is missing or its value is not positive, and for any other
    ///         value
    double positive_quantity(std::string_view key, std::string_view unit) const;

    /// Values of a key in SI units, in the order of the file; empty if the key is missing. The file
    /// has one value or an array of texts with units of the same dimension as `unit`, or of plain
    /// numbers if `unit` is dimensionless.
    /// @throws InputError if the array is empty, and for any other value
    std::vector<double> quantities(std::string_view key, std::string_view unit) const;

    /// Plain numbers of a key, one or an array, in the order of the file; empty if the key is
    /// missing.
    /// @throws InputError if the array is empty or a value is not a finite number
    std::vector<double> numbers(std::string_view key) const;

    /// Text of a key; empty if the key is missing.
    /// @throws InputError if the value is not a text
    std::optional<std::string> text(std::string_view key) const;
    /// Value true or false of a key; empty if the key is missing.
    /// @throws InputError if the value is neither true nor false
    std::optional<bool> flag(std::string_view key) const;
    /// Text and position of a key's value, a text or a plain number; empty if the key is missing.
    /// This function is for a quantity whose unit is not known yet.
    /// @throws InputError if the value is neither a text nor a number
    std::optional<Word> stated(std::string_view key) const;
    /// Text of a key that must be one of `words`; the first of `words` if the key is missing.
    /// @throws InputError if the text is not one of `words`, suggesting the nearest one
    std::string choice(std::string_view key, const std::vector<std::string>& words) const;
    /// Texts of a key whose value is an array of texts; `missing` if the key is missing.
    /// @throws InputError if the value is not an array of texts
    std::vector<std::string> words(std::string_view key,
                                   const std::vector<std::string>& missing) const;
    /// Texts of a key whose value is an array of texts, with their positions in the file; empty if
    /// the key is missing.
    /// @throws InputError if the value is not an array of texts
    std::vector<Word> placed_words(std::string_view key) const;

    /// Refuses the value of a key.
    /// @param message what is wrong with the value and what to do, for the user
    /// @throws InputError always, at the position of the key's value
    [[noreturn]] void refuse(std::string_view key, const std::string& message) const;

  private:
    StudyTable(std::shared_ptr<const toml::table> root, const toml::table& table,
               const std::string& file, std::string name, const std::vector<std::string>& keys);

    Position position_of(const toml::node& node) const;
    /// Full name of a key of this table, such as "rig.direct" for the key "direct" in [rig].
    std::string path_of(std::string_view key) const;
    double finite_number(std::string_view key, const toml::node& node) const;
    double quantity_of(std::string_view key, const toml::node& node, std::string_view unit) const;
    double quantity_from_text(std::string_view key, const toml::node& node,
                              const Unit& expected) const;

    std::shared_ptr<const toml::table> root_;  ///< the whole TOML file, which keeps `table_` alive
    const toml::table* table_;
    std::string name_;  ///< name of the table as in the file: "[grains]"
    Position position_;
};

}  // namespace pendular
