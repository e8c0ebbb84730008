#pragma once

#include <stdexcept>
#include <string>

namespace pendular {

/// Position in a user's file. Lines and columns count from 1; 0: unknown.
struct Position {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Text "file:line:column" of a position; an unknown line and an unknown column are left out.
std::string to_string(const Position& position);

/// Error in the user's input: what() is "file:line:column: what is wrong; what to do". The program
/// prints the message and ends with exit code 2. Errors of the program itself, such as a violated
/// invariant, never use this class.
class InputError : public std::runtime_error {
  public:
    InputError(const Position& position, const std::string& message);
    /// Error that belongs to no file, on the command line for example.
    explicit InputError(const std::string& message);
};

}  // namespace pendular
