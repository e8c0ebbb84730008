#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/catalogue/effect.h"

namespace pendular::app {

/// Function that returns why a command cannot have an effect; an empty text where it can.
using WhyNot = std::function<std::string(const Effect&)>;

/// Options --EFFECT.PARAMETER of a command, one for each parameter of every built-in effect that
/// the command can have. The value is a number with its unit, or a plain number in the parameter's
/// SI unit.
class EffectOptions {
  public:
    /// Declares the options in a section of the help text with the heading `meaning`.
    /// @throws InputError where an argument names an effect or parameter that does not exist, with
    ///         the nearest name, or an effect that the command cannot have, with the reason
    EffectOptions(Options& options, const std::vector<std::string>& arguments,
                  const std::string& meaning, const WhyNot& why_not = {});

    /// Returns the effects that the parsed options set to a value other than neutral, sorted by
    /// name. An effect whose parameter is a property of the liquid (`given_by_liquid`) is returned
    /// at neutral too, if its option was given.
    /// @throws InputError for a value that is not a number, has the wrong dimension or is out of
    ///         bounds
    std::vector<ActiveEffect> effects() const;

  private:
    std::map<std::string, std::string> words_;  ///< values as given, by "EFFECT.PARAMETER"
};

/// Option for the examples of a help text, "--EFFECT.PARAMETER VALUE", that sets the first built-in
/// effect for which `wanted` holds to its smallest size of interest; empty where there is none.
std::string example_of(const std::function<bool(const Effect&)>& wanted);

}  // namespace pendular::app
