#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Parameter of a physical effect that a model may lack, such as the coefficient of wall friction.
struct EffectParameter {
    std::string name;             ///< name; "on" for a switch, whose value is 0 or 1
    std::string unit = "1";       ///< SI unit; "1": dimensionless
    double lower = 0, upper = 1;  ///< smallest and largest allowed value [unit]
    double neutral = 0;           ///< value at which the effect vanishes [unit]
    /// Smallest difference of the value from `neutral` that matters to a user [unit].
    double smallest_of_interest = 1;
    std::string meaning;  ///< meaning of the parameter in a few words
    /// Amplitude A(value) of the effect: the change of the observables is taken as proportional to
    /// A(value) - A(neutral). Needed for changes with zero slope at `neutral`, such as 1 -
    /// cos(angle). Null: A is the value itself.
    double (*amplitude)(double value) = nullptr;
    /// Effective amplitude at a value and an intergranular friction [1], for effects that friction
    /// limits: the emulator (Gaussian processes trained on simulations) takes the change of the
    /// observables as proportional to it. It is 0 at `neutral` and largest at `upper`. Null:
    /// `amplitude` is used.
    double (*effective_amplitude)(double value, double friction) = nullptr;

    /// Whether the effect is only on or off, with the parameter "on".
    bool is_switch() const { return name == "on"; }
};

/// Returns the parameter "on" of an effect that is only on or off: dimensionless, 0 (off, neutral)
/// or 1 (on), with this meaning.
EffectParameter on_switch(std::string meaning);

/// A physical effect, by name, with a value for each of its parameters.
struct EffectValues {
    std::string effect;          ///< name of the effect
    std::vector<double> values;  ///< one per parameter, in its unit and in the effect's order

    bool operator==(const EffectValues&) const = default;
};

/// Access to the values of an effect's parameters by name. Both arrays have one element per
/// parameter, in the same order, and must outlive this object, which does not copy them.
class Values {
  public:
    Values(std::span<const EffectParameter> parameters, std::span<const double> values)
        : parameters_(parameters), values_(values) {}

    /// Value of the parameter with this name, in the parameter's unit.
    /// @throws std::logic_error if the effect has no such parameter, an error of the program
    double operator[](std::string_view name) const;

  private:
    std::span<const EffectParameter> parameters_;
    std::span<const double> values_;
};

}  // namespace pendular
