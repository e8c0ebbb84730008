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

/// Text in a file with its position.
struct Word {
    std::string text;
    Position position;
};

/// A table of a study or campaign file with the keys it may have. Every value is checked as it is
/// read; a wrong one raises an InputError at the line and column of its key or value.
class StudyTable {
  public:
    /// Parses a whole study file; `keys` are those of its top level.
    /// @throws InputError for a syntax error and for an unknown key, with the nearest known one
    static StudyTable parse(const std::string& file, const std::string& text,
                            const std::vector<std::string>& keys);

    /// Reads a table from a file.
    /// @throws InputError also where it cannot be read
    static StudyTable read(const std::filesystem::path& file, const std::vector<std::string>& keys);

    bool has(std::string_view key) const;
    /// Position of a key's value, or of the table where the key is missing.
    Position at(std::string_view key) const;
    const Position& position() const { return position_; }
    /// Name as written in the file, "[grains]" or "[[effect]]"; empty for the whole file.
    const std::string& name() const { return name_; }

    /// The table under a key, [key]; empty if there is none.
    std::optional<StudyTable> table(std::string_view key,
                                    const std::vector<std::string>& keys) const;
    /// The tables under a key, [[key]], in their order.
    std::vector<StudyTable> tables(std::string_view key,
                                   const std::vector<std::string>& keys) const;

    /// Value in SI units of a string with its unit, or of a plain number where `unit` is "1".
    std::optional<double> quantity(std::string_view key, std::string_view unit) const;
    /// Value of a key in SI units; a plain number counts in `unit`.
    std::optional<double> quantity_in(std::string_view key, const Unit& unit) const;
    /// Like `quantity` where the key must be there.
    double required_quantity(std::string_view key, std::string_view unit) const;
    /// Value of a key in SI units, which must be positive.
    double positive_quantity(std::string_view key, std::string_view unit) const;

    /// Values in SI units, one or an array of them, each as for `quantity`; empty where the key is
    /// not there.
    std::vector<double> quantities(std::string_view key, std::string_view unit) const;

    /// Plain numbers: one, or an array of them; empty where the key is not there.
    std::vector<double> numbers(std::string_view key) const;

    std::optional<std::string> text(std::string_view key) const;
    /// true or false; empty where the key is not there.
    std::optional<bool> flag(std::string_view key) const;
    /// A string or a plain number as text, where its unit is not known yet.
    std::optional<Word> stated(std::string_view key) const;
    /// One of several words; `words.front()` where the key is not there.
    std::string choice(std::string_view key, const std::vector<std::string>& words) const;
    /// An array of words; `missing` where the key is not there.
    std::vector<std::string> words(std::string_view key,
                                   const std::vector<std::string>& missing) const;
    /// An array of words with their places; empty where the key is not there.
    std::vector<Word> placed_words(std::string_view key) const;

    /// @throws InputError at the key
    [[noreturn]] void refuse(std::string_view key, const std::string& message) const;

  private:
    StudyTable(std::shared_ptr<const toml::table> root, const toml::table& table,
               const std::string& file, std::string name, const std::vector<std::string>& keys);

    Position position_of(const toml::node& node) const;
    /// "rig.direct" of "direct" in [rig].
    std::string path_of(std::string_view key) const;
    double finite_number(std::string_view key, const toml::node& node) const;
    double quantity_of(std::string_view key, const toml::node& node, std::string_view unit) const;
    double quantity_from_text(std::string_view key, const toml::node& node,
                              const Unit& expected) const;

    std::shared_ptr<const toml::table> root_;  ///< keeps the nodes alive
    const toml::table* table_;
    std::string name_;  ///< as the file has it: "[grains]"
    Position position_;
};

}  // namespace pendular
