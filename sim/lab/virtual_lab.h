#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/lab/lab_plan.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// One step of constant set points in a virtual recording: requested condition, true condition, and
/// the simulation that gives the true state of the grains.
struct LabStep {
    Condition condition;         ///< requested condition of the step, which the instrument shows
    EffectiveCondition imposed;  ///< true condition of the grains in the step (`imposed_condition`)
    dem::RunResult run;          ///< simulation of the step at its true condition
};

/// One simulated recording: one pass through all steps of constant set points at one liquid
/// content.
struct LabRecording {
    std::string file;  ///< name of the recording's file, as in "wet_0.03_1.csv"
    /// Liquid volume divided by grain volume in the recording [1]; 0: dry.
    double liquid_content = 0;
    /// Number of the recording among all recordings of its liquid content, from 1.
    int replicate = 1;
    std::uint64_t seed = 0;  ///< seed of the instrument's noise in the recording
    std::vector<LabStep> steps;
};

/// Simulated recordings of a virtual laboratory, with the plan from which they were made.
struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    /// Number of short simulations made to find the volumes of liquid bridges.
    std::size_t pilots = 0;
    /// Messages for the user about the simulations, for example about repeated runs.
    std::vector<std::string> notes;
};

/// Callback that receives the name of each phase of a virtual laboratory's work, such as "pilot
/// runs for the liquid contents" or "recordings", before the simulations of the phase begin.
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates each step of each planned recording by a run with a seed of its own, and returns the
/// recordings in the order of the plan. The runs have 1.5 times as many grains as `plan.fidelity`
/// prescribes. Their seeds differ from the seeds of a calibration, even if the user states the same
/// seed for both (`SeedDomain`). Short runs first determine the bridge volumes that give the liquid
/// contents. A run that fails, crystallises or is not steady is repeated with another seed, at most
/// three times.
/// @param workers threads, store and progress callback for the runs
/// @throws InputError if `check_plan` does not accept the plan
/// @throws dem::SimulationError if no run of a step can be used
/// @throws dem::Interrupted if a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// Returns the typical relative standard error [1] of an observable in the simulations of all
/// steps: the median of (standard error divided by mean). The median is used since the error of a
/// single run is estimated from few independent samples.
double typical_error(const LabResult& result, dem::Observable which);

}  // namespace pendular
