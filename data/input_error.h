#pragma once

#include <stdexcept>
#include <string>

namespace pendular {

/// Position in a user's file. Lines and columns count from 1; 0: not known.
struct Position {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Text "file:line:column" without the parts that are unknown.
std::string to_string(const Position& position);

/// Error in the user's input: what() is "file:line:column: what is wrong; what to do". The program
/// prints it and ends with exit code 2. Broken invariants of the program itself are never reported
/// this way.
class InputError : public std::runtime_error {
  public:
    InputError(const Position& position, const std::string& message);
    explicit InputError(const std::string& message);
};

}  // namespace pendular
