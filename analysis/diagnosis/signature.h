#pragma once

#include <Eigen/Core>
#include <functional>

#include "analysis/misfit/weighted_residuals.h"
#include "calib/model/model_space.h"

namespace pendular {

/// Change of a model's predictions by one candidate effect (not in the model), divided by the
/// amplitude of the effect. The amplitude is the difference between the effect's parameter and the
/// neutral value (no effect), divided by the smallest difference of interest. If the effect
/// declares a function of the parameter, such as the square of an angle, the function replaces the
/// parameter in both differences. The amplitude of a switch is 1 if the switch is on and 0 if it is
/// off.
struct Signature {
    /// Change of the predicted readings divided by the amplitude of the effect, in the units of the
    /// readings: a row for each measured value, and a column for each parameter of the effect (one
    /// column for a switch).
    Eigen::MatrixXd change;
    /// Covariances of the errors of `change` that come from the emulator (which interpolates
    /// simulations), in products of the units of the readings. Empty if `Addition::signature` did
    /// not compute the covariances.
    ModelSpace::ChangeErrors errors;
    /// Whether the amplitude cannot be negative: the effect is a switch (on or off), the neutral
    /// value is a bound of the parameter, or values above and below the neutral value change the
    /// readings in the same way.
    bool one_sided = false;
    /// Amplitude of the effect [1] at which `change` was computed.
    double taken_at = 1;
};

/// Predictions of a model to which one physical effect is added, as a function of the amplitude of
/// the added effect.
class Addition {
  public:
    /// Adds the effect `added` to the model with the effects `chosen`, both as indices into
    /// ModelSpace::candidates().
    /// @param parameters parameter values of the model with the effects `chosen`
    /// @param values predictions of the model with the effects `chosen` at `parameters`
    Addition(const ModelSpace& space, EffectSet chosen, std::size_t added,
             Eigen::VectorXd parameters, Eigen::VectorXd values);

    /// Returns the change of the predicted readings, per unit of amplitude, when the parameter of
    /// the added effect moves from the neutral value (no effect) by the smallest amount of
    /// interest, or when a switch is turned on.
    /// @param with_errors whether to compute the covariances of the errors of the change
    Signature signature(bool with_errors) const;
    /// Computes the change of the readings in `signature` again, at the amplitude `amplitude` [1]
    /// of the added effect (within the bounds of the effect's parameter), so that the change is
    /// more accurate near this amplitude. `signature` stays unchanged if the amplitude is zero, or
    /// if the model with the effect cannot give the conditions that the instrument shows.
    void retake(Signature& signature, double amplitude) const;

    /// Returns the value of the added effect's parameter [its unit] at an amplitude [1], limited to
    /// the bounds of the parameter.
    /// @param one_sided whether the amplitude cannot be negative (`Signature::one_sided`)
    double value_at(double amplitude, bool one_sided) const;
    /// Returns the amplitude of the added effect [1] at a value of the effect's parameter [its
    /// unit].
    /// @param one_sided whether the amplitude cannot be negative (`Signature::one_sided`)
    double amplitude_at(double value, bool one_sided) const;

    const Candidate& candidate() const { return space_.candidates()[added_]; }

  private:
    /// Returns the change of the predictions [units of the readings] when the effect is added to
    /// the model with the values `values` of the effect's parameters. Not a number if the model
    /// with the effect cannot give the conditions that the instrument shows.
    Eigen::VectorXd change_at(const Eigen::VectorXd& values) const;
    /// Returns the neutral value (no effect) of each parameter of the added effect that is not a
    /// switch (on or off), in the unit of the parameter.
    Eigen::VectorXd neutral() const;
    /// Whether the added effect changes the predictions in opposite directions above and below the
    /// neutral value (no effect). The smallest change of interest of the effect's parameter to one
    /// side changes the predictions by `change`. An equal change to the other side must be within
    /// the parameter's bounds and must change the predictions roughly by the negative of `change`.
    bool mirrored(const Eigen::VectorXd& change) const;
    /// Returns the direction, 1 (up) or -1 (down), in which the parameter `p` can move from the
    /// neutral value (no effect) by the smallest amount of interest without leaving its bounds. Up
    /// has precedence.
    double direction(const EffectParameter& p) const;

    const ModelSpace& space_;
    EffectSet chosen_;
    std::size_t added_;
    Eigen::VectorXd parameters_, values_;
};

}  // namespace pendular
