#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"
#include "sim/lab/virtual_recording.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Plan of a virtual laboratory, which simulates rheometer recordings with known effects:
/// conditions, instrument, and the friction and effects that a calibration has to find. Values are
/// in SI units.
struct LabPlan {
    double friction = 0.09;  ///< true friction coefficient between the simulated grains [1]
    GrainProperties grains = {.diameter = 500e-6, .density = 1050, .poisson_ratio = 0.3};
    Liquid liquid = {.surface_tension = 20.6e-3};
    AnnularCell cell = {.inner_radius = 21e-3, .outer_radius = 45e-3, .bead_volume = 60e-3 / 1050};
    /// Normal stresses in dry recordings [Pa].
    std::vector<double> dry_normal_stresses = {300, 1000, 3000};
    /// Normal stresses in wet recordings [Pa].
    std::vector<double> wet_normal_stresses = {300, 600, 1000, 3000};
    /// Liquid volume divided by grain volume in the wet recordings [1]; empty: dry recordings only.
    std::vector<double> liquid_contents = {0.007, 0.03};
    /// Inertial numbers in all recordings [1].
    std::vector<double> inertial_numbers = {3e-3, 3e-2};
    /// Effects that act in the simulated recordings; study.toml does not state them.
    std::vector<ActiveEffect> effects;
    int replicates = 2;  ///< number of recordings planned for each liquid content, dry included
    Instrument instrument;
    Fidelity fidelity;
    std::uint64_t seed = 1;
};

/// Recording that a virtual laboratory is to simulate: one pass through all steps of constant set
/// points at one liquid content.
struct PlannedRecording {
    std::string file;  ///< name of the recording's file, as in "wet_0.03_1.csv"
    /// Liquid volume divided by grain volume in the recording [1]; 0: dry.
    double liquid_content = 0;
    /// Number of the recording among all recordings of its liquid content, from 1.
    int replicate = 1;
    std::uint64_t seed = 0;  ///< seed of the instrument's noise in the recording
    /// Requested condition and time of each step of the recording.
    std::vector<Condition> conditions;
};

/// Returns all recordings of a plan, in the order of measurement: first the dry recordings, then
/// the recordings of each liquid content. The recordings follow one another without a pause. The
/// time of a step of constant set points is the mean time of its part after the start-up transient
/// [s]; effects on the grains that depend on time keep the strength that they have at this mean
/// time throughout the step.
std::vector<PlannedRecording> recordings_of(const LabPlan& plan);

/// Returns the true condition of the grains, in SI units, at which the instrument shows the
/// requested condition. Effects on the instrument are inverted, effects of type `ChangeCondition`
/// are applied, and effects on grains are listed in `grain_effects`.
///
/// The height of the sample, which is unknown before the simulation, follows from a typical solid
/// fraction of 0.6. True heights differ by up to 4 %, which shifts the simulated condition by about
/// 0.1 %. The recording is made with the simulated height, so that the recorded set points equal
/// the requested ones exactly (`shown_over_time`).
/// @param asked requested condition
/// @throws InputError if there is no true state that the instrument shows as the requested
///         condition
EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked);

/// Returns a function of the time [s] since the first recording began: the state of the cell that
/// the instrument shows at that time, without noise. The true state is constant. It is the state
/// that the instrument shows as the requested condition at the time of this condition. The effects
/// on the instrument may change with time, as a wobble of the lid does.
/// @param asked requested condition
/// @param flow true stress ratio and solid fraction of the grains [1]
/// @throws InputError if there is no true state that the instrument shows as the requested
///         condition
std::function<CellState(double)> shown_over_time(const LabPlan& plan, const Condition& asked,
                                                 const FlowPoint& flow);

/// Returns the reason why an effect cannot act in a virtual laboratory, for messages that begin
/// with the name of the effect; empty if the effect can act. Effects on closures (formulas for the
/// strength of wet grains) and on predictions act on models only.
std::string why_no_lab_has(const Effect& effect);

/// Checks that a plan can be simulated and recorded, and that any two values planned for one
/// quantity (dry or wet normal stress, liquid content, inertial number) differ by at least 5 %.
/// @throws InputError if the plan fails a check; the message names the mistake
void check_plan(const LabPlan& plan);

/// Returns the requested condition of each step of a planned recording, in the order of
/// measurement. The times of the conditions are not set.
/// @param liquid_content liquid volume divided by grain volume of the recording [1]
std::vector<Condition> conditions_of(const LabPlan& plan, double liquid_content);

/// Returns the liquid contents (liquid volume divided by grain volume [1]) of a plan's recordings:
/// 0 (dry), then the values of `plan.liquid_contents`.
std::vector<double> contents_of(const LabPlan& plan);

/// Returns the parameters, in reduced units, of the simulation run at an imposed condition. The
/// caller must set the seed of the run.
/// @param bridge_volume volume of a liquid bridge divided by the cubed grain diameter [1], for wet
///         conditions
dem::RunParameters run_at(const LabPlan& plan, const EffectiveCondition& condition,
                          double bridge_volume);

/// Returns the parameters, in reduced units, of a pilot run at an imposed condition. A pilot run is
/// a smaller and shorter simulation that measures the liquid content at a given bridge volume.
/// @param bridge_volume volume of a liquid bridge divided by the cubed grain diameter [1]
dem::RunParameters pilot_at(const LabPlan& plan, const EffectiveCondition& condition,
                            double bridge_volume);

}  // namespace pendular
