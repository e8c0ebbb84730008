#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/catalogue/effect.h"

namespace pendular::app {

/// Why a command cannot have an effect; empty where it can.
using WhyNot = std::function<std::string(const Effect&)>;

/// The options --EFFECT.PARAMETER of a command, one for each parameter of every built-in effect it
/// can have: a number with its unit, or a plain number in the parameter's SI unit.
class EffectOptions {
  public:
    /// Declares them under a heading of their own, `meaning`.
    /// @throws InputError where an argument names an effect or parameter that there is not, with
    ///         the nearest one, or an effect that the command cannot have, with the reason
    EffectOptions(Options& options, const std::vector<std::string>& arguments,
                  const std::string& meaning, const WhyNot& why_not = {});

    /// The effects that were given values other than neutral, by name; after parsing. What is on
    /// without being asked for (`given_by_liquid`) counts at neutral too.
    /// @throws InputError for what is no number, of the wrong dimension or beyond the bounds
    std::vector<ActiveEffect> effects() const;

  private:
    std::map<std::string, std::string> words_;  ///< as given, by "EFFECT.PARAMETER"
};

/// Words that give the first effect that is so the smallest effect of interest, for examples.
std::string example_of(const std::function<bool(const Effect&)>& wanted);

}  // namespace pendular::app
