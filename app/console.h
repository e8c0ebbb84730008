#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/options.h"
#include "reports/figure.h"
#include "reports/output.h"
#include "reports/with_error.h"
#include "sim/runs/ensemble.h"

namespace pendular::app {

/// Printer of a command's output: the answer, the evidence, the notes, the figures, the next
/// command. Text goes to standard output or, with --json -, to standard error; progress to standard
/// error, but not with --quiet. Bold type appears on a terminal only, and never if NO_COLOR is set.
class Console {
  public:
    explicit Console(const CommonOptions& options) : options_(options) {}
    /// Removes the progress bar from a terminal, and prints the notes that have not been printed.
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Prints the command's main result, one or more sentences, in bold on a terminal.
    void answer(const std::string& text);
    void line(const std::string& text);
    /// Prints a table: a heading, then at most `most_rows` rows, or all rows with --all, then the
    /// number of hidden rows. Rows that begin with "  (" explain the columns, and are always
    /// printed, below the table.
    void table(const std::vector<std::string>& heading_and_rows, std::size_t most_rows);
    void print(const Output& output);
    /// Stores a remark, which is printed as "Note: ..." before the figures and the next command.
    /// Without --all, at most three notes are printed, then the number of hidden notes; notes that
    /// differ only in words with digits count as one, of which the first is printed.
    void note(const std::string& text);
    /// Prints the stored notes, draws figures (`draw`), and prints one line with their files. If
    /// gnuplot is not installed, writes the numbers of the figures as CSV and says so.
    /// @throws std::runtime_error as `draw`, if gnuplot is installed
    void figures(const std::filesystem::path& folder, const std::vector<Figure>& figures);
    /// Prints the stored notes, then the line "Next: ..." with the command to give next.
    void next(const std::string& command);
    /// Writes the command's result to the file of --json, or to standard output for "-". Does
    /// nothing without --json.
    void json(const nlohmann::ordered_json& json);

    /// Prints the progress of the simulations `what` as a bar with the time left. A terminal shows
    /// one line that changes. Elsewhere, a new line is printed for every ten per cent, but at most
    /// every ten seconds. Prints nothing with --quiet.
    void progress(const std::string& what, const EnsembleProgress& progress);
    /// Removes the progress bar from a terminal.
    void end_progress();
    /// Whether the user gave --all, which prints all rows of tables and all notes.
    bool all() const { return options_.all; }

  private:
    void print_notes();

    /// Remark with its pattern: the text with "#" in place of each word that contains a digit.
    struct Note {
        std::string text, pattern;
        int count = 1;  ///< stored notes of this pattern
    };
    const CommonOptions& options_;
    std::vector<Note> notes_;
    bool drawn_ = false;          ///< whether the terminal shows a progress bar
    std::string stage_;           ///< simulations in the last progress line that was printed
    double fraction_shown_ = -1;  ///< share done in that line [1]; -1: no line yet
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace pendular::app
