#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/options.h"
#include "reports/with_error.h"
#include "sim/runs/ensemble.h"

namespace pendular::app {

/// Printer of a command's output: the answer, the evidence, the notes, the figures, the next
/// command. Text goes to standard output or, if the option --json - sends JSON to standard output,
/// to standard error. Progress goes to standard error unless --quiet is given. Bold type appears on
/// a terminal only, and never if NO_COLOR is set.
class Console {
  public:
    explicit Console(const CommonOptions& options) : options_(options) {}
    /// Removes the progress bar from a terminal, and prints the notes that have not been printed.
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Prints the command's main result, one or more sentences, in bold on a terminal.
    void answer(const std::string& text);
    /// Prints one line of text on standard output, or on standard error with --json -.
    void line(const std::string& text);
    /// Prints a table: a heading, then at most `most_rows` rows, or all rows with --all, then the
    /// number of hidden rows. Rows that begin with "  (" explain the columns. Explaining rows are
    /// always printed, below the table.
    void table(const std::vector<std::string>& heading_and_rows, std::size_t most_rows);
    /// Stores a remark for the user, which is printed as "Note: ..." before the figures and the
    /// next command. Without --all, at most three notes are printed, then the number of hidden
    /// notes. Notes that differ only in words with digits then count as one: only the first of
    /// these notes is printed, with the number of further notes.
    void note(const std::string& text);
    /// Prints the stored notes, then one line with the names of the figure files in `folder`.
    /// @param names names of the figures, without extension; if the list is empty, only the notes
    ///        are printed
    void figures(const std::filesystem::path& folder, const std::vector<std::string>& names);
    /// Prints the stored notes, then the line "Next: ..." with the command that the user should
    /// give next.
    void next(const std::string& command);
    /// Writes the command's result as JSON to the file that option --json names, or to standard
    /// output for "-". Does nothing without --json.
    void json(const nlohmann::ordered_json& json);

    /// Prints the progress of simulations as a bar with the time left. A terminal shows one line
    /// that changes. Without a terminal, a new line is printed for every ten per cent, but at most
    /// every ten seconds. Prints nothing with --quiet.
    /// @param what name of the simulations, printed before the bar
    void progress(const std::string& what, const EnsembleProgress& progress);
    /// Removes the progress bar from a terminal.
    void end_progress();
    /// Whether the user gave --all, which prints all rows of tables and all notes.
    bool all() const { return options_.all; }

  private:
    void print_notes();

    /// Note for the user, with the pattern of the note. The pattern is the text with "#" in place
    /// of each word that contains a digit, such as a number or file name. Without --all, only one
    /// of the notes with equal patterns is printed.
    struct Note {
        std::string text, pattern;
        /// Number of stored notes that have this pattern.
        int count = 1;
    };
    const CommonOptions& options_;
    std::vector<Note> notes_;
    /// Whether the terminal shows a progress bar.
    bool drawn_ = false;
    /// Name of the simulations in the last progress line that was printed.
    std::string stage_;
    /// Share of the simulations that was done when the last progress line was printed [1]; -1: no
    /// line was printed.
    double fraction_shown_ = -1;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace pendular::app
