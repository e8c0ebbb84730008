#include "app/open_session.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/stored_runs.h"
#include "app/terminal.h"
#include "reports/with_error.h"

namespace pendular::app {
namespace {

/// Listener that prints the events of a session on standard error; with --quiet, the notes only.
Listener shown_on(Console& console, bool quiet) {
    return [&console, quiet](const Event& event) {
        if (event.kind == Event::Kind::runs) return console.progress(event.text, event.runs);
        console.end_progress();
        if (event.kind == Event::Kind::note) {
            print_line(stderr, "Note: " + as_sentence(event.text));
        }
        if (quiet) return;
        if (event.kind == Event::Kind::stage) {
            print_line(stderr, as_sentence(event.text));
        }
        // A single fit is too short for a progress line.
        if (event.kind == Event::Kind::refits && event.number == 0 && event.total > 1) {
            print_line(stderr,
                       fmt::format("Diagnosis, {}: {} fits to do.", event.text, event.total));
        }
        if (event.kind == Event::Kind::round) {
            fmt::print(stderr, "Round {}: friction = {}.\n", event.number,
                       with_error(event.fit->parameters(0), event.fit->standard_error(0)));
        }
    };
}

}  // namespace

namespace {

/// Lock of the study for commands that change it; null for others.
std::unique_ptr<StudyLock> lock_of(const CommonOptions& options, OpenSession::Access access,
                                   const std::stop_token& stop) {
    if (access == OpenSession::Access::reads) return nullptr;
    return std::make_unique<StudyLock>(study_folder(options.study), stop);
}

}  // namespace

OutputPlaces places_of(const CommonOptions& options, std::vector<std::filesystem::path> files) {
    return {options.out_folder(), std::move(files), options.json};
}

void set_confirmation(const std::optional<double>& seconds, FitOptions& fit) {
    fit.confirm = seconds.has_value();
    fit.confirming_seconds = seconds && std::isfinite(*seconds) ? seconds : std::nullopt;
}

// The study is read after the lock is taken, so that no other command changes it. The store is
// opened after the input is checked, so that refused input creates no store.
OpenSession::OpenSession(Console& console, const CommonOptions& options,
                         std::vector<std::filesystem::path> files, std::int64_t seed, Access access)
    : lock_(lock_of(options, access, guard_.token())),
      input_(read_input(options.study, places_of(options, std::move(files)))),
      store_(open_store(options)),
      session_(std::move(input_),
               {.fidelity = options.fidelity,
                .seed = checked_seed(seed),
                .threads = options.threads,
                .store = store_.get(),
                .stop = guard_.token(),
                .listener = shown_on(console, options.quiet)},
               options.out_folder()) {}

}  // namespace pendular::app
