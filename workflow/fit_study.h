#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "calib/fit/calibrate_study.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/store/run_store.h"
#include "workflow/fit_runs.h"
#include "workflow/listener.h"

namespace pendular {

/// Options for all computations on a study, such as fits and diagnoses: settings of the
/// simulations, seed, threads, store of the simulations, stop request, and listener (callback) for
/// progress reports.
struct SessionOptions {
    Fidelity fidelity;       ///< settings of the simulations, such as the number of grains
    std::uint64_t seed = 1;  ///< seed of simulations and of random draws of errors
    /// Largest number of threads for simulation runs and refits.
    int threads = 1;
    /// Store (the user's file of simulations), which keeps new runs and provides earlier runs.
    /// Null: no store is used.
    RunStore* store = nullptr;
    /// Training runs of an earlier result (option --runs-of), on which the emulator is trained in
    /// place of all runs of atlas and store. Null: atlas and store.
    std::shared_ptr<const TrainingRuns> training = nullptr;
    /// Request to stop, which ends a computation by the exception dem::Interrupted.
    std::stop_token stop = {};
    /// Callback that receives notes and progress reports. May be empty.
    Listener listener = {};
};

/// Options of the fit of a study's parameters.
struct FitOptions {
    /// Whether the fit is checked by new simulations at the fitted parameters. The emulator (which
    /// interpolates simulations) is then trained on the new runs too, and the fit is repeated until
    /// emulator and simulation agree.
    bool confirm = false;
    /// Time that the simulations which check the fit may take [s]. Empty: no limit.
    std::optional<double> confirming_seconds = {};
    /// Whether the fit simulates all runs on which its emulator is trained, and uses no run of the
    /// atlas (the simulations supplied with Pendular) or of the store (the user's file of
    /// simulations).
    bool cold = false;
    /// Whether the fit also computes the 68 % interval of the friction coefficient by its profile
    /// likelihood.
    bool profile = false;
    CohesionOptions cohesion = {};  ///< options of the Mohr-Coulomb lines through the wet readings
};

/// Whether a fit must simulate all runs on which its emulator (which interpolates simulations) is
/// trained. The runs must be simulated if `options.cold` is set, or if fewer than 20 runs of the
/// atlas (the simulations supplied with Pendular) and of the store (the user's file of simulations)
/// can train an emulator for the study.
bool begins_cold(const Study& study, const SessionOptions& session, const FitOptions& options);

/// Fits the parameters of a study's model to its readings by least squares. An emulator, which
/// interpolates simulations, predicts the readings. The emulator is trained on earlier runs, which
/// come from the atlas (the simulations supplied with Pendular) and from `session.store` (the
/// user's file of simulations). If `begins_cold` returns true, the fit simulates the runs instead.
/// @throws InputError if there is nothing to fit, if a reading cannot be simulated, if the study
///         has effects on grains but no earlier simulations exist, or if the atlas cannot be read
/// @throws dem::Interrupted if the user requests a stop; the message says how to continue
Calibration fit_study(const ResolvedStudy& study, const Measurements& measurements,
                      const SessionOptions& session, const FitOptions& options);

/// Returns the exception to throw after the user has stopped simulations. The message of the
/// exception names the file `store` of the user's simulations, which keeps the finished runs, and
/// says how to continue. If `store` is null, the message is the default message.
dem::Interrupted interrupted_with(const RunStore* store);

}  // namespace pendular
