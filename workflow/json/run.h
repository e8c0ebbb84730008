#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "sim/catalogue/effect.h"
#include "sim/closures/closure_values.h"
#include "sim/dem/run.h"
#include "sim/lab/virtual_lab.h"
#include "sim/runs/single_run.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Returns the JSON of a run: each observable as {"value", "stderr"}, and all parameters that are
/// needed to repeat the run. Observables of liquid bridges are zero in a run of dry grains.
/// Parameters of effects on grains are under the key `effects_in_run_units`, in units in which
/// grain diameter, grain mass and normal stress are 1.
nlohmann::ordered_json to_json(const dem::RunResult& run);

/// Run as `pendular simulate` made it.
struct Simulated {
    const dem::RunResult& run;
    const dem::RunParameters& without;         ///< parameters before effects
    const std::vector<ActiveEffect>& effects;  ///< that the user gave
    /// Quantities that turn SI values into the units of the run; empty where no effect needs them.
    std::optional<RunScale> scale = {};
    bool scale_given = false;  ///< whether the user gave one of these quantities
    int threads = 1;
    std::optional<closures::ClosureValues> closures = {};
};

/// Returns the JSON of a simulation: run, effects, closures, and the profiles and distributions,
/// each with meaning, unit, coordinate and the lists `at`, `value` and `stderr`, one entry per bin
/// (null: no data).
nlohmann::ordered_json to_json(const Simulated& simulated);

/// Returns the JSON of stored runs, as `pendular runs list --json` writes it.
nlohmann::ordered_json to_json(const std::vector<StoredRun>& runs);

/// Returns the JSON of the closures of Badetti et al. (2018) for a wet state; all are
/// dimensionless.
nlohmann::ordered_json closures_json(const closures::ClosureValues& values);

/// Reads the result of a run from the JSON that `to_json` writes for it. Observables that are
/// missing from the JSON of an earlier version are zero.
/// @throws nlohmann::json::exception if a key is missing or its value has a wrong type
dem::RunResult run_from_json(const nlohmann::ordered_json& json);

/// Returns the true friction coefficient and effects with which a virtual laboratory simulated
/// recordings, for comparison with a diagnosis: the program never reads this JSON. It also contains
/// the plan of the experiment and, for each step, the condition and the data that repeat the
/// simulation.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
