#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/effect_options.h"
#include "app/options.h"
#include "sim/runs/single_run.h"

namespace pendular::app {

/// Physical effects of a single simulation, set by command-line options. The user gives the
/// parameters of the effects with their units. Reference quantities (the scale) make the parameters
/// dimensionless: diameter and density of the grains, normal stress, and surface tension.
class RunEffects {
  public:
    /// Adds the options for the effects, --EFFECT.PARAMETER, and for the scale (grains, normal
    /// stress, surface tension) to a command.
    /// @param arguments words of the command line
    /// @throws InputError if an argument names an effect or parameter that does not exist, or an
    ///         effect that a single simulation cannot have
    RunEffects(Options& options, const std::vector<std::string>& arguments);

    /// Returns the parameters of a simulation with the effects of the parsed options applied.
    /// @throws InputError if an option's value is malformed or out of bounds, if the user gave a
    ///         normal stress for wet grains or a surface tension for dry grains, or if an effect
    ///         cannot change this simulation
    dem::RunParameters changed(const dem::RunParameters& run, const Options& options);

    /// Prints the effects that `RunEffects::changed` applied. If the effects changed the friction
    /// coefficient or the reduced pressure, also prints the new value. If an effect has parameters
    /// in SI units, also prints the scale (grains, normal stress, surface tension). If no effect
    /// has such parameters but the user gave the scale, prints a note that the scale changes
    /// nothing.
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
    /// Whether an effect has parameters in SI units, which `scale_` makes dimensionless.
    bool scaled_ = false;
    /// Whether the user gave an option for a quantity of `scale_`, such as the grain diameter.
    bool scale_given_ = false;
    /// Parameters of the simulation before the effects were applied.
    dem::RunParameters without_;
};

/// Returns an option for the examples in a help text, "--EFFECT.PARAMETER VALUE". The option sets
/// the first parameter of an effect to the value at which the effect has its smallest size of
/// interest. The effect is the first built-in effect on grains that is not a switch (on or off).
std::string example_of_run();

}  // namespace pendular::app
