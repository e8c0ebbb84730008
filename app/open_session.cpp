#include "app/open_session.h"

#include <fmt/format.h>

#include <utility>

#include "app/stored_runs.h"
#include "reports/with_error.h"

namespace pendular::app {
namespace {

/// Shows on standard error what a session tells; no progress with --quiet.
Listener shown_on(Console& console, bool quiet) {
    return [&console, quiet](const Event& event) {
        switch (event.kind) {
            case Event::Kind::note:
                fmt::print(stderr, "note: {}\n", event.text);
                return;
            case Event::Kind::runs:
                console.progress(event.text, event.runs);
                return;
            case Event::Kind::round:
                console.end_progress();
                break;
            case Event::Kind::stage:
            case Event::Kind::refits:
                break;
        }
        if (quiet) return;
        if (event.kind == Event::Kind::stage) fmt::print(stderr, "{}\n", event.text);
        if (event.kind == Event::Kind::refits && event.number == 0)
            fmt::print(stderr, "{}: {}\n", event.text, event.total);
        if (event.kind == Event::Kind::round) {
            fmt::print(stderr, "round {}: friction = {}\n", event.number,
                       with_error(event.fit->parameters(0), event.fit->standard_error(0)));
        }
    };
}

}  // namespace

OutputPlaces places_of(const CommonOptions& options, std::vector<std::filesystem::path> files) {
    return {options.out_folder(), std::move(files), options.json};
}

OpenSession::OpenSession(Console& console, const CommonOptions& options,
                         std::vector<std::filesystem::path> files, std::int64_t seed)
    : store_(open_store(options)),
      session_(options.study,
               {.fidelity = options.fidelity,
                .seed = checked_seed(seed),
                .threads = options.threads,
                .store = store_.get(),
                .stop = guard_.token(),
                .listener = shown_on(console, options.quiet)},
               places_of(options, std::move(files))) {}

}  // namespace pendular::app
