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

/// Plan of a virtual laboratory: conditions, instrument and hidden truth; SI units.
struct LabPlan {
    double friction = 0.09;
    GrainProperties grains = {.diameter = 500e-6, .density = 1050, .poisson_ratio = 0.3};
    Liquid liquid = {.surface_tension = 20.6e-3};
    AnnularCell cell = {.inner_radius = 21e-3, .outer_radius = 45e-3, .bead_volume = 60e-3 / 1050};
    std::vector<double> dry_normal_stresses = {300, 1000, 3000};
    std::vector<double> wet_normal_stresses = {300, 600, 1000, 3000};
    std::vector<double> liquid_contents = {0.007, 0.03};  ///< none: dry recordings only
    std::vector<double> inertial_numbers = {3e-3, 3e-2};
    std::vector<ActiveEffect> effects;  ///< hidden; built-in ones
    int replicates = 2;
    Instrument instrument;
    Fidelity fidelity;
    std::uint64_t seed = 1;
};

/// A recording to be made: a replicate of all steps of one liquid content.
struct PlannedRecording {
    std::string file;
    double liquid_content = 0;
    int replicate = 1;
    std::uint64_t seed = 0;             ///< of the instrument
    std::vector<Condition> conditions;  ///< asked for, in the order measured, with their times
};

/// All recordings of the plan, which follow one another without a pause. The time of a step is the
/// mean time of its steady part, as `import` finds it; effects of time act on a step as they do
/// then.
std::vector<PlannedRecording> recordings_of(const LabPlan& plan);

/// True conditions behind the requested condition that the instrument shows: effects of the
/// instrument undone, those on beads and liquid applied, those on grains listed.
///
/// The height of the sample is not known before it has been simulated, so that here it is that of a
/// typical solid fraction, 0.6. The recording uses the simulated height: it shows the true state
/// exactly, at the requested set points (`shown_at_set_points`). The simulated heights differ from
/// the typical one by up to 4 %, which puts the simulated condition off by about 0.1 %.
/// @throws InputError where no true state is shown so
EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked);

/// State that the instrument shows, without noise, for grains with this flow at a requested
/// condition.
/// @throws InputError as imposed_condition
CellState shown_at_set_points(const LabPlan& plan, const Condition& asked, const FlowPoint& flow);

/// Refuses, before any work, what cannot be simulated, recorded or told apart.
/// @throws InputError saying what is wrong and what to do
void check_plan(const LabPlan& plan);

/// Condition of every step of one recording, in the order measured, without their times.
std::vector<Condition> conditions_of(const LabPlan& plan, double liquid_content);

/// Liquid contents of the recordings [1]: 0 (dry), then each wet one.
std::vector<double> contents_of(const LabPlan& plan);

/// Run that gives the true state at an imposed condition.
dem::RunParameters run_at(const LabPlan& plan, const EffectiveCondition& condition,
                          double bridge_volume);

/// Smaller and shorter run, to find the bridge volume.
dem::RunParameters pilot_at(const LabPlan& plan, const EffectiveCondition& condition,
                            double bridge_volume);

}  // namespace pendular
