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
    int threads = 1;  ///< of the run itself
    std::array<Mean, observable_count> means;
    std::array<BinnedMeans, field_count> fields;  ///< those of bridges are empty in dry runs
    double covariance = 0;  ///< of the means of stress ratio and solid fraction
    double strain_averaged = 0;
    double strain_transient =
        0;                 ///< strain of the detected transient, left out of the averages [1]
    double time_step = 0;  ///< mean [sqrt(m/(a s22))]
    std::uint64_t steps = 0;
    double wall_seconds = 0;
    bool crystallised = false;
    bool steady = false;
    bool precise = true;       ///< whether every requested standard error was reached
    Trace trace;               ///< one entry per block of strain, transient included
    StoredSample final_state;  ///< state from which another run may start
    std::string failure;       ///< why there are no averages (run_all); empty: there are

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

/// Called about once per strain of 0.02 with the strain done and the strain expected in all.
using Progress = std::function<void(double done, double expected)>;

/// Called with the state and the strain since the flow began: at first, when that is 0 or where a
/// checkpoint resumes, then at the end of every block of strain, about 0.02.
using Observer = std::function<void(const ShearCell& sample, double strain)>;

/// How a run is carried out.
struct RunOptions {
    std::stop_token stop;
    Progress progress;
    int threads = 1;
    std::vector<Observer> observers;
    const StoredSample* start = nullptr;  ///< needed where RunParameters::start is not 0
    Checkpoint* checkpoint = nullptr;  ///< resumed from where it holds this run, written as it is
                                       ///< due and when the run is stopped
    /// Tells this run from all others, for the checkpoint: "name = value" lines.
    std::string description = {};
};
constexpr int most_threads = 1024;

/// Solid fraction above which a monosized sample has crystallised, once corrected to rigid grains.
constexpr double crystal_solid_fraction = 0.645;

/// Localization above which the shear is not taken for uniform (Badetti et al. (2018) finds less in
/// every flow it reports).
constexpr double localised_above = 0.05;

/// Shears a random sample of monosized grains until its averages are known over `strain`, after a
/// transient that is detected, not assumed. `effects` are those that `parameters` names.
/// @throws std::invalid_argument for what `check_run_parameters` refuses, and for a start of
/// another size
/// @throws SimulationError where the state stops being finite or never reaches its stress
/// @throws Interrupted when a stop is requested
/// @throws InputError for a checkpoint of another run or one that is no longer whole
RunResult run(const RunParameters& parameters, const GrainEffects& effects,
              const RunOptions& options = {});

/// Solid fraction that rigid grains would have, from the overlaps of a run [1]:
///     Phi (rigid) = Phi - 1.23 x 3 Phi <overlap>/a
/// The factor 1.23 +- 0.15 was measured between kappa 300 and 4000 on dry grains of friction 0.12.
double rigidity_shift(double solid_fraction, double mean_overlap);
constexpr double rigidity_factor = 1.23;
constexpr double rigidity_factor_error = 0.15;

}  // namespace pendular::dem
