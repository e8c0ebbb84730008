#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Model space that is linear in all parameters and amplitudes, tangent to the models of a
/// diagnosis at one of its refitted models: the bare model at the fitted parameters theta_0
/// predicts f_0, and candidate k changes the predictions by c_k at amplitude 1, so that
///     f = f_0 + J (theta - theta_0) + sum over the chosen candidates k of c_k A_k.
/// The candidates are those of the original space with its bounds; their values are amplitudes A, 0
/// where there is no effect and 1 at the smallest size that matters. A prediction takes
/// microseconds. At the estimates of the refitted model and of the refits with one effect, the
/// predictions are those of the refitted models.
class LinearisedSpace : public ModelSpace {
  public:
    /// Linearises the models of `space` about `about`, an explanation of `diagnosis`.
    LinearisedSpace(const ModelSpace& space, const Diagnosis& diagnosis, const Explanation& about);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, double value) const override;

  private:
    class Linear;

    /// Adds the candidate with index `k` of `space`, and returns its amplitude in `refit`. `refit`:
    /// refitted model with the candidate, at whose estimate the change of the readings is computed;
    /// null: at the smallest size that matters.
    double add(const ModelSpace& space, std::size_t k, const Explanation* refit);
    /// Covariances of the predictions of the model with an effect set, as far as `diagnosis` has
    /// refitted it, else of the bare model.
    const Prediction& errors_of(const EffectSet& chosen) const;

    std::vector<Parameter> parameters_;  ///< of the bare model
    ParameterBounds bounds_;
    Eigen::VectorXd at_, value_;  ///< theta_0 and f_0
    Eigen::MatrixXd slopes_;      ///< J
    std::vector<Candidate> candidates_;
    std::vector<Eigen::MatrixXd> changes_;  ///< c_k, a column for each parameter of the candidate
    std::vector<ChangeErrors> change_errors_;
    /// Refitted models without suspects, with covariances of their predictions; the first is bare.
    std::vector<std::pair<EffectSet, Prediction>> refitted_;
};

}  // namespace pendular
