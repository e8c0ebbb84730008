#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/lab/lab_plan.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// One step of a virtual recording, with the simulation that gives the true state of the grains.
struct LabStep {
    Condition condition;         ///< as the instrument shows it
    EffectiveCondition imposed;  ///< true condition of the grains
    dem::RunResult run;          ///< at the true condition
    /// Angular velocity of the lid that the instrument shows [rad/s]; 0: as the inertial number of
    /// `condition` and the height demand.
    double angular_velocity = 0;
};

/// One pass through all steps at one liquid content.
struct LabRecording {
    std::string file;           ///< such as "wet_0.03_1.csv"
    double liquid_content = 0;  ///< [1]; 0: dry
    int replicate = 1;          ///< from 1, among the recordings at equal liquid content
    std::uint64_t seed = 0;     ///< of the noise
    std::vector<LabStep> steps;
};

/// Recordings of a virtual laboratory, with their plan.
struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    /// Number of pilot runs, which determine bridge volumes, and solid fractions at given angular
    /// velocities.
    std::size_t pilots = 0;
    std::vector<std::string> notes;  ///< for the user, for example about repeated runs
};

/// Callback that receives the name of a group of simulations before the group begins: "simulations
/// that seek the heights", "simulations that seek the bridge volumes", "second simulations that
/// seek the bridge volumes" and "recordings".
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates each step of each planned recording, and returns the recordings in the order of the
/// plan. Short pilot runs first determine the bridge volumes that give the planned liquid contents.
/// Each step has a run with a seed of its own, different from those of a calibration
/// (`SeedDomain`), and 1.5 times as many grains as `plan.fidelity` prescribes.
///
/// The inertial number of a step at given angular velocity depends on the height, that is on the
/// solid fraction. A pilot run at the inertial number of a typical solid fraction of 0.6 finds the
/// solid fraction to about 0.5 %, and the run of the step has the inertial number that follows from
/// it. The step is recorded at exactly the given angular velocity.
///
/// A run that fails, crystallises or is not steady is repeated with a new seed, at most three
/// times. A pilot run need not be steady.
/// @throws InputError if `check_plan` does not accept the plan
/// @throws dem::SimulationError if no run of a step can be used
/// @throws dem::Interrupted if a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// Returns the typical relative standard error of an observable in the simulations [1]: the median
/// over all steps. In the recordings, every step has the typical errors of stress ratio and solid
/// fraction.
double typical_error(const LabResult& result, dem::Observable which);

}  // namespace pendular
