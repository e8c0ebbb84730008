#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/catalogue/effect.h"

namespace pendular::app {

/// Function that returns the reason why a physical effect cannot be switched on in a command, for
/// messages; an empty text where it can.
using WhyNot = std::function<std::string(const Effect&)>;

/// Options --EFFECT.PARAMETER of a command, one for each parameter of every built-in physical
/// effect that can be switched on in the command. An option's value is a number with its unit, or a
/// plain number in the parameter's SI unit.
class EffectOptions {
  public:
    /// Adds the options to `options`, in a section of the help text with the heading `meaning`, and
    /// checks the names of the options in the command line `arguments`.
    /// @param why_not reason why an effect has no option here; empty: every effect has options
    /// @throws InputError where an argument names an effect or parameter that does not exist, or an
    ///         effect for which `why_not` returns a reason
    EffectOptions(Options& options, const std::vector<std::string>& arguments,
                  const std::string& meaning, const WhyNot& why_not = {});

    /// Returns the effects that the parsed options set to a value at which the effect does not
    /// vanish, in the order of `built_in_effects`. An effect whose parameter is a property of the
    /// liquid (`given_by_liquid`) is returned even where it vanishes, if its option was given.
    /// @throws InputError for an option whose value is not a number, has a unit of another
    ///         dimension or is out of the parameter's bounds
    std::vector<ActiveEffect> effects() const;

  private:
    /// Texts of the options' values as the user gave them, by "EFFECT.PARAMETER"; empty: not given.
    std::map<std::string, std::string> words_;
};

/// Names of all built-in effects.
std::vector<std::string> names_of_effects();

/// Text for the examples in a help text, "--EFFECT.PARAMETER VALUE": option that sets the first
/// parameter of the first built-in effect for which `wanted` is true to the smallest change that
/// matters; empty where `wanted` is true for no effect.
std::string example_of(const std::function<bool(const Effect&)>& wanted);

}  // namespace pendular::app
