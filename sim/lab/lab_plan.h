#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"
#include "sim/lab/virtual_recording.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Order of the steps of a recording: as listed, by normal stress, random (different from recording
/// to recording), or with the normal stress increasing and then decreasing over the same values.
enum class StepOrder { as_listed, increasing, decreasing, random, up_and_down };

/// Set points of one step, as the instrument shows them: normal stress and either inertial number
/// or angular velocity of the lid, of which the other is 0.
struct LabSetPoint {
    double normal_stress = 0;     ///< [Pa]
    double inertial_number = 0;   ///< [1]
    double angular_velocity = 0;  ///< [rad/s]
};

/// Recordings of equal liquid content and equal set points.
struct LabSeries {
    double liquid_content = 0;  ///< [1]; 0: dry
    std::vector<LabSetPoint> steps;
    int replicates = 1;
};

/// Plan of a virtual laboratory, which simulates rheometer recordings to test whether a calibration
/// finds the true friction coefficient and the true effects. It contains these true values, the
/// conditions and the properties of the instrument, in SI units.
struct LabPlan {
    double friction = 0.09;  ///< true value [1]
    GrainProperties grains = {.diameter = 500e-6, .density = 1050, .poisson_ratio = 0.3};
    Liquid liquid = {.surface_tension = 20.6e-3};
    AnnularCell cell = {.inner_radius = 21e-3, .outer_radius = 45e-3, .bead_volume = 60e-3 / 1050};
    std::vector<double> dry_normal_stresses = {300, 1000, 3000};       ///< [Pa]
    std::vector<double> wet_normal_stresses = {300, 600, 1000, 3000};  ///< [Pa]
    std::vector<double> liquid_contents = {0.007, 0.03};  ///< [1]; empty: only dry grains
    std::vector<double> inertial_numbers = {3e-3, 3e-2};  ///< of dry and of wet grains [1]
    /// Angular velocities of the lid [rad/s], in place of inertial numbers, which then follow from
    /// the height of the sample, that is from the simulated solid fraction.
    std::vector<double> angular_velocities;
    /// Recordings to make, in place of all lists above and of `replicates`.
    std::vector<LabSeries> series;
    StepOrder order = StepOrder::as_listed;
    /// True effects. The written study.toml does not list them: a calibration has to find them.
    std::vector<ActiveEffect> effects;
    int replicates = 2;  ///< of dry grains, and at each liquid content
    Instrument instrument;
    Fidelity fidelity;
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> noise_seed;  ///< of the instrument; empty: `seed`
    /// Whether the seed of a run follows from the parameters of the run, so that laboratories share
    /// their simulated states; otherwise from the run's place in the plan.
    bool shared_states = false;
};

/// One pass through all steps at one liquid content.
struct PlannedRecording {
    std::string file;           ///< such as "wet_0.03_1.csv"
    double liquid_content = 0;  ///< [1]; 0: dry
    int replicate = 1;          ///< from 1, among the recordings at equal liquid content
    std::uint64_t seed = 0;     ///< of the noise
    /// Requested conditions of the steps. Their `time` is the mean time [s], since the first
    /// recording began, of the step's part after the start-up transient.
    std::vector<Condition> conditions = {};
    /// Angular velocities of the lid [rad/s]; 0 in a step of given inertial number. The inertial
    /// numbers of other steps are those of a typical solid fraction of 0.6.
    std::vector<double> angular_velocities = {};
};

/// Returns all recordings in the order of measurement, without pauses: dry grains first, then each
/// liquid content. An effect on the grains that depends on time acts during a whole step as at the
/// step's mean time.
std::vector<PlannedRecording> recordings_of(const LabPlan& plan);

/// Sets the times of all steps of recordings that follow one another without pauses.
void set_times(const LabPlan& plan, std::vector<PlannedRecording>& recordings);

