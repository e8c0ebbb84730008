#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Parameter of a physical effect that a model may lack, such as the coefficient of wall friction.
struct EffectParameter {
    /// Name of the effect's parameter. The name is "on" for an effect that can only be switched on
    /// or off.
    std::string name;
    std::string unit = "1";  ///< SI unit of the effect's parameter; "1": dimensionless
    /// Smallest and largest allowed value of the effect's parameter, in the parameter's unit.
    double lower = 0, upper = 1;
    /// Value of the effect's parameter at which the effect vanishes, in the parameter's unit.
    double neutral = 0;
    /// Smallest difference between the parameter's value and `neutral` that is of interest to the
    /// user, in the parameter's unit. An effect with a smaller difference may be ignored.
    double smallest_of_interest = 1;
    /// Explanation of the effect's parameter in a few words, which is printed for the user.
    std::string meaning;
    /// Function that returns the amplitude A of the effect at a value of the parameter; null:
    /// A(value) = value. The effect is assumed to change predicted values, such as the stress
    /// ratio, in proportion to A(value) - A(neutral). A function is needed if the derivative of the
    /// predicted values is 0 at the neutral value, as for A = 1 - cos(angle) at angle 0.
    double (*amplitude)(double value) = nullptr;
    /// Function that returns the effective amplitude of the effect at a value of the parameter and
    /// a friction coefficient between grains [1]; null: the function `amplitude` is used. The
    /// emulator (Gaussian processes trained on simulations) assumes that the effect changes the
    /// results of a simulation in proportion to the effective amplitude. The effective amplitude is
    /// 0 at the neutral value and largest at the upper bound of the parameter. An example is
    /// rolling resistance, whose effect is limited because grains slide before they roll.
    double (*effective_amplitude)(double value, double friction) = nullptr;

    /// Whether the parameter is never fitted to measured data, because measured data can hardly
    /// separate the parameter from the effect's other parameters. The parameter then keeps its
    /// neutral value, except in simulations for which the user states another value.
    bool only_simulated = false;

    /// Whether the effect can only be switched on or off, so that its parameter has the name "on".
    bool is_switch() const { return name == "on"; }
    /// Whether the parameter can be fitted to measured data.
    bool is_fitted() const { return !is_switch() && !only_simulated; }
    /// Returns the value, in the parameter's unit, that the parameter has in models that do not fit
    /// the parameter. The value is 1 (on) for an effect that can only be switched on or off. For
    /// every other effect, the value is the neutral value, at which the effect vanishes.
    double value_if_not_fitted() const { return is_switch() ? 1 : neutral; }
};

/// Returns the parameter of an effect that can only be switched on or off: the parameter has the
/// name "on", is dimensionless, and has the value 0 (off, neutral) or 1 (on).
/// @param meaning explanation of the parameter in a few words, for the user
EffectParameter on_switch(std::string meaning);

/// Name of a physical effect, with a value for each parameter of the effect.
struct EffectValues {
    std::string effect;  ///< name of the physical effect
    /// Value of each parameter of the effect, in the parameter's unit and in the order of
    /// `Effect::parameters`.
    std::vector<double> values;

    bool operator==(const EffectValues&) const = default;
};

/// Values of an effect's parameters, accessed by the names of the parameters. The constructor
/// receives two arrays: the parameters, and the values of the parameters in equal order. The arrays
/// are not copied and must outlive the `Values` object.
class Values {
  public:
    Values(std::span<const EffectParameter> parameters, std::span<const double> values)
        : parameters_(parameters), values_(values) {}

    /// Returns the value of the effect's parameter with a given name, in the parameter's unit.
    /// @throws std::logic_error if the effect has no parameter with the given name, which is a
    ///         programming error
    double operator[](std::string_view name) const;

  private:
    std::span<const EffectParameter> parameters_;
    std::span<const double> values_;
};

}  // namespace pendular
