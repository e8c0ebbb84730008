#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/lab/lab_plan.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// One step of a recording: the imposed condition and the run that gives the true state.
struct LabStep {
    Condition condition;         ///< requested condition, which the instrument shows
    EffectiveCondition imposed;  ///< truly imposed condition (`imposed_condition`)
    dem::RunResult run;          ///< simulation at the imposed condition
};

/// One recording: a replicate of all steps (constant set points) of one liquid content.
struct LabRecording {
    std::string file;           ///< file name, as in "wet_0.03_1.csv"
    double liquid_content = 0;  ///< Phi_L/Phi_S [1]; 0: dry
    int replicate = 1;          ///< number of the replicate, from 1
    std::uint64_t seed = 0;     ///< seed of the instrument's noise
    std::vector<LabStep> steps;
};

/// Simulated recordings of a virtual laboratory, with the plan that they follow.
struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    std::size_t pilots = 0;          ///< number of short runs that found bridge volumes
    std::vector<std::string> notes;  ///< lines the user should read
};

/// Callback that receives the name of each phase of the work before its runs begin.
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates each step of each recording in a run of its own with its own seed. No run has a seed
/// of a calibration that starts from the same user's seed (seeds.h), and each has 1.5 times as many
/// grains as the fidelity. Short runs first find the bridge volumes that give the liquid contents.
/// A run that fails, crystallises or is not steady is repeated with another seed, at most three
/// times.
/// @throws InputError where `check_plan` does not accept the plan
/// @throws dem::SimulationError where a step has no usable run
/// @throws dem::Interrupted when a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// Returns the typical relative standard error [1] of an observable in the laboratory's runs: the
/// median, since few independent samples determine the error of a single run.
double typical_error(const LabResult& result, dem::Observable which);

}  // namespace pendular
