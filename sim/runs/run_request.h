#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "data/reading.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns the effects on grains of a run in the form in which the solver applies them. Effects
/// whose parameters all have their neutral values are left out.
/// @param effects with values in reduced units (grain diameter, grain mass and imposed normal
///         stress are 1)
/// @param wet whether the run has liquid bridges
/// @throws std::invalid_argument if an effect is unknown, does not act on grains or acts on bridges
///         in a dry run, or if a value is out of its bounds
dem::GrainEffects grain_effects(const std::vector<EffectValues>& effects, bool wet);

/// Returns effects on grains, with values in reduced units, as text such as
///     rolling-resistance.coefficient=0.1 willett-bridges.on=1
std::string effects_text(const std::vector<EffectValues>& effects);
/// Returns the effects that a text states, sorted by name: the inverse of `effects_text`.
/// @throws std::invalid_argument if the text has another form or contains an unknown name
std::vector<EffectValues> effects_from(const std::string& text);

/// Checks, before any computation, that a run with its effects can be simulated.
/// @throws std::invalid_argument for a parameter out of range, which the message names, and for an
///         effect that is unknown, does not act on grains, or acts on bridges in a dry run
void check_run(const dem::RunParameters& run);

/// Returns the parameters that identify a simulation as lines "name = value", with numbers in their
/// shortest exact form. The number of threads is included, since it changes the rounding.
std::string run_description(const dem::RunParameters& run, int threads = 1);

/// Returns the 64-bit FNV-1a hash of a text. That of a run's `run_description` identifies the run.
std::uint64_t fingerprint(std::string_view text);

/// Carries out a simulation with the effects in `run.effects`, and returns the averages of its
/// observables. `options.description` is replaced by the run's `run_description`.
/// @throws std::invalid_argument for a run or effect that cannot be simulated
/// @throws dem::SimulationError if the simulation fails
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError if the checkpoint belongs to another run or another version of the program,
///         or is corrupt
dem::RunResult simulate(const dem::RunParameters& run, dem::RunOptions options = {});

}  // namespace pendular
