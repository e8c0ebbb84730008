#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/lab/lab_plan.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// One step (constant set points) of a virtual recording: the requested and truly imposed
/// condition, and the simulation run that gives the true state of the grains.
struct LabStep {
    Condition condition;         ///< requested condition, which the instrument shows
    EffectiveCondition imposed;  ///< truly imposed condition (`imposed_condition`)
    dem::RunResult run;          ///< simulation at the imposed condition
};

/// One recording: a replicate of all steps (constant set points) of one liquid content.
struct LabRecording {
    std::string file;           ///< file name, as in "wet_0.03_1.csv"
    double liquid_content = 0;  ///< liquid over grain volume [1]; 0: dry
    int replicate = 1;          ///< number among equal recordings, from 1
    std::uint64_t seed = 0;     ///< seed of the instrument's noise
    std::vector<LabStep> steps;
};

/// Simulated recordings of a virtual laboratory, with the plan that they follow.
struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    std::size_t pilots = 0;          ///< number of short runs made to find bridge volumes
    std::vector<std::string> notes;  ///< messages for the user, such as repeated runs
};

/// Callback that receives the name of each phase of a virtual laboratory's work, such as "pilot
/// runs for the liquid contents" or "recordings", before the simulation runs of the phase begin.
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates each step of each planned recording in a run of its own with its own seed. No run has
/// a seed of a calibration that starts from the same user's seed (seeds.h), and each has 1.5 times
/// as many grains as `plan.fidelity` states. Short runs first find the bridge volumes that give the
/// liquid contents. A run that fails, crystallises or is not steady is repeated with another seed,
/// at most three times.
/// @throws InputError where `check_plan` does not accept the plan
/// @throws dem::SimulationError where a step has no usable run
/// @throws dem::Interrupted when a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// Returns the median, over the runs of all steps, of an observable's standard error divided by the
/// observable's mean [1]. The median is used since few independent samples determine the error of a
/// single run.
double typical_error(const LabResult& result, dem::Observable which);

}  // namespace pendular
