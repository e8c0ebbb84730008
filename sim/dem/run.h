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

/// Averages of one run over its steady part or, if it never becomes steady, over the last shear
/// strain `RunParameters::strain`. The standard errors allow for the autocorrelation of the time
/// series.
struct RunResult {
    RunParameters parameters;
    int threads = 1;
    std::array<Mean, observable_count> means;  ///< in the order of `Observable`
    /// Fields in the order of `Field`; those of bridges are empty in runs with dry grains.
    std::array<BinnedMeans, field_count> fields;
    double covariance = 0;        ///< of the errors of stress ratio and solid fraction
    double strain_averaged = 0;   ///< shear strain of the averages [1]
    double strain_transient = 0;  ///< shear strain that they exclude [1]
    double time_step = 0;         ///< mean, in units of sqrt(m/(a s22))
    std::uint64_t steps = 0;
    double wall_seconds = 0;
    bool crystallised = false;
    bool steady = false;
    /// Whether all standard errors that `RunParameters::precision` requests were reached.
    bool precise = true;
    Trace trace;               ///< transient included
    StoredSample final_state;  ///< from which a new run can start
    std::string failure;       ///< set by `RunCheckpoints` and `run_all`; empty: success

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

/// Version of the solver, which is stored with each run. It is increased when a change of the
/// solver changes the results of runs with equal parameters by more than rounding.
constexpr int physics_version = 1;

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
constexpr int most_threads = 1024;

/// Solid fraction [1], reduced by `rigidity_shift`, above which a sample counts as crystallised:
/// random packings of equal spheres are not denser than about 0.64.
constexpr double crystal_solid_fraction = 0.645;

/// Localization [1] above which the program warns the user that a flow is not uniform. All flows of
/// Badetti et al. (2018) have smaller values.
constexpr double localised_above = 0.05;

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

/// Returns the amount by which the overlap of grains in contact increases the solid fraction of a
/// sample, compared with rigid grains [1]:
///     1.23 x 3 solid_fraction mean_overlap
/// The factor 1.23 +- 0.15 was measured in dry samples with a friction coefficient of 0.12 at
/// stiffness numbers between 300 and 4000.
/// @param mean_overlap over the grain diameter [1]
double rigidity_shift(double solid_fraction, double mean_overlap);
constexpr double rigidity_factor = 1.23;
constexpr double rigidity_factor_error = 0.15;

}  // namespace pendular::dem
