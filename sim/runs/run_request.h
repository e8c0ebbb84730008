#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "data/reading.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/run.h"

namespace pendular {

/// Converts physical effects on grains into the object with which the solver applies the effects in
/// a run. An effect is left out if all its parameters have their neutral values, at which the
/// effect vanishes.
/// @param effects names of the effects, with parameter values in reduced units (grain diameter,
///         grain mass and imposed normal stress are 1)
/// @param wet whether the run has liquid bridges
/// @throws std::invalid_argument if an effect is unknown, does not act on grains or acts on bridges
///         in a dry run, or if a value is out of its bounds
dem::GrainEffects grain_effects(const std::vector<EffectValues>& effects, bool wet);

/// Returns physical effects on grains, with their parameter values in reduced units (grain
/// diameter, grain mass and imposed normal stress are 1), as text such as
///     rolling-resistance.coefficient=0.1 willett-bridges.on=1
std::string effects_text(const std::vector<EffectValues>& effects);
/// Returns the physical effects on grains, with their parameter values, that a text states, such as
/// "rolling-resistance.coefficient=0.1". The effects are sorted by name. The function is the
/// inverse of `effects_text`.
/// @throws std::invalid_argument if the text has another form or contains an unknown name
std::vector<EffectValues> effects_from(const std::string& text);

/// Checks, before any computation, that a run with its physical effects on grains can be simulated.
/// @throws std::invalid_argument for a parameter out of range, which the message names, and for an
///         effect that is unknown, does not act on grains, or acts on bridges in a dry run
void check_run(const dem::RunParameters& run);

/// Returns a text that identifies a simulation. The text contains the parameters of the simulation
/// as lines "name = value", with numbers in their shortest exact form. The number of threads is
/// included, since it changes the rounding of the results.
std::string run_description(const dem::RunParameters& run, int threads = 1);

/// Returns the 64-bit FNV-1a hash of a text. The hash of a run's `run_description` identifies the
/// run.
std::uint64_t fingerprint(std::string_view text);

/// Carries out a simulation with the physical effects on grains in `run.effects`, and returns the
/// averages of the observables. The function replaces `options.description` by the
/// `run_description` of the run.
/// @throws std::invalid_argument for a run or effect that cannot be simulated
/// @throws dem::SimulationError if the simulation fails
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError if the checkpoint belongs to a run other than `run` or to another version of
///         the program, or is corrupt
dem::RunResult simulate(const dem::RunParameters& run, dem::RunOptions options = {});

}  // namespace pendular
