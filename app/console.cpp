#include "app/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "data/files/json_text.h"
#include "workflow/json.h"

namespace pendular::app {

void Console::line(const std::string& text) {
    end_progress();
    const bool json_on_output = options_.json == "-";
    fmt::print(json_on_output ? stderr : stdout, "{}\n", text);
    std::fflush(json_on_output ? stderr : stdout);
}

void Console::note(const std::string& text) {
    line("note: " + text);
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
    if (now - last_ < std::chrono::milliseconds(terminal ? 200 : 10000)) {
        return;
    }
    last_ = now;
    drawn_ = terminal;
    const std::string left =
        progress.seconds_left > 0 ? ", " + duration(progress.seconds_left) + " left" : "";
    const std::string text =
        fmt::format("{}: {} of {} runs done, {:.0f} %{}", what, progress.runs_done, progress.runs,
                    100 * progress.fraction, left);
    fmt::print(stderr, "{}{}{}", terminal ? "\r\033[K" : "", text, terminal ? "" : "\n");
}

void Console::end_progress() {
    if (drawn_) {
        fmt::print(stderr, "\r\033[K");
        drawn_ = false;
    }
}

std::string duration(double seconds) {
    const auto s = static_cast<long>(std::lround(seconds));
    if (s < 60) {
        return fmt::format("{} s", s);
    }
    return s < 3600 ? fmt::format("{} min {} s", s / 60, s % 60)
                    : fmt::format("{} h {} min", s / 3600, s / 60 % 60);
}

}  // namespace pendular::app
