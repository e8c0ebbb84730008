#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "calib/model/model_space.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Predictor that adds physical effects to an inner model. Its parameters are those of the inner
/// model, then those of the effects, named "EFFECT.PARAMETER". Effects that are switches are on and
/// have no parameter.
///
/// The condition of a reading is the one that the instrument shows. A prediction takes four steps:
/// the inverted instrument map gives the condition that is truly imposed; effects on grains and
/// liquid change this condition; the inner model predicts the true shear stress and solid fraction,
/// which effects on the flow may change; the instrument map turns them into the values that the
/// instrument shows. A reading that no effect touches is predicted exactly as by the inner model.
/// Derivatives by an effect's parameter are central differences with a step of a thousandth of the
/// smallest change of the parameter that matters. Predictions are smooth functions of the
/// parameters, so that the differences contain no noise. The covariance of a prediction includes
/// the discrepancy that the study states for its model.
class EffectModel : public Predictor {
  public:
    /// Adds `effects` to the model `inside`. The effects must outlive this model. Effects that
    /// switch on terms of the closure (formula of the base model `rumpf`) change nothing here: the
    /// caller passes a model `inside` whose closure has these terms already.
    EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                std::vector<const Effect*> effects);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;

    /// Covariances of the simulation errors of the change of the readings predicted at `conditions`
    /// from the model `without`, which has the same inner model and fewer effects, to this model.
    /// They follow from the joint errors of the inner model's predictions at both sets of
    /// conditions, which are nearly equal where an effect moves a condition little.
    ModelSpace::ChangeErrors change_errors(const Eigen::VectorXd& parameters,
                                           const EffectModel& without,
                                           const Eigen::VectorXd& parameters_without,
                                           const std::vector<Condition>& conditions) const;

    /// Effects of the model, each with the values of its parameters taken from `parameters`, which
    /// has the order of parameters(); the value of a switch is 1.
    std::vector<ActiveEffect> effects_at(const Eigen::VectorXd& parameters) const;

    /// Returns for each condition that the instrument shows the condition that is truly imposed on
    /// the grains, as effects on grains and liquid change it: the inner model predicts there.
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;

  private:
    struct Truths;
    /// Truly imposed conditions, with the states of the cell and instrument maps, for readings at
    /// shown `conditions`.
    Truths truths_at(const Eigen::VectorXd& parameters,
                     const std::vector<Condition>& conditions) const;
    /// Values of the inner model's parameters, which come first in `parameters`.
    Eigen::VectorXd inside_parameters(const Eigen::VectorXd& parameters) const {
        return parameters.head(static_cast<Eigen::Index>(inside_->parameters().size()));
    }
    /// Shear stress [Pa] and solid fraction [1] that the instrument shows for each reading where
    /// the inner model predicts the true values `predicted`, stacked as in `Prediction`.
    Eigen::VectorXd shown(const Truths& truths, const Eigen::VectorXd& predicted) const;
    /// Derivatives of the values that `shown` returns by the entries of `predicted`, the true shear
    /// stresses [Pa] and solid fractions [1].
    Eigen::SparseMatrix<double> shown_by_predicted(const Truths& truths,
                                                   const Eigen::VectorXd& predicted) const;
    /// Sets the columns of `result.jacobian` that belong to the effects' parameters and, where any
    /// effect acts on grains, also those of the inner model's parameters, by difference quotients.
    /// @param predicted true values that the inner model predicts at `parameters`
    void add_slopes(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                    const Truths& truths, const Eigen::VectorXd& predicted,
                    Prediction& result) const;

    std::shared_ptr<const FlowPredictor> inside_;
    Study study_;
    std::vector<const Effect*> effects_;
    std::vector<Parameter> parameters_;
};

/// Whether any of the effects needs a joint fit of dry and wet readings: because it changes dry
/// readings, or has a parameter to fit, which dry readings alone do not determine.
bool needs_joint_fit(const std::vector<const Effect*>& effects);

}  // namespace pendular
