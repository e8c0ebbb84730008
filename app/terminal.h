#pragma once

#include <cstdio>
#include <stop_token>
#include <string_view>
#include <thread>

namespace pendular::app {

/// Prints a line with all unprintable characters replaced, and flushes the stream. Results, notes
/// and error messages are printed so; JSON, help texts and progress bars are not.
void print_line(std::FILE* stream, std::string_view text);

/// Whether the program that read the printed lines ended before all were written, as 'head' does.
/// The command then goes on without a word, since its files are wanted.
bool reader_has_left();

/// Prints an error message on standard error. The middle of a message longer than 4000 bytes is
/// left out.
void print_error(std::string_view prefix, std::string_view message);

/// Prints the message of the exception that is being handled, and returns the `ExitCode`. May be
/// called in a catch block only.
int report_exception();

/// Turns the signals SIGINT (Ctrl-C), SIGTERM and SIGHUP into a request to stop, so that long
/// computations end in order and leave no half-written file. The program ends at most 20 s after
/// the first signal, even if a computation does not check `token`. A second signal ends it at once.
class InterruptGuard {
  public:
    InterruptGuard();
    /// Returns the token that long computations must check. A stop is requested within about 50 ms
    /// of the first signal.
    std::stop_token token() const { return stop_.get_token(); }

  private:
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace pendular::app
