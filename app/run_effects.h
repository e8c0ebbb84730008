#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/effect_options.h"
#include "app/options.h"
#include "sim/runs/single_run.h"

namespace pendular::app {

/// Effects of a single run as the user gives them, with the scale for effects whose parameters are
/// in SI units: diameter, density, normal stress and surface tension.
class RunEffects {
  public:
    /// Declares the options for the effects and for the scale.
    /// @throws InputError where an argument names an effect or parameter that does not exist, or an
    ///         effect that a single run cannot have
    RunEffects(Options& options, const std::vector<std::string>& arguments);

    /// Returns the run with the effects of the parsed options.
    /// @throws InputError for a value out of bounds, for a scale that contradicts the run, and for
    ///         an effect that does not act on its grains, dry or wet as they are
    dem::RunParameters changed(const dem::RunParameters& run, const Options& options);

    /// Prints the effects of the run and, where an effect depends on it, the scale.
    void print(Console& console, const dem::RunParameters& changed) const;
    /// Adds the key `effects` and, where an effect depends on it, the key `scale` [SI units].
    void add_to(nlohmann::ordered_json& json) const;

  private:
    void read_scale(const dem::RunParameters& run, const Options& options);

    std::string diameter_ = "500 um", density_ = "1050 kg/m^3", normal_stress_ = "1 kPa",
                surface_tension_ = "20.6 mN/m";
    EffectOptions options_;
    std::vector<ActiveEffect> effects_;
    RunScale scale_;
    bool scaled_ = false;         ///< whether an effect depends on the scale
    bool scale_given_ = false;    ///< whether the user gave a part of the scale
    dem::RunParameters without_;  ///< run without the effects
};

/// Option for the examples of the help text, "--EFFECT.PARAMETER VALUE", that sets an effect on
/// grains to its smallest size of interest.
std::string example_of_run();

}  // namespace pendular::app
