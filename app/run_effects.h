#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/effect_options.h"
#include "app/options.h"
#include "sim/runs/single_run.h"

namespace pendular::app {

/// The effects of a single run as the user gives them, with the scale of those in SI units.
class RunEffects {
  public:
    /// Declares the options.
    /// @throws InputError as EffectOptions
    RunEffects(Options& options, const std::vector<std::string>& arguments);

    /// The run as the effects make it; after parsing.
    /// @throws InputError for a value out of bounds, a scale that contradicts the run, and an
    ///         effect that does not touch its beads
    dem::RunParameters changed(const dem::RunParameters& run, const Options& options);

    /// Says what was changed, and at which scale where it matters.
    void print(Console& console, const dem::RunParameters& changed) const;
    /// Adds `effects`, and `scale` where it matters.
    void add_to(nlohmann::ordered_json& json) const;

  private:
    void read_scale(const dem::RunParameters& run, const Options& options);

    std::string diameter_ = "500 um", density_ = "1050 kg/m^3", normal_stress_ = "1 kPa",
                surface_tension_ = "20.6 mN/m";
    EffectOptions options_;
    std::vector<ActiveEffect> effects_;
    RunScale scale_;
    bool scaled_ = false;  ///< whether an effect depends on the scale
    bool scale_given_ = false;
    dem::RunParameters without_;
};

/// For examples: an effect on grains that has a number.
std::string example_of_run();

}  // namespace pendular::app
