#include "workflow/fit_study.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "workflow/study_input.h"

namespace pendular {
namespace {

/// Request for a calibration. With earlier runs, new runs at the optimum confirm the fit if that is
/// requested; without earlier runs, one more round confirms the fit.
CalibrationRequest request_for(std::optional<KnownRuns> known, const SessionOptions& session,
                               const FitOptions& options) {
    CalibrationRequest request{
        .fidelity = session.fidelity,
        .seed = session.seed,
        .profile = options.profile,
        .budget = options.confirming_seconds ? RunBudget(*options.confirming_seconds) : RunBudget(),
        .cohesion = options.cohesion};
    if (!known) {
        // The few runs of a first design tell hyperparameters badly; those of the atlas serve. One
        // round less is needed where nobody asks to confirm the fit.
        request.known.hyperparameters = atlas_hyperparameters();
        request.options.fewest_rounds -= !options.confirm;
        return request;
    }
    request.known = std::move(*known);
    request.known.may_simulate = options.confirm;
    // The first round of runs fills gaps of the known range; the second checks the emulator at the
    // optimum (`RunPlanner::improve`).
    request.options.fewest_rounds = 2;
    if (!options.confirm) request.options.fewest_rounds = request.options.most_rounds = 1;
    return request;
}

/// Runs that exist before a fit; empty where the fit simulates all its runs. A fit that is repeated
/// begins with the runs that existed before it, and orders the others again, which are in the store
/// by now: the emulators of its rounds, and so the last bits of the result, are the same.
std::optional<KnownRuns> runs_before(const Study& study, const SessionOptions& session,
                                     const FitOptions& options) {
    if (options.cold) return std::nullopt;
    if (!session.training)
        return known_runs(study, session.fidelity, session.store, session.listener);
    const auto& [runs, began_with] = *session.training;
    if (began_with == 0) return std::nullopt;
    return KnownRuns{{runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(began_with)},
                     atlas_hyperparameters()};
}

/// Name of a round of simulations, whose share that is done begins at 0 again.
/// @param total least number of rounds
std::string name_of_round(std::size_t round, std::size_t total) {
    if (total < 2) return fmt::format("round {}", round);
    return round <= total ? fmt::format("round {} of at least {}", round, total)
                          : fmt::format("round {}, as the fit needs more simulations", round);
}

}  // namespace

bool begins_cold(const Study& study, const SessionOptions& session, const FitOptions& options) {
    SessionOptions silent = session;
    silent.listener = {};
    return !runs_before(study, silent, options);
}

Calibration fit_study(const ResolvedStudy& study, const Measurements& measurements,
                      const SessionOptions& session, const FitOptions& options) {
    CalibrationRequest request =
        request_for(runs_before(study, session, options), session, options);
    EnsembleProgress of_round;
    const bool has_time = request.budget.seconds_left() > 0;  // a limit may be 0
    const auto total = has_time ? static_cast<std::size_t>(request.options.fewest_rounds) : 1;
    std::string stage = name_of_round(1, total);
    request.stage = [&](std::string_view name) { stage = name; };
    // A repeated fit reads its own runs from the store, even if it was cold.
    const Workers workers{session.threads, session.stop,
                          [&](const EnsembleProgress& progress) {
                              of_round = progress;
                              tell(session.listener,
                                   {.kind = Event::Kind::runs, .text = stage, .runs = progress});
                          },
                          session.store, !options.cold || session.training};
    const auto report = [&](int round, const Fit& fit) {
        tell(session.listener, {.kind = Event::Kind::round,
                                .runs = std::exchange(of_round, {}),
                                .number = static_cast<std::size_t>(round),
                                .total = total,
                                .fit = &fit});
        stage = name_of_round(static_cast<std::size_t>(round) + 1, total);
    };
    try {
        return calibrate_study(study, measurements, request, workers, report);
    } catch (const dem::Interrupted&) {
        throw interrupted_with(session.store);
    }
}

dem::Interrupted interrupted_with(const RunStore* store) {
    if (!store) return dem::Interrupted();
    return dem::Interrupted(fmt::format(
        "the finished simulations are in {}; give the same command again to continue, with the "
        "unfinished simulations from where they stopped",
        store->file().string()));
}

}  // namespace pendular
