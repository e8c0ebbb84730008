#pragma once

#include <cstdio>
#include <string_view>

namespace pendular::app {

/// Prints a line, made printable, and flushes the stream. All text of commands goes through here.
void print_line(std::FILE* stream, std::string_view text);

/// Prints an error message on standard error, after `prefix`, on one line of limited length.
void print_error(std::string_view prefix, std::string_view message);

/// Prints the message of the exception that is being handled. Returns the exit code of the program,
/// an `ExitCode`. To be called in a catch block.
int report_exception();

}  // namespace pendular::app
