#pragma once

#include <stdexcept>
#include <string>

namespace pendular {

/// Position in an input file. Lines and columns are counted from 1; 0: unknown.
struct Position {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Returns the text "file:line:column", without what is unknown.
std::string to_string(const Position& position);

/// Error in the user's input, such as a wrong unit in a file. The message of what() has the form
/// "file:line:column: what is wrong; what to do". The program prints it and ends with exit code 2.
/// Errors of the program itself have other types.
class InputError : public std::runtime_error {
  public:
    InputError(const Position& position, const std::string& message);
    /// Creates an error that concerns no file, such as an unknown option on the command line.
    explicit InputError(const std::string& message);
};

}  // namespace pendular
