#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/lab/lab_plan.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// One step of constant set points in a virtual recording: requested condition (normal stress,
/// inertial number and liquid content), true condition, and the simulation that gives the true
/// state of the grains.
struct LabStep {
    Condition condition;         ///< requested condition of the step, which the instrument shows
    EffectiveCondition imposed;  ///< true condition of the grains in the step (`imposed_condition`)
    dem::RunResult run;          ///< result of the simulation at the true condition of the step
    /// Angular velocity of the lid that the instrument shows [rad/s]; 0: as the inertial number of
    /// `condition` and the height demand.
    double angular_velocity = 0;
};

/// Simulated recording of a virtual laboratory: one pass through all steps of constant set points
/// at one liquid content.
struct LabRecording {
    std::string file;  ///< name of the recording's file, such as "wet_0.03_1.csv"
    /// Liquid content of the recording [1]: liquid volume divided by grain volume, 0 for dry
    /// grains.
    double liquid_content = 0;
    /// Number of the recording, from 1, among the recordings at equal liquid content.
    int replicate = 1;
    std::uint64_t seed = 0;  ///< seed of the random numbers for the noise of the recording
    std::vector<LabStep> steps;
};

/// Simulated recordings of a virtual laboratory, with the plan of the recordings.
struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    /// Number of pilot runs: short simulations that determine the volumes of the liquid bridges,
    /// and the solid fractions at given angular velocities.
    std::size_t pilots = 0;
    /// Messages for the user about the simulations, for example about runs that were repeated.
    std::vector<std::string> notes;
};

/// Callback that receives the name of a group of simulations of a virtual laboratory before the
/// group begins. The names are "simulations that seek the heights", "simulations that seek the
/// bridge volumes", "second simulations that seek the bridge volumes" and "recordings".
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates each step of each planned recording, and returns the recordings in the order of the
/// plan. Short pilot runs first determine the bridge volumes that give the planned liquid contents.
/// Each step has a simulation run with a seed of its own and 1.5 times as many grains as
/// `plan.fidelity` prescribes. The seeds differ from the seeds of a calibration (`SeedDomain`).
///
/// The inertial number of a step at given angular velocity depends on the height of the sample,
/// that is on the solid fraction. A pilot run at the inertial number of a typical solid fraction of
/// 0.6 finds the solid fraction to about 0.5 %, and the run of the step has the inertial number
/// that follows from it. The step is recorded at exactly the given angular velocity.
///
/// A run that fails, crystallises or is not steady is repeated with a new seed, at most three
/// times. A pilot run need not be steady.
/// @param workers threads, store and progress callback for the runs
/// @throws InputError if `check_plan` does not accept the plan
/// @throws dem::SimulationError if no run of a step can be used
/// @throws dem::Interrupted if a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// Returns the typical relative standard error of an observable in the simulations [1]: the median
/// of standard error divided by mean, over all steps of all recordings. In the recordings, every
/// step has the typical relative standard errors of stress ratio and solid fraction.
double typical_error(const LabResult& result, dem::Observable which);

}  // namespace pendular
