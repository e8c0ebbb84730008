#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Parameter of an effect, such as the coefficient of wall friction. Values, bounds and
/// differences are in the parameter's `unit`.
struct EffectParameter {
    std::string name;             ///< "on" for an effect that can only be switched on or off
    std::string unit = "1";       ///< SI unit; "1": dimensionless
    double lower = 0, upper = 1;  ///< smallest and largest allowed value
    double neutral = 0;           ///< value at which the effect vanishes
    /// Smallest effect of interest, as a difference from `neutral`.
    double smallest_of_interest = 1;
    std::string meaning;  ///< explanation in a few words, printed for the user
    /// Function that returns the amplitude A of the effect at a value; null: A(value) = value. The
    /// effect is assumed to change predicted values in proportion to A(value) - A(neutral). A
    /// function is needed if the derivative of the predicted values is 0 at the neutral value, as
    /// for A = 1 - cos(angle) at angle 0.
    double (*amplitude)(double value) = nullptr;
    /// Function that returns the effective amplitude at a value and a friction coefficient between
    /// grains [1]; null: `amplitude` is used. The emulator assumes that the effect changes the
    /// results of a simulation in proportion to it. It is 0 at the neutral value and largest at the
    /// upper bound. An example is rolling resistance, whose effect is limited because grains slide
    /// before they roll.
    double (*effective_amplitude)(double value, double friction) = nullptr;

    /// Whether the parameter is never fitted, because measured data can hardly separate it from the
    /// effect's other parameters. It then keeps its neutral value, except in simulations for which
    /// the user states another value.
    bool only_simulated = false;

    bool is_switch() const { return name == "on"; }
    /// Whether the parameter can be fitted to measured data.
    bool is_fitted() const { return !is_switch() && !only_simulated; }
    /// Returns the value in models that contain the effect but do not fit the parameter.
    double value_if_not_fitted() const { return is_switch() ? 1 : neutral; }
};

/// Returns the dimensionless parameter "on" of an effect that can only be switched: 0 is off and
/// neutral, 1 is on.
EffectParameter on_switch(std::string meaning);

/// Values of all parameters of one effect.
struct EffectValues {
    std::string effect;
    std::vector<double> values;  ///< [parameter's unit], in the order of `Effect::parameters`

    bool operator==(const EffectValues&) const = default;
};

/// Values of an effect's parameters, accessed by the names of the parameters. The two arrays, in
/// equal order, are not copied and must outlive the object.
class Values {
  public:
    Values(std::span<const EffectParameter> parameters, std::span<const double> values)
        : parameters_(parameters), values_(values) {}

    /// Returns the value of the parameter with a given name, in the parameter's unit.
    /// @throws std::logic_error if there is no such parameter, which is a programming error
    double operator[](std::string_view name) const;

  private:
    std::span<const EffectParameter> parameters_;
    std::span<const double> values_;
};

}  // namespace pendular
