#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"
#include "sim/lab/virtual_recording.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Order in which the steps of a recording are measured: as the plan lists them, by increasing or
/// decreasing normal stress, in a random order that differs from recording to recording, or with
/// the normal stress increasing and then decreasing over the same values.
enum class StepOrder { as_listed, increasing, decreasing, random, up_and_down };

/// Set points of one step: normal stress and either inertial number or angular velocity of the lid.
struct LabSetPoint {
    double normal_stress = 0;     ///< normal stress that the instrument shows [Pa]
    double inertial_number = 0;   ///< inertial number that the instrument shows [1]; 0: see next
    double angular_velocity = 0;  ///< angular velocity that the instrument shows [rad/s]; 0: unused
};

/// Recordings of equal liquid content and equal set points.
struct LabSeries {
    double liquid_content = 0;  ///< liquid volume divided by grain volume [1]; 0: dry
    std::vector<LabSetPoint> steps;
    int replicates = 1;
};

/// Plan of a virtual laboratory, which simulates rheometer recordings to test whether a calibration
/// finds the true friction coefficient and the true physical effects. The plan contains the true
/// values, the conditions (normal stress, inertial number and liquid content) and the properties of
/// the instrument. Values are in SI units.
struct LabPlan {
    double friction = 0.09;  ///< true friction coefficient between the simulated grains [1]
    GrainProperties grains = {.diameter = 500e-6, .density = 1050, .poisson_ratio = 0.3};
    Liquid liquid = {.surface_tension = 20.6e-3};
    AnnularCell cell = {.inner_radius = 21e-3, .outer_radius = 45e-3, .bead_volume = 60e-3 / 1050};
    /// Normal stresses of the recordings of dry grains [Pa].
    std::vector<double> dry_normal_stresses = {300, 1000, 3000};
    /// Normal stresses of the recordings of wet grains [Pa].
    std::vector<double> wet_normal_stresses = {300, 600, 1000, 3000};
    /// Liquid contents of the recordings of wet grains [1]: liquid volume divided by grain volume.
    /// If the list is empty, only dry grains are recorded.
    std::vector<double> liquid_contents = {0.007, 0.03};
    /// Inertial numbers of the recordings of dry grains and of wet grains [1].
    std::vector<double> inertial_numbers = {3e-3, 3e-2};
    /// Angular velocities of the lid [rad/s], in place of inertial numbers. The inertial number of
    /// a step then follows from the height of the sample, which follows from the simulated solid
    /// fraction.
    std::vector<double> angular_velocities;
    /// Recordings to make, in place of all lists above and of `replicates`.
    std::vector<LabSeries> series;
    StepOrder order = StepOrder::as_listed;
    /// Physical effects, with parameter values, that act in the simulated recordings. The file
    /// study.toml that the virtual laboratory writes does not list the effects, since a calibration
    /// has to find them.
    std::vector<ActiveEffect> effects;
    int replicates = 2;  ///< number of recordings of dry grains, and at each liquid content
    Instrument instrument;
    Fidelity fidelity;
    std::uint64_t seed = 1;
    /// Seed of the noise of the instrument; empty: `seed`.
    std::optional<std::uint64_t> noise_seed;
    /// Whether the seed of a run follows from the parameters of the run, so that laboratories
    /// share their simulated states; otherwise from the run's place in the plan.
    bool shared_states = false;
};

/// Planned recording of a virtual laboratory: one pass through all steps of constant set points at
/// one liquid content.
struct PlannedRecording {
    std::string file;  ///< name of the recording's file, such as "wet_0.03_1.csv"
    /// Liquid content of the recording [1]: liquid volume divided by grain volume, 0 for dry
    /// grains.
    double liquid_content = 0;
    /// Number of the recording, from 1, among the recordings at equal liquid content.
    int replicate = 1;
    std::uint64_t seed = 0;  ///< seed of the random numbers for the noise of the recording
    /// Requested condition (normal stress, inertial number and liquid content) of each step of the
    /// recording. The member `time` of a condition is the mean time [s], since the first recording
    /// began, of the part of the step after the start-up transient.
    std::vector<Condition> conditions = {};
    /// Angular velocity of the lid in each step [rad/s]; 0 in a step of given inertial number. The
    /// inertial numbers of other steps are those of a typical solid fraction of 0.6.
    std::vector<double> angular_velocities = {};
};

