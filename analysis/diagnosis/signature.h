#pragma once

#include <Eigen/Core>
#include <functional>

#include "analysis/misfit/weighted_residuals.h"
#include "calib/model/model_space.h"

namespace pendular {

/// Change of a model's predictions by one candidate (effect not in the model), per unit of the
/// candidate's amplitude. The amplitude is 1 where the parameter differs from its neutral value (no
/// effect) by the smallest amount that matters, or where a switch is on. It is proportional to the
/// parameter's distance from neutral, or to the function of the parameter that the candidate
/// declares, such as the square of a deviation.
struct Signature {
    /// Change of the predicted readings divided by the amplitude, in the units of the readings,
    /// entries (values of the readings) x parameters of the candidate.
    Eigen::MatrixXd change;
    /// Covariances of `change` from errors of the emulator, in the units of the readings; empty
    /// unless they were requested.
    ModelSpace::ChangeErrors errors;
    /// Whether the amplitude cannot be negative: the neutral value is a bound of the parameter, or
    /// values above and below it change the readings in the same way.
    bool one_sided = false;
    double taken_at = 1;  ///< amplitude at which the change was computed [1]
};

/// Predictions of a model to which one candidate effect is added, as a function of the amplitude of
/// this effect.
class Addition {
  public:
    /// Adds candidate `added` to the model with the candidates `chosen`, which predicts `values` at
    /// `parameters`.
    Addition(const ModelSpace& space, EffectSet chosen, std::size_t added,
             Eigen::VectorXd parameters, Eigen::VectorXd values);

    /// Signature of the candidate effect: change of the predicted readings when its parameter goes
    /// from the neutral value (no effect) by the smallest amount that matters. `with_errors`:
    /// whether to compute the covariances of the change.
    Signature signature(bool with_errors) const;
    /// Computes the change of the readings in a signature again at another amplitude of the
    /// candidate, limited to the bounds of its parameter. The signature is unchanged where that
    /// amplitude is zero or impossible for the readings.
    void retake(Signature& signature, double amplitude) const;

    /// Value of the candidate's parameter [its unit] at an amplitude, limited to its bounds.
    /// `one_sided`: as in the candidate's `Signature`.
    double value_at(double amplitude, bool one_sided) const;
    /// Amplitude of the candidate effect [1] at a value of its parameter. `one_sided`: as in the
    /// candidate's `Signature`.
    double amplitude_at(double value, bool one_sided) const;

    const Candidate& candidate() const { return space_.candidates()[added_]; }

  private:
    /// Change of the predictions from the model without the candidate [units of the readings], at
    /// these values of the candidate's parameters; not a number where the readings are impossible
    /// with them.
    Eigen::VectorXd change_at(const Eigen::VectorXd& values) const;
    /// Neutral values (no effect) of the candidate's parameters, without switches.
    Eigen::VectorXd neutral() const;
    /// Whether moving the candidate's parameter in the other direction from its neutral value is
    /// within the bounds and changes the predictions by about the negative of `change`.
    bool mirrored(const Eigen::VectorXd& change) const;
    /// Direction from the neutral value of parameter `p`, 1 or -1, in which a change by the
    /// smallest amount that matters stays within its bounds.
    double direction(const EffectParameter& p) const;

    const ModelSpace& space_;
    EffectSet chosen_;
    std::size_t added_;
    Eigen::VectorXd parameters_, values_;
};

}  // namespace pendular
