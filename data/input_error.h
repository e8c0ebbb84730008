#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pendular {

/// Position in an input file. Lines and columns are counted from 1; 0: unknown.
struct Position {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Returns the text "file:line:column", without what is unknown; "runs.xlsx [6 kPa]:B7" for a cell
/// of a sheet.
std::string to_string(const Position& position);

/// Error in the user's input, such as a wrong unit in a file. The message of what() has the form
/// "file:line:column: what is wrong; what to do". The program prints it and ends with exit code 2.
/// Errors of the program itself have other types.
class InputError : public std::runtime_error {
  public:
    InputError(const Position& position, const std::string& message);
    /// Creates an error that concerns no file, such as an unknown option on the command line.
    explicit InputError(const std::string& message);

    /// Returns where the error is; an empty file: it concerns none.
    const Position& position() const { return *position_; }

  private:
    std::shared_ptr<const Position> position_;  ///< shared, so that copying never throws
};

/// Returns the Damerau-Levenshtein distance of two words (optimal string alignment): number of
/// insertions, deletions, replacements and swaps of neighbouring bytes. Case is ignored.
int edit_distance(std::string_view first, std::string_view second);

/// Returns the known name with the smallest `edit_distance` from a misspelt word; empty if the
/// distance exceeds a third of the bytes of the word. One edit is always allowed.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// Returns the end of an error message about an unknown word: "did you mean 'diameter'?", with the
/// name that `nearest` finds or the only known name that begins with the word, or else "known are
/// 'density', 'diameter'".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pendular
