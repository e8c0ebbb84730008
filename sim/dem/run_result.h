#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "data/recordings/time_series.h"
#include "sim/dem/cell.h"
#include "sim/dem/field.h"
#include "sim/dem/run_parameters.h"

namespace pendular::dem {

struct Sample;
class ShearCell;

/// Averages over one block (a shear strain of about 0.02), in single precision. Stresses are
/// divided by the imposed normal stress [1].
struct TraceBlock {
    float strain = 0;  ///< of the block [1]
    float s11 = 0, s22 = 0, s33 = 0, s12 = 0;
    float solid_fraction = 0, contact_coordination = 0, distant_coordination = 0, localization = 0;

    friend bool operator==(const TraceBlock&, const TraceBlock&) = default;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(strain, s11, s22, s33, s12, solid_fraction, contact_coordination,
                distant_coordination, localization);
    }
};

/// Time series of a run, block by block.
using Trace = std::vector<TraceBlock>;

/// Final state of a run in single precision, from which a new run can start. It lacks the contact
/// history, so that only a checkpoint can continue a run bit for bit. If the grains differ in size,
/// the state is not stored and `grains` is empty.
struct StoredSample {
    Cell cell;
    /// Position, velocity without the imposed flow, and angular velocity of each grain, in reduced
    /// units (grain diameter, grain mass and imposed normal stress are 1).
    std::vector<std::array<float, 9>> grains;

    StoredSample() = default;
    explicit StoredSample(const ShearCell& sample);
    Sample sample() const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(cell, grains);
    }
};

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

/// Solid fraction [1], reduced by `rigidity_shift`, above which a sample counts as crystallised:
/// random packings of equal spheres are not denser than about 0.64.
constexpr double crystal_solid_fraction = 0.645;

/// Localization [1] above which the program warns the user that a flow is not uniform. All flows of
/// Badetti et al. (2018) have smaller values.
constexpr double localised_above = 0.05;

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
