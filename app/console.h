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

/// Prints a command's output in a fixed order: the answer, the evidence, the notes, the figures,
/// the next command. Text goes to standard output, or to standard error where JSON takes standard
/// output. Progress goes to standard error unless --quiet is given. Bold type appears on a terminal
/// only, and never if NO_COLOR is set.
class Console {
  public:
    explicit Console(const CommonOptions& options) : options_(options) {}
    /// Ends the progress line and prints the notes that were not printed yet.
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Prints the answer to the command's question, in bold on a terminal.
    void answer(const std::string& text);
    /// Prints one line of text.
    void line(const std::string& text);
    /// Prints a heading and at most `most_rows` rows below it, or all rows with --all; then the
    /// number of hidden rows. Rows that begin with "  (" explain the columns and are always
    /// printed.
    void table(const std::vector<std::string>& heading_and_rows, std::size_t most_rows);
    /// Keeps a note, which is printed after the evidence. Without --all, notes that differ only in
    /// numbers and file names are printed once, with their number.
    void note(const std::string& text);
    /// Prints the notes, then one line with the names of the figures in a folder.
    void figures(const std::filesystem::path& folder, const std::vector<std::string>& names);
    /// Prints the notes, then the command that the user should give next, as the last line.
    void next(const std::string& command);
    /// Writes JSON to the file that --json names, or to standard output for "-"; nothing without
    /// --json.
    void json(const nlohmann::ordered_json& json);

    /// Prints a progress bar with the time left, for the work that `what` names: on a terminal
    /// always on the same line, else a line every ten per cent and at most every ten seconds.
    void progress(const std::string& what, const EnsembleProgress& progress);
    /// Removes the progress bar from a terminal.
    void end_progress();
    /// Whether the user requested all rows and notes.
    bool all() const { return options_.all; }

  private:
    void print_notes();

    /// Note with its pattern: the text without numbers and file names, equal for similar notes.
    struct Note {
        std::string text, pattern;
        int count = 1;  ///< number of notes with this pattern
    };
    const CommonOptions& options_;
    std::vector<Note> notes_;
    bool drawn_ = false;          ///< whether a progress bar is on the terminal
    std::string stage_;           ///< name of the work in the last progress line
    double fraction_shown_ = -1;  ///< share of the work done at the last progress line [1]
    std::chrono::steady_clock::time_point last_{};
};

/// Text as a sentence: with a capital at its beginning, unless its first word is a name, and with a
/// full stop at its end, unless it ends in a command.
std::string as_sentence(std::string text);

/// Text of a duration [s]: "40 s", "1 min 20 s", "3 h 5 min".
std::string duration(double seconds);

}  // namespace pendular::app
