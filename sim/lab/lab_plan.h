#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"
#include "sim/lab/virtual_recording.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Plan of a virtual laboratory, which simulates rheometer recordings with known effects:
/// conditions, instrument, and the friction and effects that a calibration has to find. SI units.
struct LabPlan {
    double friction = 0.09;  ///< true friction coefficient [1]
    GrainProperties grains = {.diameter = 500e-6, .density = 1050, .poisson_ratio = 0.3};
    Liquid liquid = {.surface_tension = 20.6e-3};
    AnnularCell cell = {.inner_radius = 21e-3, .outer_radius = 45e-3, .bead_volume = 60e-3 / 1050};
    std::vector<double> dry_normal_stresses = {300, 1000, 3000};       ///< for dry recordings [Pa]
    std::vector<double> wet_normal_stresses = {300, 600, 1000, 3000};  ///< of wet recordings [Pa]
    /// Liquid contents Phi_L/Phi_S of the wet recordings [1]; empty: dry recordings only.
    std::vector<double> liquid_contents = {0.007, 0.03};
    std::vector<double> inertial_numbers = {3e-3, 3e-2};  ///< of all recordings [1]
    std::vector<ActiveEffect> effects;  ///< true effects, which study.toml does not state
    int replicates = 2;                 ///< recordings of each liquid content, dry included
    Instrument instrument;
    Fidelity fidelity;
    std::uint64_t seed = 1;
};

/// A recording to be simulated: one replicate of all steps (constant set points) of one liquid
/// content.
struct PlannedRecording {
    std::string file;                   ///< file name, as in "wet_0.03_1.csv"
    double liquid_content = 0;          ///< liquid over grain volume [1]; 0: dry
    int replicate = 1;                  ///< number among equal recordings, from 1
    std::uint64_t seed = 0;             ///< seed of the instrument's noise
    std::vector<Condition> conditions;  ///< requested condition and time of each step
};

/// Returns all recordings of the plan, which follow one another without a pause. The time of a step
/// (constant set points) is the mean time of its part after the start-up transient [s]; effects
/// that depend on time have their value at this time throughout the step.
std::vector<PlannedRecording> recordings_of(const LabPlan& plan);

/// Returns the condition that is truly imposed on the grains, SI units, where the instrument shows
/// the requested condition `asked`: effects on the instrument are inverted, effects of type
/// ChangeCondition are applied, and effects on grains are listed in `grain_effects`.
///
/// The height of the sample is unknown before the simulation and is taken at a typical solid
/// fraction of 0.6. The recording uses the simulated height instead, so that it shows the true
/// state exactly at the requested set points (`shown_at_set_points`). The simulated heights differ
/// from the typical height by up to 4 %, which shifts the simulated condition by about 0.1 %.
/// @throws InputError where no true state is shown as the requested condition
EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked);

/// Returns the state of the cell that the instrument shows, without noise, at the requested
/// condition `asked` for grains with the stress ratio and solid fraction of `flow`.
/// @throws InputError where no true state is shown as the requested condition
CellState shown_at_set_points(const LabPlan& plan, const Condition& asked, const FlowPoint& flow);

/// Returns the reason why no virtual laboratory can have an effect, for messages that begin with
/// the name of the effect; empty where it can have the effect. Effects on closures and on
/// predictions act on models alone.
std::string why_no_lab_has(const Effect& effect);

/// Checks that a plan can be simulated and recorded, and that any two values planned for one
/// quantity (dry or wet normal stress, liquid content, inertial number) differ by at least 5 %.
/// @throws InputError where the plan fails a check, naming the mistake
void check_plan(const LabPlan& plan);

/// Returns the requested condition of each step of a recording with this liquid content [1], in the
/// order of measurement, without times.
std::vector<Condition> conditions_of(const LabPlan& plan, double liquid_content);

/// Returns the liquid contents Phi_L/Phi_S for which the plan has recordings [1]: 0 (dry), then the
/// values of `plan.liquid_contents`.
std::vector<double> contents_of(const LabPlan& plan);

/// Returns the parameters, in reduced units, of the run that simulates an imposed condition; the
/// caller sets its seed. `bridge_volume`: volume of a bridge V0/a^3 [1], used for wet conditions.
dem::RunParameters run_at(const LabPlan& plan, const EffectiveCondition& condition,
                          double bridge_volume);

/// Returns the parameters, in reduced units, of a pilot run: a smaller and shorter run at an
/// imposed condition, whose simulation gives the liquid content [1] of a bridge volume V0/a^3 [1].
dem::RunParameters pilot_at(const LabPlan& plan, const EffectiveCondition& condition,
                            double bridge_volume);

}  // namespace pendular
