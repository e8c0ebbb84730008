#pragma once

#include <cstdio>
#include <string_view>

namespace pendular::app {

/// Prints a line with all unprintable characters replaced, and flushes the stream. All lines of
/// text of results, notes and error messages are printed by this function; JSON, help texts and
/// progress bars are not.
void print_line(std::FILE* stream, std::string_view text);

/// Prints an error message after `prefix` on standard error. The middle of a message longer than
/// 4000 bytes is left out.
void print_error(std::string_view prefix, std::string_view message);

/// Prints the message of the exception that is being handled, and returns the exit code of the
/// program (`ExitCode`). The function may be called in a catch block only.
int report_exception();

}  // namespace pendular::app