/// Returns the true condition of the grains at which the instrument shows a requested condition:
/// the effects on the instrument are inverted, those on properties of grains and liquid applied,
/// and those that a simulation must contain listed in `grain_effects`.
///
/// The height of the sample follows from `flow`, by default from a typical solid fraction of 0.6,
/// since the simulated one is not known yet. The resulting error of the condition is about 0.1 %.
/// @throws InputError if the instrument shows the requested condition for no true state
EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked,
                                     const FlowPoint& flow = {.stress_ratio = 0.3,
                                                              .solid_fraction = 0.6});

/// Returns the inertial number [1] that the instrument shows while the lid turns at a shown angular
/// velocity [rad/s].
///     I = omega (Ri + Re)/(2 H) sqrt(m/(a s22))      omega, H, s22 as the instrument shows them
/// @param asked requested normal stress, liquid content and time
/// @param flow of the grains, true values
/// @throws InputError if the instrument shows the request for no true state
double inertial_number_at_speed(const LabPlan& plan, Condition asked, double angular_velocity,
                                const FlowPoint& flow);

/// Returns the state of the cell that the instrument shows, without noise, as a function of the
/// time [s] since the first recording began. At `asked.time`, it is the requested condition. The
/// true state is constant, but an effect on the instrument may depend on time, such as a wobble of
/// the lid.
/// @param flow of the grains, true values
/// @throws InputError if the instrument shows the requested condition for no true state
std::function<CellState(double)> shown_over_time(const LabPlan& plan, const Condition& asked,
                                                 const FlowPoint& flow);

/// Returns the reason why an effect cannot act in a virtual laboratory, as the end of a message
/// that begins with the effect's name; empty if it can. Effects on closures or on the predicted
/// flow cannot, since these belong to models only.
std::string why_not_in_lab(const Effect& effect);

/// Returns the series of a plan in the order of measurement: `plan.series` or, if this is empty,
/// one series of dry grains and one for each liquid content.
std::vector<LabSeries> series_of(const LabPlan& plan);

/// Returns the liquid contents of a plan's recordings [1], each once, in the order of measurement.
std::vector<double> contents_of(const LabPlan& plan);

/// Returns the parameters of the run at a true condition (`imposed_condition`), in reduced units,
/// in which grain diameter, grain mass and normal stress are 1. The caller must set the seed.
/// @param bridge_volume over the cubed grain diameter [1], for wet grains only
dem::RunParameters run_at(const LabPlan& plan, const EffectiveCondition& condition,
                          double bridge_volume);

/// Returns the parameters, in reduced units, of a pilot run: few grains and a short strain, to
/// measure the liquid content at a given bridge volume.
/// @param condition true condition of the grains (`imposed_condition`)
/// @param bridge_volume over the cubed grain diameter [1]
dem::RunParameters pilot_at(const LabPlan& plan, const EffectiveCondition& condition,
                            double bridge_volume);

/// Simulates wet samples, one short run for each bridge volume, and returns their liquid contents
/// [1] in the same order.
/// @param which for each sample, index of its liquid content among all requested ones
/// @param bridge_volumes over the cubed grain diameter [1]
using MeasureLiquidContents = std::function<std::vector<double>(
    std::span<const std::size_t> which, std::span<const double> bridge_volumes)>;

/// Returns the bridge volumes V0, over the cubed grain diameter a^3 [1], at which samples have the
/// requested liquid contents [1], in their order.
///     liquid content = 3 Z (V0/a^3)/pi
/// The mean number Z of bridges on a grain depends on V0 and must be measured by simulation. Each
/// sample is simulated once and V0 corrected; if the liquid content was wrong by more than 3 %, the
/// sample is simulated a second time with the corrected V0. The relative error of the final liquid
/// content is far below 3 %.
/// Source: Badetti et al. (2018), Eq. (6).
std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure);

/// Returns the bridge volume, over the cubed grain diameter [1], with which `bridge_volumes`
/// begins: for a typical number of bridges on a grain (`dem::typical_coordination`).
double first_bridge_volume(double liquid_content);

}  // namespace pendular
