#pragma once

#include <Eigen/Core>
#include <functional>

#include "analysis/misfit/weighted_residuals.h"
#include "calib/model/model_space.h"

namespace pendular {

/// Change of a model's predictions by a candidate: a column for each of its parameters, per
/// amplitude. An amplitude is 1 where the parameter differs from neutral by the smallest effect of
/// interest (or the switch is on). In between, the amplitude is proportional to the parameter, or
/// to the function of it that the candidate declares, such as the square of a deviation.
struct Signature {
    Eigen::MatrixXd change;  ///< change in the units of the readings
    /// Covariance that comes from model error, if it is included, in the units of the readings.
    ModelSpace::ChangeErrors errors;
    /// The amplitude cannot be negative: at neutral the parameter is at its bound, or the other
    /// direction does much the same.
    bool one_sided = false;
    double taken_at = 1;  ///< amplitude at which the change was seen
};

/// Predictions of a model with one further candidate, as a function of the candidate's amplitude.
class Addition {
  public:
    /// Adds candidate `added` to the model of `chosen` at `parameters`, whose predictions are
    /// `values`.
    Addition(const ModelSpace& space, EffectSet chosen, std::size_t added,
             Eigen::VectorXd parameters, Eigen::VectorXd values);

    /// Signature of the candidate about neutral, at the smallest effect of interest.
    Signature signature(bool with_errors) const;
    /// Computes the signature at another amplitude, other than zero, within the bounds.
    void retake(Signature& signature, double amplitude) const;

    /// Value of the parameter at an amplitude, within its bounds.
    double value_at(double amplitude, bool one_sided) const;
    /// Amplitude at a value.
    double amplitude_at(double value, bool one_sided) const;

    const Candidate& candidate() const { return space_.candidates()[added_]; }

  private:
    Eigen::VectorXd change_at(const Eigen::VectorXd& values) const;
    Eigen::VectorXd neutral() const;
    bool mirrored(const Eigen::VectorXd& change) const;
    /// A direction in which there is room for the smallest effect of interest.
    double direction(const EffectParameter& p) const;

    const ModelSpace& space_;
    EffectSet chosen_;
    std::size_t added_;
    Eigen::VectorXd parameters_, values_;
};

}  // namespace pendular
