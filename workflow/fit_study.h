#pragma once

#include <cstdint>
#include <stop_token>

#include "calib/fit/calibrate_study.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// How simulations of a study are made, and whom to tell.
struct SessionOptions {
    Fidelity fidelity;
    std::uint64_t seed = 1;
    int threads = 1;
    RunStore* store = nullptr;  ///< keeps new runs and knows earlier ones; none: neither
    std::stop_token stop = {};
    Listener listener = {};
};

/// Options of a fit.
struct FitOptions {
    bool confirm = false;  ///< by fresh runs at the optimum, until prediction and simulation agree
    bool cold = false;     ///< from neither the atlas nor earlier runs: all of its own
    bool profile = false;  ///< profile likelihood interval of the friction as well
    CohesionOptions cohesion = {};
};

/// Whether a fit begins without any known run: it was asked to, or too few can serve the study.
bool begins_cold(const Study& study, const SessionOptions& session, const FitOptions& options);

/// Calibrates a study, emulated from known runs where there are enough of them, else from a design
/// of runs of its own.
/// @throws InputError as calibrate_study; dem::Interrupted with how to go on
Calibration fit_study(const ResolvedStudy& study, const Measurements& measurements,
                      const SessionOptions& session, const FitOptions& options);

/// Interruption of work that keeps its runs; `store` may be null.
dem::Interrupted interrupted_with(const RunStore* store);

}  // namespace pendular
