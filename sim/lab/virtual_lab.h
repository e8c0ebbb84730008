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
    Condition condition;         ///< asked for: what the instrument shows
    EffectiveCondition imposed;  ///< what is truly imposed, as simulated (`imposed_condition`)
    dem::RunResult run;
};

/// One recording: a replicate of all steps of one liquid content.
struct LabRecording {
    std::string file;
    double liquid_content = 0;
    int replicate = 1;
    std::uint64_t seed = 0;  ///< of the instrument
    std::vector<LabStep> steps;
};

struct LabResult {
    LabPlan plan;
    std::vector<LabRecording> recordings;
    std::size_t pilots = 0;          ///< short runs made to find bridge volumes
    std::vector<std::string> notes;  ///< lines the user should read
};

/// Called with the name of each phase of the work before its runs begin.
using AnnouncePhase = std::function<void(const std::string&)>;

/// Simulates every step of every recording, each on its own: no two share a seed, and none shares
/// its seed with a run of a calibration of equal seed (seeds.h) or its number of grains, which is
/// 1.5 times the fidelity's. Bridge volumes that give the liquid contents are found by short runs
/// first. A run that fails, crystallises or is not steady is replaced by one of another seed, three
/// times at most.
/// @throws InputError as `check_plan`
/// @throws dem::SimulationError where a step has no usable run
/// @throws dem::Interrupted when a stop is requested
LabResult simulate_lab(const LabPlan& plan, const Workers& workers,
                       const AnnouncePhase& announce = {});

/// Typical standard error of an observable in the laboratory's runs, relative [1]: the median,
/// since the error of one run is itself known from few independent samples only.
double typical_error(const LabResult& result, dem::Observable which);

}  // namespace pendular
