#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "calib/fit/calibrate_study.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/store/run_store.h"
#include "workflow/json/training_runs.h"
#include "workflow/listener.h"

namespace pendular {

/// Options for all computations on a study, such as fits and diagnoses.
struct SessionOptions {
    Fidelity fidelity;          ///< settings of the simulations, such as the number of grains
    std::uint64_t seed = 1;     ///< seed of simulations and of random draws of errors
    int threads = 1;            ///< largest number of threads for simulation runs and refits
    RunStore* store = nullptr;  ///< keeps new runs and provides earlier runs; null: no store
    /// Runs on which the emulator is trained (option --runs-of); null: all of atlas and store.
    std::shared_ptr<const TrainingRuns> training = nullptr;
    std::stop_token stop = {};  ///< ends a computation by dem::Interrupted
    Listener listener = {};     ///< receives notes and progress reports; may be empty
};

/// Options of the fit of a study's parameters.
struct FitOptions {
    /// Whether the fit is checked by new simulations at the fitted parameters. The emulator is then
    /// trained on them too, and the fit repeated until emulator and simulation agree.
    bool confirm = false;
    std::optional<double> confirming_seconds = {};  ///< limit for these simulations [s]
    /// Whether all training runs are simulated, and no run of atlas or store is used; a fit that is
    /// repeated (`SessionOptions::training`) takes its own runs from the store.
    bool cold = false;
    /// Whether to compute the 68 % interval of each parameter by its profile likelihood.
    bool profile = false;
    CohesionOptions cohesion = {};  ///< Mohr-Coulomb lines through the wet readings
};

/// Whether a fit must simulate its training runs: `options.cold` is set, the result to repeat began
/// without runs, or atlas and store have fewer than 20 runs that can train an emulator for the
/// study.
bool begins_cold(const Study& study, const SessionOptions& session, const FitOptions& options);

/// Fits the parameters of a study's model to its readings by least squares. An emulator predicts
/// the readings. It is trained on `session.training` or, if null, on the runs of the atlas and of
/// `session.store`; if `begins_cold`, on new runs.
/// @throws InputError if there is nothing to fit, if a reading cannot be simulated, if the study
///         has effects on grains but no earlier simulations exist, or if the atlas cannot be read
/// @throws dem::Interrupted if the user requests a stop; the message says how to continue
Calibration fit_study(const ResolvedStudy& study, const Measurements& measurements,
                      const SessionOptions& session, const FitOptions& options);

/// Returns the exception to throw after the user has stopped simulations. Its message names the
/// file of `store`, which keeps the finished runs, and says how to continue; if `store` is null, it
/// is the default message.
dem::Interrupted interrupted_with(const RunStore* store);

}  // namespace pendular
