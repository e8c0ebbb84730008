#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Set of models for fast diagnoses: a bare model (a study's model) and the models with candidate
/// effects added. The predictions f are linear in the parameters theta of the bare model and in the
/// amplitudes A_k of the candidate effects k:
///     f = f_0 + J (theta - theta_0) + sum over the added effects k of c_k A_k.
/// An amplitude is 0 without the effect and 1 at the smallest size of interest.
/// - theta_0: estimates of theta in the reference model, one of the fitted models of a diagnosis
/// - f_0: predictions without candidate effects at theta_0
/// - J: derivatives of the predictions of the reference model with respect to theta, at the
///   estimates of the reference model
/// - c_k: change of the predictions by effect k, divided by the amplitude at which the change was
///   computed
///
/// The candidate effects and their bounds are those of the diagnosis. The linear predictions are
/// exact at the estimates of the reference model, and at the estimates of each model that the
/// diagnosis refitted with one effect. Elsewhere the linear predictions are approximate.
class LinearisedSpace : public ModelSpace {
  public:
    /// Linearises the predictions of the models of `space` about the estimates of the reference
    /// model `about`, one of the fitted models of `diagnosis`.
    LinearisedSpace(const ModelSpace& space, const Diagnosis& diagnosis, const Explanation& about);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, double value) const override;

  private:
    class Linear;

    /// Adds the candidate effect with index `k` of `space` to the candidates of this object, and
    /// returns the amplitude of the effect [1] in `refit`, or 1 if `refit` is null.
    /// @param refit refitted model with the effect; the change of the readings by the effect is
    ///        computed at the estimate of `refit` or, if null, at the smallest size of interest
    double add(const ModelSpace& space, std::size_t k, const Explanation* refit);
    /// Returns the prediction whose covariance of errors is used for the model with the effects
    /// `chosen`: the prediction of this model in the diagnosis or, if the diagnosis did not refit
    /// the model, the prediction of the bare model.
    const Prediction& errors_of(const EffectSet& chosen) const;

    std::vector<Parameter> parameters_;  ///< parameters of the bare model
    ParameterBounds bounds_;
    /// Parameters theta_0 of the bare model about which the predictions are linearised (`at_`), and
    /// predictions f_0 of the bare model at theta_0 (`value_`).
    Eigen::VectorXd at_, value_;
    /// Derivatives J of the reference model's predictions with respect to the parameters of the
    /// bare model: a row for each predicted value, a column for each parameter.
    Eigen::MatrixXd slopes_;
    std::vector<Candidate> candidates_;
    /// Change of the predictions by each candidate effect, divided by the amplitude of the effect
    /// (1 at the smallest size of interest): a column for each parameter of the effect.
    std::vector<Eigen::MatrixXd> changes_;
    std::vector<ChangeErrors> change_errors_;
    /// Effects and predictions of the bare model (first) and of each refitted model without an
    /// error of measurement. Each prediction includes the covariance of its errors.
    std::vector<std::pair<EffectSet, Prediction>> refitted_;
};

}  // namespace pendular
