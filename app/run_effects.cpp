#include "app/run_effects.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "data/input_error.h"
#include "data/quantities/units.h"

namespace pendular::app {
namespace {

/// Value in SI units of a quantity with its unit, "500 um", as an option gives it.
/// @throws InputError naming the option, where the text is not a quantity of the dimension of
///         `unit` or is not positive
double positive(const std::string& words, const char* unit, const std::string& option) {
    double value = 0;
    try {
        value = quantity_in_si(words, Unit(unit));
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("--{}: {}", option, error.what()));
    }
    if (!(value > 0)) {
        throw InputError(fmt::format("--{} \"{}\": a value above 0 is needed", option, words));
    }
    return value;
}

}  // namespace

RunEffects::RunEffects(Options& options, const std::vector<std::string>& arguments)
    : options_([&]() -> EffectOptions {
          options.begin_section(
              "Physical size and stress of the sample (needed for effects whose parameters have "
              "units)");
          options.add("diameter", &diameter_,
                      "diameter of the grains, with its unit (default 500 um)");
          options.add("density", &density_,
                      "density of the grains, with its unit (default 1050 kg/m^3)");
          options.add("normal-stress", &normal_stress_,
                      "normal stress on dry grains, with its unit (default 1 kPa); on wet grains "
                      "it follows from P* and the surface tension Gamma: P* pi Gamma/a, with the "
                      "grain diameter a");
          options.add("surface-tension", &surface_tension_,
                      "nominal surface tension Gamma of the liquid, with its unit (default 20.6 "
                      "mN/m); the normal stress on wet grains is computed from it. If the liquid "
                      "has another surface tension, state that one with "
                      "--capillary-bridges.surface_tension");
          return {options, arguments,
                  "Physical effects of grains and liquid (values with their unit, as in \"3 uN\"; "
                  "a number without a unit is in SI units)",
                  why_not_in_run};
      }()) {}

void RunEffects::read_scale(const dem::RunParameters& run, const Options& options) {
    if (run.wetting && options.given("normal-stress")) {
        throw InputError(
            "--normal-stress and --reduced-pressure contradict each other: P* and the surface "
            "tension give the normal stress, P* pi Gamma/a; remove one of them");
    }
    if (!run.wetting && options.given("surface-tension")) {
        throw InputError(
            "--surface-tension needs --reduced-pressure: without it the grains are dry");
    }
    scale_.grains.diameter = positive(diameter_, "m", "diameter");
    scale_.grains.density = positive(density_, "kg/m^3", "density");
    scale_.normal_stress = positive(normal_stress_, "Pa", "normal-stress");
    scale_.liquid.surface_tension = positive(surface_tension_, "N/m", "surface-tension");
    scale_ = scale_.of(run);
    scale_given_ = std::ranges::any_of(
        std::vector<std::string>{"diameter", "density", "normal-stress", "surface-tension"},
        [&](const std::string& name) { return options.given(name); });
}

dem::RunParameters RunEffects::changed(const dem::RunParameters& run, const Options& options) {
    read_scale(run, options);
    effects_ = options_.effects();
    scaled_ = std::ranges::any_of(
        effects_, [](const ActiveEffect& active) { return needs_scale(*active.effect); });
    without_ = run;
    try {
        return changed_run(run, effects_, scale_);
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

Simulated RunEffects::simulated(const dem::RunResult& run, int threads) const {
    return {.run = run,
            .without = without_,
            .effects = effects_,
            .scale = scaled_ ? std::optional(scale_) : std::nullopt,
            .scale_given = scale_given_,
            .threads = threads};
}

std::string example_of_run() {
    return example_of(
        [](const Effect& effect) { return effect.of_grains() && !effect.is_switch(); });
}

}  // namespace pendular::app
