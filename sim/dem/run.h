#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "data/recordings/time_series.h"
#include "sim/dem/fields.h"
#include "sim/dem/observables.h"
#include "sim/dem/run_parameters.h"
#include "sim/dem/simulation_error.h"
#include "sim/dem/stored_sample.h"
#include "sim/dem/trace.h"

namespace pendular::dem {

class Checkpoint;
class GrainEffects;

/// Averages of the observables of one simulation run over its steady part, with standard errors. If
/// the run never becomes steady, the averages are over the last shear strain
/// `RunParameters::strain`. The standard errors allow for the autocorrelation of the time series.
struct RunResult {
    RunParameters parameters;
    int threads = 1;  ///< number of threads that the run used
    /// Time average of each observable of the run, with its standard error, in the order of
    /// `Observable`.
    std::array<Mean, observable_count> means;
    /// Time average of each field of the run, in the order of `Field`. A field is a quantity as a
    /// function of one coordinate, such as a velocity profile. Fields of bridges are empty in runs
    /// with dry grains.
    std::array<BinnedMeans, field_count> fields;
    /// Covariance of the errors of the run's mean stress ratio and mean solid fraction [1].
    double covariance = 0;
    double strain_averaged = 0;  ///< shear strain over which the run was averaged [1]
    /// Shear strain of the run's transient, which the averages exclude [1].
    double strain_transient = 0;
    /// Mean time step of the run in units of sqrt(m/(a s22)), with grain mass m, grain diameter a
    /// and imposed normal stress s22.
    double time_step = 0;
    std::uint64_t steps = 0;
    double wall_seconds = 0;
    bool crystallised = false;
    bool steady = false;
    /// Whether the run reached all standard errors that `RunParameters::precision` requests.
    bool precise = true;
    /// Averages of the run over successive blocks of shear strain 0.02, transient included.
    Trace trace;
    /// Positions and velocities of the grains at the end of the run, from which a new run can
    /// start.
    StoredSample final_state;
    /// Reason why the run failed, set by `run_one` and `run_all`; empty for a run that succeeded.
    std::string failure;

    const Mean& operator[](Observable which) const {
        return means[static_cast<std::size_t>(which)];
    }
    const BinnedMeans& operator[](Field which) const {
        return fields[static_cast<std::size_t>(which)];
    }
    double particle_steps_per_second() const {
        return static_cast<double>(steps) * parameters.grains / wall_seconds;
    }
};

/// Version of the solver, which is stored with each run. The version is increased when a change of
/// the solver changes the results of runs with equal parameters by more than rounding.
constexpr int physics_version = 1;

/// Callback for the progress of a run. The solver calls the callback about once per shear strain of
/// 0.02.
/// @param done shear strain so far [1]
/// @param expected expected total shear strain [1]
using Progress = std::function<void(double done, double expected)>;

/// Callback that receives the states of a run. The solver calls the callback when the flow begins,
/// when a checkpoint resumes the run, and after every shear strain of about 0.02.
/// @param strain shear strain since the flow began [1]
using Observer = std::function<void(const ShearCell& sample, double strain)>;

/// Options of a run in addition to its physical parameters: threads, callbacks, initial state and
/// checkpoint.
struct RunOptions {
    std::stop_token stop;
    Progress progress;
    int threads = 1;
    std::vector<Observer> observers;
    /// State from which the run starts. The pointer must be set if `RunParameters::start` is not 0.
    const StoredSample* start = nullptr;
    /// Checkpoint file. If the file exists, the run resumes from the checkpoint. The run writes the
    /// file when a checkpoint is due (`Checkpoint::due`) and when the run is stopped. If the
    /// pointer is null, no checkpoints are written.
    Checkpoint* checkpoint = nullptr;
    /// Parameters of the run as lines "name = value". The lines are stored in the checkpoint. A run
    /// with other parameters cannot resume from the checkpoint.
    std::string description = {};
};
constexpr int most_threads = 1024;

/// Solid fraction [1] above which a sample counts as crystallised. The solid fraction of the sample
/// is first reduced by `rigidity_shift`, the increase that the overlap of grains causes.
constexpr double crystal_solid_fraction = 0.645;

/// Localization of the shear [1] above which the program warns the user that a flow is not uniform.
/// The localization is 0 for uniform shear and 1 for an infinitely thin shear band. All flows of
/// Badetti et al. (2018) have smaller values.
constexpr double localised_above = 0.05;

/// Simulates a sample in steady shear and returns the averages of the observables over the shear
/// strain `parameters.strain`. The function determines the end of the transient, which the averages
/// exclude. The run ends earlier if it reaches the standard errors `parameters.precision`.
/// @param effects the physical effects on grains that `parameters.effects` names
/// @throws std::invalid_argument if `check_run_parameters` does not accept the parameters, if the
///         number of threads is impossible, if the initial state is missing, or if the number of
///         grains in the initial state differs from `parameters.grains`
/// @throws SimulationError if the stress is not finite, an overlap exceeds half a grain diameter,
///         or the sample does not reach or keep its normal stress
/// @throws Interrupted if a stop is requested
/// @throws InputError if the checkpoint belongs to a run with other parameters or to another
///         version of the program, or is corrupt
RunResult run(const RunParameters& parameters, const GrainEffects& effects,
              const RunOptions& options = {});

/// Returns the amount by which the overlap of grains in contact increases the solid fraction of a
/// sample, compared with rigid grains [1]:
///     1.23 x 3 solid_fraction mean_overlap
/// The factor 1.23 +- 0.15 was measured in dry samples with a friction coefficient of 0.12 at
/// stiffness numbers between 300 and 4000.
/// @param mean_overlap mean overlap of contacts divided by the grain diameter [1]
double rigidity_shift(double solid_fraction, double mean_overlap);
constexpr double rigidity_factor = 1.23;
constexpr double rigidity_factor_error = 0.15;

}  // namespace pendular::dem
