#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/catalogue/effect.h"

namespace pendular::app {

/// Function that returns the reason, as text for messages, why an effect cannot be switched on in a
/// command; empty if it can.
using WhyNot = std::function<std::string(const Effect&)>;

/// Command-line options --EFFECT.PARAMETER, one for each parameter of every built-in effect that a
/// command can switch on. The value is a number with its unit, or a plain number in the SI unit of
/// the parameter.
class EffectOptions {
  public:
    /// Adds the options to a command, and checks the names of effects and parameters in
    /// `arguments`.
    /// @param arguments words of the command line
    /// @param meaning heading above these options in the help text
    /// @param why_not reason why an effect has no option in this command; empty: all have options
    /// @throws InputError if an argument names an effect or parameter that does not exist, or an
    ///         effect for which `why_not` returns a reason
    EffectOptions(Options& options, const std::vector<std::string>& arguments,
                  const std::string& meaning, const WhyNot& why_not = {});

    /// Returns the effects that the options switch on, with their parameters in SI units, in the
    /// order of `built_in_effects`. Leaves out an effect whose parameters all have their neutral
    /// values (no effect), unless a parameter is a property of the liquid
    /// (`Effect::given_by_liquid`).
    /// @throws InputError if a value is not a number, has a unit of the wrong dimension or is
    ///         outside the parameter's bounds
    std::vector<ActiveEffect> effects() const;

  private:
    /// Values as the user typed them, empty if not given. The key is "EFFECT.PARAMETER".
    std::map<std::string, std::string> words_;
};

/// Returns the names of all built-in effects.
std::vector<std::string> names_of_effects();

/// Returns an option for the examples in a help text, "--EFFECT.PARAMETER VALUE": the first
/// parameter of the first `wanted` effect, at the value of its smallest size of interest. Empty if
/// no effect is wanted.
std::string example_of(const std::function<bool(const Effect&)>& wanted);

}  // namespace pendular::app
