#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/effect_options.h"
#include "app/options.h"
#include "sim/runs/single_run.h"

namespace pendular::app {

/// Physical effects of a single simulation run, as the user gives them by options. Parameters in SI
/// units are converted to the reduced units of the run by a scale: diameter and density of the
/// beads, normal stress, and surface tension.
class RunEffects {
  public:
    /// Adds the options for the effects, --EFFECT.PARAMETER, and for the scale to a command.
    /// @param arguments words of the command line
    /// @throws InputError where an argument names an effect or parameter that does not exist, or an
    ///         effect that a single run cannot have
    RunEffects(Options& options, const std::vector<std::string>& arguments);

    /// Returns the parameters of a run with the effects of the parsed options applied.
    /// @throws InputError for an option's value that is malformed or out of bounds, for a scale
    ///         that contradicts the run, and for an effect that cannot change this run, such as an
    ///         effect of the liquid for a dry run
    dem::RunParameters changed(const dem::RunParameters& run, const Options& options);

    /// Prints a line with the effects that `RunEffects::changed` applied, and with the friction and
    /// reduced pressure of the run if an effect changed these. Then prints the scale if an effect
    /// has parameters in SI units.
    /// @param changed parameters of the run with the effects
    void print(Console& console, const dem::RunParameters& changed) const;
    /// Adds to the JSON of a run the key `effects` and, if an effect has parameters in SI units,
    /// the key `scale` in SI units. Adds nothing where the run has no effects.
    void add_to(nlohmann::ordered_json& json) const;

  private:
    void read_scale(const dem::RunParameters& run, const Options& options);

    std::string diameter_ = "500 um", density_ = "1050 kg/m^3", normal_stress_ = "1 kPa",
                surface_tension_ = "20.6 mN/m";
    EffectOptions options_;
    std::vector<ActiveEffect> effects_;
    RunScale scale_;
    bool scaled_ = false;       ///< whether an effect has parameters that `scale_` converts
    bool scale_given_ = false;  ///< whether the user gave an option for a part of `scale_`
    /// Parameters of the run before the effects were applied.
    dem::RunParameters without_;
};

/// Returns an option for the examples in a help text, "--EFFECT.PARAMETER VALUE". It sets the first
/// built-in effect on grains that has a parameter to the smallest value of interest.
std::string example_of_run();

}  // namespace pendular::app
