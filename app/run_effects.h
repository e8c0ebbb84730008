#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/effect_options.h"
#include "app/options.h"
#include "sim/runs/single_run.h"

namespace pendular::app {

/// Effects of a single simulation, set by command-line options with units. The parameters become
/// dimensionless by the scale: diameter and density of the grains, normal stress, and surface
/// tension.
class RunEffects {
  public:
    /// Adds the options --EFFECT.PARAMETER and those of the scale to a command.
    /// @param arguments words of the command line
    /// @throws InputError if an argument names an effect or parameter that does not exist, or an
    ///         effect that a single simulation cannot have
    RunEffects(Options& options, const std::vector<std::string>& arguments);

    /// Returns the parameters of a simulation with the effects of the parsed options applied.
    /// @throws InputError if an option's value is malformed or out of bounds, if the user gave a
    ///         normal stress for wet grains or a surface tension for dry grains, or if an effect
    ///         cannot change this simulation
    dem::RunParameters changed(const dem::RunParameters& run, const Options& options);

    /// Prints the effects that `changed` applied, a friction coefficient or reduced pressure that
    /// they changed and, if an effect has parameters in SI units, the scale. If none has but the
    /// user gave the scale, prints a note that the scale changes nothing.
    /// @param changed parameters of the simulation with the effects
    void print(Console& console, const dem::RunParameters& changed) const;
    /// Adds to the JSON of a simulation the key `effects` and, if an effect has parameters in SI
    /// units, the key `scale` in SI units. Adds nothing if the simulation has no effects.
    void add_to(nlohmann::ordered_json& json) const;

  private:
    void read_scale(const dem::RunParameters& run, const Options& options);

    std::string diameter_ = "500 um", density_ = "1050 kg/m^3", normal_stress_ = "1 kPa",
                surface_tension_ = "20.6 mN/m";
    EffectOptions options_;
    std::vector<ActiveEffect> effects_;
    RunScale scale_;
    bool scaled_ = false;         ///< whether an effect has parameters in SI units
    bool scale_given_ = false;    ///< whether the user gave a quantity of `scale_`
    dem::RunParameters without_;  ///< before the effects were applied
};

/// Returns the `example_of` the first built-in effect on grains that is not a switch (on or off).
std::string example_of_run();

}  // namespace pendular::app
