#include "app/open_session.h"

#include <fmt/format.h>

#include <unistd.h>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

#include "app/stored_runs.h"
#include "app/terminal.h"
#include "data/quantities/number.h"
#include "reports/change_report.h"
#include "reports/words.h"
#include "sim/dem/run.h"
#include "workflow/json/diagnosis.h"

namespace pendular::app {
namespace {

using namespace std::chrono_literals;

/// Longest time to wait for another process.
std::chrono::duration<double> patience() {
    const char* const stated = std::getenv("PENDULAR_LOCK_SECONDS");
    return std::chrono::duration<double>(parse_number(stated ? stated : "").value_or(60));
}

}  // namespace

StudyLock::StudyLock(const std::filesystem::path& folder, const std::stop_token& stop) {
    if (access(folder.c_str(), W_OK) != 0) return;
    lock_.emplace(folder / ".study.toml.lock");
    const auto end = std::chrono::steady_clock::now() + patience();
    for (bool told = false; !lock_->take(); told = true) {
        if (std::chrono::steady_clock::now() > end) {
            throw std::runtime_error(fmt::format(
                "{} is held by {}, and nothing was changed: give the same command again "
                "once that one has ended",
                folder.string(), lock_->holder()));
        }
        if (!told) {
            print_line(stderr, fmt::format("Waiting for {}, which changes {}.", lock_->holder(),
                                           folder.string()));
        }
        if (stop.stop_requested()) throw dem::Interrupted();
        std::this_thread::sleep_for(50ms);
    }
}

namespace {

/// Listener that prints the events of a session on standard error; with --quiet, the notes only.
Listener shown_on(Console& console, bool quiet) {
    return [&console, quiet](const Event& event) {
        if (event.kind == Event::Kind::runs) return console.progress(event.text, event.runs);
        console.end_progress();
        if (event.kind == Event::Kind::note) {
            print_line(stderr, "Note: " + as_sentence(event.text));
        }
        if (quiet || event.kind == Event::Kind::note) return;
        // Of several fits, only the beginning is told.
        if (event.kind == Event::Kind::refits && event.number > 0) return;
        const std::string sentence = progress_sentence(event);
        if (!sentence.empty()) print_line(stderr, sentence);
    };
}

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
    : OpenSession(std::make_unique<InterruptGuard>(), {}, shown_on(console, options.quiet), options,
                  std::move(files), seed, access) {}

OpenSession::OpenSession(const std::stop_token& stop, const Listener& listener,
                         const CommonOptions& options, std::vector<std::filesystem::path> files,
                         std::int64_t seed, Access access)
    : OpenSession(nullptr, stop, listener, options, std::move(files), seed, access) {}

OpenSession::OpenSession(std::unique_ptr<InterruptGuard> guard, const std::stop_token& stop,
                         const Listener& listener, const CommonOptions& options,
                         std::vector<std::filesystem::path> files, std::int64_t seed, Access access)
    : guard_(std::move(guard)),
      lock_(lock_of(options, access, guard_ ? guard_->token() : stop)),
      input_(read_input(options.study, places_of(options, std::move(files)))),
      store_(open_store(options)),
      session_(std::move(input_),
               {.fidelity = options.fidelity,
                .seed = checked_seed(seed),
                .threads = options.threads,
                .store = store_.get(),
                .training = training_runs(options, store_.get()),
                .stop = guard_ ? guard_->token() : stop,
                .listener = listener},
               options.out_folder()) {}

std::vector<std::filesystem::path> outputs_of_change() {
    return {"fit.json", "fit_runs.csv", "ladder.json", "figures"};
}

ChangedStudy change_effects(Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity) {
    ChangeOptions options{.fit = fit, .same_fidelity = same_fidelity};
    if (action == Action::drop) return session.drop(effect, options);
    options.rivals = rivals_in(session.folder() / "diagnosis.json", session.study(), effect);
    return session.add(effect, options);
}

}  // namespace pendular::app
