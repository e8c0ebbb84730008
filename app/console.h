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
    /// Prints the notes that are still waiting.
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Prints the answer to the command's question, in bold on a terminal.
    void answer(const std::string& text);
    void line(const std::string& text);
    /// Prints a heading and at most `most_rows` rows below it, then how many rows --all would add.
    /// Rows that begin with "  (" explain the columns and are always printed.
    void table(const std::vector<std::string>& heading_and_rows, std::size_t most_rows);
    /// Keeps a note until the evidence is complete. Notes that differ in numbers and file names
    /// alone are printed once, with their count.
    void note(const std::string& text);
    /// Names the figures in a folder on one line.
    void figures(const std::filesystem::path& folder, const std::vector<std::string>& names);
    /// Prints the command that the user should give next; the last line of the output.
    void next(const std::string& command);
    /// Writes to the file that --json names, if it is given.
    void json(const nlohmann::ordered_json& json);

    /// Shows a bar with the time left: in place on a terminal, else a line every ten per cent and
    /// at most every ten seconds.
    void progress(const std::string& what, const EnsembleProgress& progress);
    void end_progress();
    /// Whether the user requested all rows and notes.
    bool all() const { return options_.all; }

  private:
    void print_notes();

    struct Note {
        std::string text, pattern;
        int count = 1;
    };
    const CommonOptions& options_;
    std::vector<Note> notes_;
    bool drawn_ = false;
    std::string stage_;           ///< of the last progress line
    double fraction_shown_ = -1;  ///< share of the work done at the last progress line [1]
    std::chrono::steady_clock::time_point last_{};
};

/// A text as a sentence: a capital at its beginning, unless a name stands there, and a full stop at
/// its end, unless a command stands there.
std::string as_sentence(std::string text);

/// Duration as text: "1 min 20 s", "3 h 5 min".
std::string duration(double seconds);

}  // namespace pendular::app
