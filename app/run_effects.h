#pragma once

#include <string>
#include <vector>

#include "app/console.h"
#include "app/effect_options.h"
#include "app/options.h"
#include "workflow/json/run.h"

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

    /// Returns a simulation with these effects, for its texts. This object and `run` must outlive
    /// it.
    Simulated simulated(const dem::RunResult& run, int threads) const;

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
