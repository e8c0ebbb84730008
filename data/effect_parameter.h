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

/// Unit in which values of a quantity are printed.
struct PrintedUnit {
    std::string name;  ///< such as "mN m"; "1": dimensionless
    double si = 1;     ///< size of one printed unit in the SI unit: 0.001 for "mN m"
};

/// Returns the unit in which all values of a parameter are printed: degrees for an angle, otherwise
/// its SI unit, with the prefix m if both bounds are below 1 in magnitude and u if both are below
/// 0.001. Numbers without dimension, and units such as "kg" and "m^2", get no prefix.
PrintedUnit printed_unit(const EffectParameter& parameter);

/// Returns a value [SI unit] in the printed unit with four significant digits, such as "0.1 mN m"
/// or "10 deg", or "0.3" for a dimensionless parameter.
std::string printed_value(double value, const EffectParameter& parameter);

/// Returns `printed_value` as one argument of a shell command: a text with a unit is in double
/// quotes, which are part of the text.
std::string printed_word(double value, const EffectParameter& parameter);

/// Returns the bounds of a parameter in the printed unit, such as "-100 to 100 mN m".
std::string printed_bounds(const EffectParameter& parameter);

}  // namespace pendular
