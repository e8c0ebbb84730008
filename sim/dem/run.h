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

/// Time averages of one run over its steady part, each with a standard error from block averages
/// over strain that respects their autocorrelation.
struct RunResult {
    RunParameters parameters;
    int threads = 1;  ///< threads that this run used
    std::array<Mean, observable_count> means;
    std::array<BinnedMeans, field_count> fields;  ///< fields of bridges are empty in dry runs
    double covariance = 0;       ///< covariance of the means of stress ratio and solid fraction
    double strain_averaged = 0;  ///< shear strain over which was averaged [1]
    /// Strain of the detected transient, which the averages exclude [1].
    double strain_transient = 0;
    double time_step = 0;  ///< mean time step [sqrt(m/(a s22))]
    std::uint64_t steps = 0;
    double wall_seconds = 0;
    bool crystallised = false;
    bool steady = false;
    bool precise =
        true;  ///< whether all standard errors that RunParameters::precision asks for were reached
    Trace trace;               ///< averages over blocks of strain 0.02, transient included
    StoredSample final_state;  ///< state from which another run may start
    std::string failure;       ///< why the run failed (set by `run_all`); empty: success

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

/// Version of the solver. It changes only when runs of equal parameters give results that differ
/// beyond rounding.
constexpr int physics_version = 1;

/// Callback for the progress of a run, called about once per strain of 0.02 with the strain done so
/// far and the expected total strain [1].
using Progress = std::function<void(double done, double expected)>;

/// Callback that receives the states of a run: the sample, and the strain since the flow began [1].
/// It is called first when the flow begins or a checkpoint resumes the run, then at the end of
/// every block of strain, about 0.02.
using Observer = std::function<void(const ShearCell& sample, double strain)>;

/// Options of a run besides its physical parameters: threads, callbacks, start and checkpoint.
struct RunOptions {
    std::stop_token stop;
    Progress progress;
    int threads = 1;
    std::vector<Observer> observers;
    const StoredSample* start = nullptr;  ///< initial state if RunParameters::start is not 0
    /// Checkpoint file: the run resumes from it if it exists, and writes it whenever it is due
    /// (Checkpoint::due) and when the run is stopped; null: no checkpoints.
    Checkpoint* checkpoint = nullptr;
    /// Parameters of the run in lines "name = value", stored in its checkpoint, so that no other
    /// run resumes from it.
    std::string description = {};
};
constexpr int most_threads = 1024;

/// Solid fraction, corrected to rigid grains (`rigidity_shift`), above which a sample of equal
/// grains counts as crystallised [1].
constexpr double crystal_solid_fraction = 0.645;

/// Localization (0: uniform shear, 1: infinitely thin shear band) above which a flow does not count
/// as uniform [1]; every flow that Badetti et al. (2018) report has a smaller value.
constexpr double localised_above = 0.05;

/// Simulates a sample in steady shear and returns its time averages over `parameters.strain`, or
/// over a shorter strain once the averages reach `parameters.precision`. The preceding transient is
/// detected, not assumed. `effects` must be the effects on grains that `parameters` names.
/// @throws std::invalid_argument where `check_run_parameters` does, for an impossible number of
/// threads, and for a start state with another number of grains
/// @throws SimulationError where the state is not finite, or the sample does not reach or hold its
/// normal stress
/// @throws Interrupted when a stop is requested
/// @throws InputError where the checkpoint belongs to another run or version, or is corrupt
RunResult run(const RunParameters& parameters, const GrainEffects& effects,
              const RunOptions& options = {});

/// Solid fraction Phi of a run minus the solid fraction that rigid grains would have [1], from the
/// mean overlap of contacts over the grain diameter a:
///     Phi - Phi (rigid) = 1.23 x 3 Phi <overlap>/a
/// The factor 1.23 +- 0.15 was measured at stiffness numbers kappa between 300 and 4000 on dry
/// grains of friction 0.12.
double rigidity_shift(double solid_fraction, double mean_overlap);
constexpr double rigidity_factor = 1.23;
constexpr double rigidity_factor_error = 0.15;

}  // namespace pendular::dem
