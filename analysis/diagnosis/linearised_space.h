#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Set of models (a bare model and the models with candidate effects added) for fast diagnoses. The
/// predictions f are linear in the parameters theta of the bare model and in the amplitudes A_k of
/// the candidate effects k:
///     f = f_0 + J (theta - theta_0) + sum over the added effects k of c_k A_k.
/// An amplitude is 0 without the effect and 1 at the smallest size of interest.
/// - theta_0: estimates of theta in one refitted model of a diagnosis, the reference model
/// - f_0: predictions without effects at theta_0
/// - J: derivatives of the reference model's predictions with respect to theta, at its estimates
/// - c_k: change of the predictions by effect k per unit of its amplitude, a secant
///
/// The candidate effects and their bounds are those of the diagnosis. The linear predictions are
/// exact at the estimates of the reference model, and at the estimates of each model that the
/// diagnosis refitted with one effect. Elsewhere they are an approximation.
class LinearisedSpace : public ModelSpace {
  public:
    /// Linearises the models of `space` about `about`, one of the models that `diagnosis` refitted.
    LinearisedSpace(const ModelSpace& space, const Diagnosis& diagnosis, const Explanation& about);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, double value) const override;

  private:
    class Linear;

    /// Adds the candidate effect with index `k` of `space` to the candidates, and returns the
    /// amplitude of the effect in `refit`, or 1 if `refit` is null.
    /// @param refit refitted model with the effect; the change of the readings by the effect is
    ///        computed at the estimate of `refit` or, if null, at the smallest size of interest
    double add(const ModelSpace& space, std::size_t k, const Explanation* refit);
    /// Returns the prediction whose covariances of errors are used for the model with the effect
    /// set `chosen`: the prediction of the diagnosis' refit of that model or, if there is no such
    /// refit, the prediction of the bare model.
    const Prediction& errors_of(const EffectSet& chosen) const;

    std::vector<Parameter> parameters_;  ///< parameters of the bare model
    ParameterBounds bounds_;
    /// Parameters theta_0 of the bare model at the point of linearisation, and predictions f_0 of
    /// the bare model at theta_0.
    Eigen::VectorXd at_, value_;
    /// Derivatives J of the bare model's predictions with respect to its parameters: a row for each
    /// predicted value, a column for each parameter.
    Eigen::MatrixXd slopes_;
    std::vector<Candidate> candidates_;
    /// Change of the predictions by each candidate effect, divided by the amplitude of the effect
    /// (1 at the smallest size of interest): a column for each parameter of the effect.
    std::vector<Eigen::MatrixXd> changes_;
    std::vector<ChangeErrors> change_errors_;
    /// Effect sets of the refitted models that contain no error of measurement, the bare model
    /// first, each with the prediction of the model and the covariances of its errors.
    std::vector<std::pair<EffectSet, Prediction>> refitted_;
};

}  // namespace pendular
