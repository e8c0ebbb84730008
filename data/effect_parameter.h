#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Parameter of a physical effect that a model may lack, such as the coefficient of wall friction.
struct EffectParameter {
    /// Name of the effect's parameter; "on" for an effect that can only be switched on or off.
    std::string name;
    std::string unit = "1";  ///< SI unit of the effect's parameter; "1": dimensionless
    /// Smallest and largest allowed value of the effect's parameter, in the parameter's unit.
    double lower = 0, upper = 1;
    /// Value of the parameter at which the effect vanishes, in the parameter's unit.
    double neutral = 0;
    /// Smallest effect of interest to the user: difference between the parameter's value and
    /// `neutral` below which the effect may be ignored, in the parameter's unit.
    double smallest_of_interest = 1;
    std::string meaning;  ///< meaning of the effect's parameter in a few words, for the user
    /// Function that returns the amplitude A(value) of the effect: the change of the observables is
    /// taken as proportional to A(value) - A(neutral). Here `neutral` is the value at which the
    /// effect vanishes. The function is needed if the slope of the change is zero at that value, as
    /// the slope of 1 - cos(angle) at angle 0. Null: A(value) = value.
    double (*amplitude)(double value) = nullptr;
    /// Function that returns the effective amplitude at a value of the parameter and a friction
    /// coefficient between grains [1], for effects that friction limits, such as rolling
    /// resistance. The emulator (Gaussian processes trained on simulations) takes the change of the
    /// observables as proportional to the effective amplitude, which is 0 at the neutral value of
    /// the parameter and largest at its upper bound. Null: the function `amplitude` is used.
    double (*effective_amplitude)(double value, double friction) = nullptr;

    /// True if the parameter can differ from its neutral value only in simulations for which the
    /// user states its value. Models of studies do not fit it, since measured data can hardly
    /// separate it from the other parameters of the effect.
    bool only_simulated = false;

    /// Whether the effect can only be switched on or off: its parameter has the name "on".
    bool is_switch() const { return name == "on"; }
    /// Whether a model of a study can fit the parameter to measured data.
    bool is_fitted() const { return !is_switch() && !only_simulated; }
    /// Value of the parameter, in its unit, in models that do not fit the parameter: 1 (on) for a
    /// switch, else the neutral value, at which the effect vanishes.
    double value_if_not_fitted() const { return is_switch() ? 1 : neutral; }
};

/// Returns the parameter of an effect that can only be switched on or off: the parameter has the
/// name "on", is dimensionless, and has the value 0 (off, neutral) or 1 (on).
/// @param meaning explanation of the parameter in a few words, for the user
EffectParameter on_switch(std::string meaning);

/// A physical effect, identified by its name, with a value for each of its parameters.
struct EffectValues {
    std::string effect;  ///< name of the physical effect
    /// Value of each parameter of the effect, in the parameter's unit and in the order of
    /// `Effect::parameters`.
    std::vector<double> values;

    bool operator==(const EffectValues&) const = default;
};

/// Values of an effect's parameters, accessed by the names of the parameters. The two arrays that
/// the constructor receives have one element per parameter, in the same order. The arrays are not
/// copied and must outlive this object.
class Values {
  public:
    Values(std::span<const EffectParameter> parameters, std::span<const double> values)
        : parameters_(parameters), values_(values) {}

    /// Value of the effect's parameter with a given name, in the parameter's unit.
    /// @throws std::logic_error if the effect has no parameter with this name, which is a
    ///         programming error
    double operator[](std::string_view name) const;

  private:
    std::span<const EffectParameter> parameters_;
    std::span<const double> values_;
};

}  // namespace pendular
