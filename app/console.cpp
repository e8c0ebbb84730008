#include "app/console.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/terminal.h"
#include "data/files/json_text.h"
#include "data/files/write_whole.h"
#include "reports/draw_figure.h"
#include "reports/words.h"
#include "workflow/json/parts.h"

namespace pendular::app {
namespace {

constexpr std::size_t most_notes = 3;  ///< largest number of notes that are printed without --all

/// Whether one of the folders of $PATH has the program gnuplot.
bool has_gnuplot() {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((std::filesystem::path(folder) / "gnuplot").c_str(), X_OK) == 0) return true;
    }
    return false;
}

/// Writes the numbers of figures, and returns the names of the figures that have any.
std::vector<std::string> write_numbers(const std::vector<Figure>& figures,
                                       const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) {
        if (figure.panels.empty()) continue;
        std::filesystem::create_directories(folder);
        write_whole(folder / (figure.name + ".csv"), numbers_table(figure));
        names.push_back(figure.name);
    }
    return names;
}

/// Text of a note with "#" for each word that contains a digit, such as numbers and file names.
/// Notes with equal patterns are printed once.
std::string pattern_of(const std::string& text) {
    std::string pattern, word;
    for (const char c : text + " ") {
        if (c != ' ') {
            word += c;
            continue;
        }
        const bool varies =
            std::ranges::any_of(word, [](unsigned char each) { return std::isdigit(each) != 0; });
        pattern += (varies ? "#" : word) + " ";
        word.clear();
    }
    return pattern;
}

bool is_legend(const std::string& row) {
    return row.starts_with("  (");
}

/// Progress bar "[#####.....]" for the share of the work that is done [1].
std::string bar(double fraction) {
    constexpr int width = 24;  // leaves room for the text on a terminal of 80 columns
    const auto done = static_cast<int>(std::floor(std::clamp(fraction, 0.0, 1.0) * width));
    return "[" + std::string(static_cast<std::size_t>(done), '#') +
           std::string(static_cast<std::size_t>(width - done), '.') + "]";
}

}  // namespace

Console::~Console() {
    end_progress();
    print_notes();
}

void Console::answer(const std::string& text) {
    const bool bold =
        options_.json != "-" && isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
    if (bold) fmt::print("\033[1m");
    line(text);
    if (bold) fmt::print("\033[0m");
}

void Console::line(const std::string& text) {
    end_progress();
    print_line(options_.json == "-" ? stderr : stdout, text);
}

void Console::table(const std::vector<std::string>& heading_and_rows, std::size_t most_rows) {
    std::size_t rows = 0, hidden = 0;
    for (std::size_t k = 0; k < heading_and_rows.size(); ++k) {
        const std::string& row = heading_and_rows[k];
        if (is_legend(row)) continue;
        if (k > 0 && ++rows > most_rows && !all()) {
            ++hidden;
            continue;
        }
        line(row);
    }
    if (hidden > 0) {
        line(fmt::format("  ... {} more row{} (option --all)", hidden, hidden == 1 ? "" : "s"));
    }
    for (const std::string& row : heading_and_rows) {
        if (is_legend(row)) line(row);
    }
}

void Console::print(const Output& output) {
    for (const Output::Part& part : output.parts()) {
        switch (part.kind) {
            case Output::Kind::answer:
                answer(part.lines.front());
                break;
            case Output::Kind::line:
                line(part.lines.front());
                break;
            case Output::Kind::table:
                table(part.lines, part.most_rows);
                break;
            case Output::Kind::note:
                note(part.lines.front());
        }
    }
}

void Console::note(const std::string& text) {
    const std::string pattern = pattern_of(text);
    const auto same = std::ranges::find(notes_, pattern, &Note::pattern);
    if (same == notes_.end() || (all() && same->text != as_sentence(text))) {
        notes_.push_back({as_sentence(text), pattern});
    } else if (same->text != as_sentence(text)) {
        ++same->count;
    }
}

void Console::print_notes() {
    const std::size_t shown = all() ? notes_.size() : std::min(notes_.size(), most_notes);
    for (std::size_t k = 0; k < shown; ++k) {
        const Note& note = notes_[k];
        line("Note: " + note.text +
             (note.count > 1 ? fmt::format(" ({} more such notes, option --all)", note.count - 1)
                             : ""));
    }
    if (shown < notes_.size()) {
        const std::size_t hidden = notes_.size() - shown;
        line(fmt::format("Note: {} more note{} (option --all)", hidden, hidden == 1 ? "" : "s"));
    }
    notes_.clear();
}

void Console::figures(const std::filesystem::path& folder, const std::vector<Figure>& figures) {
    print_notes();
    const bool drawing = has_gnuplot();
    const auto names = drawing ? draw_all(figures, folder) : write_numbers(figures, folder);
    if (names.empty()) return;
    if (!drawing) {
        line(
            fmt::format("No figures were drawn, since gnuplot is not installed. Their numbers in "
                        "{}, as CSV: {}.",
                        folder.string(), fmt::join(names, ", ")));
    } else if (names.size() == 1) {
        line(fmt::format("Figure: {}", (folder / (names.front() + ".png")).string()));
    } else {
        line(fmt::format("Figures in {}, each as PNG, SVG, PDF and CSV: {}.", folder.string(),
                         fmt::join(names, ", ")));
    }
}

void Console::next(const std::string& command) {
    print_notes();
    line("Next: " + command);
}

void Console::json(const nlohmann::ordered_json& json) {
    if (!options_.json) {
        return;
    }
    if (*options_.json == "-") {
        fmt::print("{}", json_text(json));
    } else {
        write_json(*options_.json, json);
    }
}

void Console::progress(const std::string& what, const EnsembleProgress& progress) {
    if (options_.quiet) {
        return;
    }
    const bool terminal = isatty(STDERR_FILENO) != 0;
    const auto now = std::chrono::steady_clock::now();
    const bool same_stage = stage_ == what && progress.fraction >= fraction_shown_;
    // Without a terminal, a new line is printed for each ten per cent of a stage.
    if (now - last_ < std::chrono::milliseconds(terminal ? 200 : 10000) ||
        (!terminal && same_stage && progress.fraction < fraction_shown_ + 0.1)) {
        return;
    }
    last_ = now;
    drawn_ = terminal;
    stage_ = what;
    fraction_shown_ = progress.fraction;
    const std::string text =
        fmt::format("{} {} {}", what, bar(progress.fraction), progress_numbers(progress));
    fmt::print(stderr, "{}{}{}", terminal ? "\r\033[K" : "", text, terminal ? "" : "\n");
}

void Console::end_progress() {
    if (drawn_) {
        fmt::print(stderr, "\r\033[K");
        drawn_ = false;
    }
}

}  // namespace pendular::app
