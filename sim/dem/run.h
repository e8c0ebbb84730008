#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "sim/dem/run_result.h"
#include "sim/dem/simulation_error.h"

namespace pendular::dem {

class Checkpoint;
class GrainEffects;

/// Callback for the progress of a run, about once per shear strain of 0.02.
/// @param done shear strain so far [1]
/// @param expected expected total shear strain [1]
using Progress = std::function<void(double done, double expected)>;

/// Callback that receives the states of a run: when the flow begins, when a checkpoint resumes the
/// run, and after every shear strain of about 0.02.
/// @param strain shear strain since the flow began [1]
using Observer = std::function<void(const ShearCell& sample, double strain)>;

/// Options of a run besides its physical parameters.
struct RunOptions {
    std::stop_token stop;
    Progress progress;
    int threads = 1;
    std::vector<Observer> observers;
    /// Initial state; must be set if `RunParameters::start` is not 0.
    const StoredSample* start = nullptr;
    /// If its file exists, the run resumes from it. The run writes the file when a checkpoint is
    /// due (`Checkpoint::due`) and when it is stopped. Null: no checkpoints.
    Checkpoint* checkpoint = nullptr;
    /// Parameters of the run as lines "name = value", stored in the checkpoint, from which a run
    /// with other parameters cannot resume.
    std::string description = {};
};
constexpr int most_threads = 1024;  ///< more is a mistyped number

/// Simulates a sample in steady shear and returns the averages of the observables over the shear
/// strain `parameters.strain`, without the transient, whose end is found from the time series. The
/// run ends earlier if it reaches the standard errors `parameters.precision`.
/// @param effects those that `parameters.effects` names
/// @throws std::invalid_argument if `check_run_parameters` does not accept the parameters, if the
///         number of threads is impossible, if the initial state is missing, or if it has another
///         number of grains than `parameters.grains`
/// @throws SimulationError if the stress is not finite, an overlap exceeds half a grain diameter,
///         or the sample does not reach or keep its normal stress
/// @throws Interrupted if a stop is requested
/// @throws InputError if the checkpoint belongs to a run with other parameters or to another
///         version of the program, or is corrupt
RunResult run(const RunParameters& parameters, const GrainEffects& effects,
              const RunOptions& options = {});

}  // namespace pendular::dem
