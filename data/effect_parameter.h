#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// A parameter of an effect.
struct EffectParameter {
    std::string name;  ///< "on": a switch, 0 or 1
    std::string unit = "1";
    double lower = 0, upper = 1;      ///< [unit]
    double neutral = 0;               ///< value at which the effect is gone [unit]
    double smallest_of_interest = 1;  ///< how far from neutral it would matter to a user [unit]
    std::string meaning;
    /// Amplitude to which the effect is proportional, as a function of the parameter's value; the
    /// value itself where empty. It must not have a zero slope at neutral, as 1 - cos has.
    double (*amplitude)(double value) = nullptr;
    /// Effective amplitude of an effect on grains at a given friction, for effects that friction
    /// limits; 0 at neutral and largest at `upper`. The emulator trains responses on it.
    double (*effective_amplitude)(double value, double friction) = nullptr;

    bool is_switch() const { return name == "on"; }
};

/// The parameter of a switch.
EffectParameter on_switch(std::string meaning);

/// Values of the parameters of an effect.
struct EffectValues {
    std::string effect;          ///< its name
    std::vector<double> values;  ///< in the order of its parameters

    bool operator==(const EffectValues&) const = default;
};

/// Values of an effect's parameters, by name; a view.
class Values {
  public:
    Values(std::span<const EffectParameter> parameters, std::span<const double> values)
        : parameters_(parameters), values_(values) {}

    /// Value of the parameter of that name, in its unit; aborts if there is none, since names in
    /// the program are constants.
    double operator[](std::string_view name) const;

  private:
    std::span<const EffectParameter> parameters_;
    std::span<const double> values_;
};

}  // namespace pendular
