#pragma once

#include <cstdint>
#include <stop_token>

#include "calib/fit/calibrate_study.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Options for all work on a study: how to simulate, and who receives progress reports.
struct SessionOptions {
    Fidelity fidelity;       ///< settings of the simulations
    std::uint64_t seed = 1;  ///< seed of simulations and of random draws of errors
    int threads = 1;         ///< number of threads for runs and refits
    /// User's file of runs, which keeps new runs and provides earlier runs; null: no store.
    RunStore* store = nullptr;
    std::stop_token stop = {};  ///< stops long work on request
    Listener listener = {};     ///< receives notes and progress; may be empty
};

/// Options of the fit of a study.
struct FitOptions {
    /// Whether new runs at the optimum check the fit, until prediction and simulation agree.
    bool confirm = false;
    /// Whether the fit uses no runs of the atlas or the store and simulates all its training runs.
    bool cold = false;
    bool profile = false;  ///< whether to compute the friction's profile likelihood interval too
    CohesionOptions cohesion = {};  ///< options of the cohesion lines
};

/// Whether a fit begins without any training run: because the options request it, or because too
/// few runs of the atlas and the store can serve the study.
bool begins_cold(const Study& study, const SessionOptions& session, const FitOptions& options);

/// Calibrates a study with an emulator, trained on the runs of atlas and store where enough of them
/// can serve the study, else on a new design of runs.
/// @throws InputError where there is nothing to fit, where a reading cannot be simulated, where
///         the study has effects on grains but no known runs, and where the atlas cannot be read
/// @throws dem::Interrupted where the user stops the work, with how to continue
Calibration fit_study(const ResolvedStudy& study, const Measurements& measurements,
                      const SessionOptions& session, const FitOptions& options);

/// Exception for stopped work. Its message names the file of the store, which keeps the finished
/// runs, and how to continue; `store` may be null.
dem::Interrupted interrupted_with(const RunStore* store);

}  // namespace pendular
