#pragma once

#include <memory>
#include <vector>

#include "calib/model/model_space.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Predictor that adds effects to an inner model. Its parameters are those of the inner model, then
/// those of the effects, named "EFFECT.PARAMETER". Effects that are switches are on and have no
/// parameter.
///
/// The condition of a reading is the one that the instrument shows. A prediction takes four steps:
/// the inverted instrument map gives the condition that is truly imposed; effects on grains and
/// liquid change this condition; the inner model predicts the true flow; the instrument map turns
/// the prediction into the values shown. A reading that no effect touches is predicted exactly as
/// by the inner model. Derivatives by effects are central differences with a step of a thousandth
/// of the smallest effect of interest. Predictions are smooth functions of the parameters, so that
/// the differences contain no noise.
class EffectModel : public Predictor {
  public:
    /// Adds `effects` to the model `inside`. The effects must outlive this model. Closure effects
    /// only add their parameters: the caller passes a model whose closure they have changed
    /// already.
    EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                std::vector<const Effect*> effects);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;

    /// Errors of the change of the predictions from `without`, a model with the same inner model
    /// and fewer effects, to this model. The response to an effect on grains is trained on separate
    /// runs, whose errors are independent of those of the model without the effect. The change by
    /// any other effect follows from predictions at neighbouring conditions, whose errors are
    /// nearly equal.
    ModelSpace::ChangeErrors change_errors(const Eigen::VectorXd& parameters,
                                           const EffectModel& without,
                                           const Eigen::VectorXd& parameters_without,
                                           const std::vector<Condition>& conditions) const;

    /// Effects of the model with the values of their parameters at `parameters`.
    std::vector<ActiveEffect> effects_at(const Eigen::VectorXd& parameters) const;

    /// Returns the true condition behind each condition that the instrument shows, as effects
    /// change it: the conditions at which the inner model predicts.
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;

  private:
    struct Truths;
    /// True states of the cell for readings at shown conditions, at these parameters.
    Truths truths_at(const Eigen::VectorXd& parameters,
                     const std::vector<Condition>& conditions) const;
    /// Parameters of the inner model, the first of all parameters.
    Eigen::VectorXd inside_parameters(const Eigen::VectorXd& parameters) const {
        return parameters.head(static_cast<Eigen::Index>(inside_->parameters().size()));
    }
    /// Values that the instrument shows where the inner model predicts the true values `predicted`.
    Eigen::VectorXd shown(const Truths& truths, const Eigen::VectorXd& predicted) const;
    /// Derivatives of the shown values by the predicted true values.
    Eigen::MatrixXd shown_by_predicted(const Truths& truths,
                                       const Eigen::VectorXd& predicted) const;
    /// Sets the derivatives in the Jacobian of `result` by the effects' parameters and, where an
    /// effect acts on grains, by the inner model's parameters.
    void add_slopes(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                    const Truths& truths, const Eigen::VectorXd& predicted,
                    Prediction& result) const;

    std::shared_ptr<const FlowPredictor> inside_;
    Study study_;
    std::vector<const Effect*> effects_;
    std::vector<Parameter> parameters_;
};

/// Whether any effect needs a joint fit of dry and wet readings: because it touches dry readings,
/// or has a parameter to fit that only wet readings determine.
bool needs_joint_fit(const std::vector<const Effect*>& effects);

}  // namespace pendular