/// Returns all recordings of a plan in the order of measurement, without pauses between recordings.
/// The recordings of dry grains come first, followed by the recordings at each liquid content. The
/// time of a step of constant set points is the mean time [s], since the first recording began, of
/// the part of the step after the start-up transient. An effect on the grains that depends on time
/// acts during the whole step as at this mean time.
std::vector<PlannedRecording> recordings_of(const LabPlan& plan);

/// Sets the times of all steps of recordings that follow one another without pauses.
void set_times(const LabPlan& plan, std::vector<PlannedRecording>& recordings);

/// Returns the true condition of the grains (normal stress, inertial number and liquid content, in
/// SI units) at which the instrument shows the requested condition. The function inverts the
/// effects on the instrument and applies the effects on properties of grains and liquid
/// (`ChangeCondition`). The member `grain_effects` of the result lists the effects on grains that a
/// simulation must contain.
///
/// The height of the sample follows from `flow`: by default from a typical solid fraction of 0.6,
/// since the simulated height is not known yet. The resulting error of the condition is about
/// 0.1 %.
/// @param asked requested condition, which the instrument shows
/// @throws InputError if there is no true state that the instrument shows as the requested
///         condition
EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked,
                                     const FlowPoint& flow = {.stress_ratio = 0.3,
                                                              .solid_fraction = 0.6});

/// Returns the inertial number [1] that the instrument shows while the lid turns at a shown angular
/// velocity [rad/s].
///     I = omega (Ri + Re)/(2 H) sqrt(m/(a s22))      omega, H, s22 as the instrument shows them
/// @param asked requested normal stress, liquid content and time
/// @param flow true stress ratio [1] and true solid fraction [1] of the grains
/// @throws InputError if there is no true state that the instrument shows as requested
double inertial_number_at_speed(const LabPlan& plan, Condition asked, double angular_velocity,
                                const FlowPoint& flow);

/// Returns a function that computes the state of the cell that the instrument shows, without noise,
/// from the time [s] since the first recording began. At the time `asked.time`, the instrument
/// shows the requested condition. At other times, the instrument may show another state, since an
/// effect on the instrument, such as a wobble of the lid, may depend on time. The true state is
/// constant.
/// @param asked requested condition: normal stress, inertial number, liquid content and time
/// @param flow true stress ratio [1] and true solid fraction [1] of the grains
/// @throws InputError if there is no true state that the instrument shows as the requested
///         condition
std::function<CellState(double)> shown_over_time(const LabPlan& plan, const Condition& asked,
                                                 const FlowPoint& flow);

/// Returns the reason why a physical effect cannot act in a virtual laboratory, as the end of a
/// message that begins with the name of the effect. The text is empty if the effect can act. An
/// effect on closures (formulas for the strength of wet grains) or on the predicted flow cannot
/// act, since closures and predicted flows belong to models only.
std::string why_not_in_lab(const Effect& effect);

/// Returns the series of recordings of a plan, in the order of measurement: `plan.series` or, if
/// this list is empty, one series of dry grains and one for each liquid content.
std::vector<LabSeries> series_of(const LabPlan& plan);

/// Returns the liquid contents of a plan's recordings [1], each once, in the order of measurement.
/// A liquid content is the liquid volume divided by the grain volume.
std::vector<double> contents_of(const LabPlan& plan);

/// Returns the parameters of the simulation run for a true condition of the grains, in reduced
/// units (grain diameter, grain mass and normal stress are 1). The caller must set the seed of the
/// run.
/// @param condition true condition of the grains (`imposed_condition`)
/// @param bridge_volume volume of a liquid bridge divided by the cubed grain diameter [1], used for
///         wet grains only
dem::RunParameters run_at(const LabPlan& plan, const EffectiveCondition& condition,
                          double bridge_volume);

/// Returns the parameters of a pilot run for a true condition of the grains, in reduced units
/// (grain diameter, grain mass and normal stress are 1). A pilot run is a simulation with few
/// grains and a short strain that measures the liquid content at a given bridge volume.
/// @param condition true condition of the grains (`imposed_condition`)
/// @param bridge_volume volume of a liquid bridge divided by the cubed grain diameter [1]
dem::RunParameters pilot_at(const LabPlan& plan, const EffectiveCondition& condition,
                            double bridge_volume);

}  // namespace pendular
