#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Model space (a bare model and its candidates, possible additions) whose predictions f are linear
/// in all parameters theta and amplitudes A_k of candidates k:
///     f = f_0 + J (theta - theta_0) + sum over the chosen candidates k of c_k A_k.
/// The models are tangent to those of a diagnosis at one of its refitted models, which has the
/// parameters theta_0. f_0 is the prediction of the bare model at theta_0, J its derivatives, and
/// c_k the change of the predictions by candidate k at amplitude 1. The candidates are those of the
/// original space with its bounds; their values are amplitudes, 0 without the effect and 1 at the
/// smallest size of interest. A prediction takes microseconds. At the estimates of the refitted
/// model, and of the refits with one effect, the predictions equal those of the refitted models.
class LinearisedSpace : public ModelSpace {
  public:
    /// Linearises the models of `space` about the refitted model `about`, one of the refitted
    /// models of `diagnosis`.
    LinearisedSpace(const ModelSpace& space, const Diagnosis& diagnosis, const Explanation& about);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, double value) const override;

  private:
    class Linear;

    /// Adds the candidate (possible addition) with index `k` of `space`, and returns its amplitude
    /// in `refit`.
    /// @param refit refitted model with the candidate, at whose estimate the change of the readings
    ///        is computed; null: at the smallest size of interest
    double add(const ModelSpace& space, std::size_t k, const Explanation* refit);
    /// Returns a prediction that contains the covariances of the model with the effect set `chosen`
    /// if the diagnosis has refitted this model, else those of the bare model.
    const Prediction& errors_of(const EffectSet& chosen) const;

    std::vector<Parameter> parameters_;  ///< parameters of the bare model
    ParameterBounds bounds_;
    /// Parameters theta_0 and predictions f_0 of the bare model at the point of linearisation.
    Eigen::VectorXd at_, value_;
    /// Derivatives J of the bare model's predictions with respect to its parameters: a row for each
    /// predicted value, a column for each parameter.
    Eigen::MatrixXd slopes_;
    std::vector<Candidate> candidates_;
    /// For each candidate (possible addition), the change of the predictions at its smallest size
    /// of interest (amplitude 1): a column for each parameter of the candidate.
    std::vector<Eigen::MatrixXd> changes_;
    std::vector<ChangeErrors> change_errors_;
    /// Refitted models that contain no error of measurement, the bare model first: effect set and
    /// prediction, with its covariances, of each model.
    std::vector<std::pair<EffectSet, Prediction>> refitted_;
};

}  // namespace pendular
