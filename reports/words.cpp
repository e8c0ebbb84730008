#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "reports/with_error.h"

namespace pendular {
namespace {

bool is_lower_case_word(const std::string& word) {
    return !word.empty() &&
           std::ranges::all_of(word, [](unsigned char c) { return std::islower(c) != 0; });
}

}  // namespace

std::string as_sentence(std::string text) {
    if (text.empty()) return text;
    if (is_lower_case_word(text.substr(0, text.find(' ')))) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    const std::size_t command = text.rfind(": pendular ");
    const bool ends_in_command =
        command != std::string::npos && text.find(". ", command) == std::string::npos;
    const bool ended = text.ends_with('.') || text.ends_with('?') || text.ends_with('\n');
    return ended || ends_in_command ? text : text + ".";
}

std::string duration(double seconds) {
    const auto s = static_cast<long>(std::lround(seconds));
    if (s < 60) {
        return fmt::format("{} s", s);
    }
    return s < 3600 ? fmt::format("{} min {} s", s / 60, s % 60)
                    : fmt::format("{} h {} min", s / 3600, s / 60 % 60);
}

namespace {

/// Fit at the end of a round. The first of several, where no simulation was made for it, is the
/// answer that a user need not wait for.
std::string round_sentence(const Event& event) {
    const std::string friction = fmt::format("friction = {}", estimate_text(*event.fit, 0, "1"));
    return event.number == 1 && event.total > 1 && event.runs.runs == 0
               ? fmt::format("From earlier simulations: {}. New simulations check this fit now.",
                             friction)
               : fmt::format("Round {}: {}.", event.number, friction);
}

}  // namespace

std::string progress_sentence(const Event& event) {
    switch (event.kind) {
        case Event::Kind::stage:
            return as_sentence(event.text);
        case Event::Kind::runs:
            return as_sentence(event.text + ": " + progress_numbers(event.runs));
        case Event::Kind::round:
            return round_sentence(event);
        case Event::Kind::refits:  // a single fit is too short to be told
            return event.total < 2
                       ? ""
                       : fmt::format("Diagnosis, {}: {} fits to do.", event.text, event.total);
        case Event::Kind::note:
            return "";
    }
    return "";
}

std::optional<double> progress_share(const Event& event) {
    if (event.kind == Event::Kind::runs) return event.runs.fraction;
    if (event.kind == Event::Kind::refits && event.total > 0)
        return static_cast<double>(event.number) / static_cast<double>(event.total);
    return std::nullopt;
}

std::string progress_numbers(const EnsembleProgress& progress) {
    std::string text = fmt::format("{:.0f} %, {} of {} simulations done", 100 * progress.fraction,
                                   progress.runs_done, progress.runs);
    if (progress.seconds_left > 0) text += ", " + duration(progress.seconds_left) + " left";
    return text;
}

std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

}  // namespace pendular
