#pragma once

#include <Eigen/Core>
#include <functional>

#include "analysis/misfit/weighted_residuals.h"
#include "calib/model/model.h"

namespace pendular {

/// Change of a model's predictions by one candidate effect, per unit of its amplitude: the
/// difference between the effect's parameter and its neutral value, over the smallest difference of
/// interest. If the effect declares a function of the parameter, such as the square of an angle,
/// the function replaces the parameter. A switch has the amplitude 1 if it is on.
struct Signature {
    /// In the units of the readings: a row for each measured value, a column for each parameter of
    /// the effect (one for a switch).
    Eigen::MatrixXd change;
    ModelSpace::ChangeErrors errors;  ///< emulator's errors of `change`; may be empty
    /// Whether the amplitude cannot be negative: of a switch, if the neutral value is a bound of
    /// the parameter, or if values above and below it change the readings alike.
    bool one_sided = false;
    double taken_at = 1;  ///< amplitude at which `change` was computed [1]
};

/// Predictions of a model with one effect added, as a function of its amplitude.
class Addition {
  public:
    /// Adds the effect `added` to the model with the effects `chosen`, both as indices into
    /// ModelSpace::candidates().
    /// @param parameters, values parameters of the model with `chosen`, and its predictions there
    Addition(const ModelSpace& space, EffectSet chosen, std::size_t added,
             Eigen::VectorXd parameters, Eigen::VectorXd values);

    /// Returns the signature at the smallest amount of interest, or with a switch on.
    Signature signature(bool with_errors) const;
    /// Computes `signature.change` again at an amplitude [1], within the bounds of the parameter,
    /// near which it is then more accurate. No change if the amplitude is zero, or if the model
    /// cannot give the conditions that the instrument shows.
    void retake(Signature& signature, double amplitude) const;

    /// Returns the effect's parameter [its unit] at an amplitude [1], limited to its bounds.
    /// @param one_sided `Signature::one_sided`, also below
    double value_at(double amplitude, bool one_sided) const;
    /// Returns the amplitude [1] at a value of the effect's parameter [its unit].
    double amplitude_at(double value, bool one_sided) const;

    const Candidate& candidate() const { return space_.candidates()[added_]; }

  private:
    /// Not a number if the model with the effect cannot give the conditions that the instrument
    /// shows.
    Eigen::VectorXd change_at(const Eigen::VectorXd& values) const;
    Eigen::VectorXd neutral() const;
    /// Whether the effect changes the predictions in opposite directions on both sides of the
    /// neutral value. `change`: by the smallest amount of interest to one side.
    bool mirrored(const Eigen::VectorXd& change) const;
    /// Returns 1 (up) or -1 (down): where the smallest amount of interest is within the bounds.
    double direction(const EffectParameter& p) const;

    const ModelSpace& space_;
    EffectSet chosen_;
    std::size_t added_;
    Eigen::VectorXd parameters_, values_;
};

}  // namespace pendular
