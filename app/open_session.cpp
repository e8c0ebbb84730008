#include "app/open_session.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/stored_runs.h"
#include "reports/with_error.h"

namespace pendular::app {
namespace {

/// Listener that prints the events of a session on standard error; with --quiet, the notes only.
Listener shown_on(Console& console, bool quiet) {
    return [&console, quiet](const Event& event) {
        if (event.kind == Event::Kind::runs) return console.progress(event.text, event.runs);
        console.end_progress();
        if (event.kind == Event::Kind::note) {
            fmt::print(stderr, "Note: {}\n", as_sentence(event.text));
        }
        if (quiet) return;
        if (event.kind == Event::Kind::stage) {
            fmt::print(stderr, "{}\n", as_sentence(event.text));
        }
        // A single fit is too short for a progress line.
        if (event.kind == Event::Kind::refits && event.number == 0 && event.total > 1) {
            fmt::print(stderr, "Diagnosis, {}: {} fits to do.\n", event.text, event.total);
        }
        if (event.kind == Event::Kind::round) {
            fmt::print(stderr, "Round {}: friction = {}.\n", event.number,
                       with_error(event.fit->parameters(0), event.fit->standard_error(0)));
        }
    };
}

}  // namespace

OutputPlaces places_of(const CommonOptions& options, std::vector<std::filesystem::path> files) {
    return {options.out_folder(), std::move(files), options.json};
}

void set_confirmation(const std::optional<double>& seconds, FitOptions& fit) {
    fit.confirm = seconds.has_value();
    fit.confirming_seconds = seconds && std::isfinite(*seconds) ? seconds : std::nullopt;
}

OpenSession::OpenSession(Console& console, const CommonOptions& options,
                         std::vector<std::filesystem::path> files, std::int64_t seed)
    : OpenSession(console, options, read_input(options.study, places_of(options, std::move(files))),
                  checked_seed(seed)) {}

// The store is opened after the input is checked, so that refused input creates no store.
OpenSession::OpenSession(Console& console, const CommonOptions& options, StudyInput input,
                         std::uint64_t seed)
    : store_(open_store(options)),
      session_(std::move(input),
               {.fidelity = options.fidelity,
                .seed = seed,
                .threads = options.threads,
                .store = store_.get(),
                .stop = guard_.token(),
                .listener = shown_on(console, options.quiet)},
               options.out_folder()) {}

}  // namespace pendular::app
