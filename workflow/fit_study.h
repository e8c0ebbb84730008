#pragma once

#include <cstdint>
#include <stop_token>

#include "calib/calibrate_study.h"
#include "sim/dem/simulation_error.h"
#include "sim/store/run_store.h"
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

/// What a fit rests on.
struct FitOptions {
    bool confirm = false;  ///< by fresh runs at the optimum, until prediction and simulation agree
    bool cold = false;     ///< by direct simulation alone, from neither the atlas nor earlier runs
    bool profile = false;  ///< profile likelihood interval of the friction as well
    CohesionOptions cohesion = {};
};

/// Calibrates a study: emulated from known runs where there are enough of them, else by direct
/// simulation.
/// @throws InputError as calibrate_study; dem::Interrupted with how to go on
Calibration fit_study(const Study& study, const Measurements& measurements,
                      const SessionOptions& session, const FitOptions& options);

/// What is said where work that keeps its runs is interrupted; `store` may be null.
dem::Interrupted interrupted_with(const RunStore* store);

}  // namespace pendular
