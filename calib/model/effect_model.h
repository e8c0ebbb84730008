#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "calib/model/model_space.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Predictor of shear stress [Pa] and solid fraction [1] with physical effects, such as wall slip,
/// added to an inner model without effects. The parameters of the inner model come first, then the
/// parameters of the effects, with names "EFFECT.PARAMETER". An effect that is a switch (on or off)
/// is on in the model and has no parameter.
///
/// A prediction starts from the condition that the instrument shows and takes four steps:
/// 1. The inverse of the instrument's map (`InstrumentMap`, from true to shown states of the cell)
///    yields the condition truly imposed.
/// 2. Effects on grains and liquid change the imposed condition.
/// 3. The inner model predicts the true shear stress and solid fraction, which effects on the flow
///    may change.
/// 4. The instrument's map converts the true values to the values that the instrument shows.
///
/// The covariance of a prediction includes the discrepancy (expected error of the model) that the
/// study states. Predictions throw std::domain_error if no true state of the cell gives a condition
/// that the instrument shows.
class EffectModel : public Predictor {
  public:
    /// Adds the effects `effects`, which must outlive the model, to the inner model `inside`. An
    /// effect that replaces an approximation of the formula for wet grains (ChangeClosure) must
    /// already be part of the formula of `inside`, since EffectModel does not apply such effects.
    EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                std::vector<const Effect*> effects);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;
    bool has_instrument() const override;

    /// Returns the covariances that simulation errors cause in a change of predictions: prediction
    /// of the present model minus prediction of the model `without`. The model `without` has the
    /// present inner model and fewer effects. The predictions are shear stress [Pa] and solid
    /// fraction [1] at each of `conditions` in turn. The covariances are in products of the units
    /// of the predictions.
    /// @param parameters parameter values of the present model
    /// @param parameters_without parameter values of the model `without`
    ModelSpace::ChangeErrors change_errors(const Eigen::VectorXd& parameters,
                                           const EffectModel& without,
                                           const Eigen::VectorXd& parameters_without,
                                           const std::vector<Condition>& conditions) const;

    /// Returns the effects of the model, each with the values of the effect's parameters in SI
    /// units. A switch (an effect that is on or off) has the value 1.
    /// @param parameters values of all parameters, in the order of parameters()
    std::vector<ActiveEffect> effects_at(const Eigen::VectorXd& parameters) const;

    /// Returns the condition truly imposed on the grains for each of the `conditions` that the
    /// instrument shows. The returned conditions contain the changes that effects make to grains
    /// and liquid. The inner model (the model without effects) predicts at the returned conditions.
    /// @param parameters values of all parameters, in the order of parameters()
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;

  private:
    struct Truths;
    /// Returns, for each of the `conditions` that the instrument shows, the condition truly imposed
    /// on the grains, the true state of the cell, and the instrument's map from true to shown
    /// states.
    Truths truths_at(const Eigen::VectorXd& parameters,
                     const std::vector<Condition>& conditions) const;
    /// Returns the values of the parameters of the inner model (the model without effects), which
    /// come first in `parameters`.
    Eigen::VectorXd inside_parameters(const Eigen::VectorXd& parameters) const {
        return parameters.head(static_cast<Eigen::Index>(inside_->parameters().size()));
    }
    /// Returns the shear stress [Pa] and solid fraction [1] that the instrument shows if the true
    /// values are `predicted`, for each condition in turn. Effects on the flow change the true
    /// values before the instrument's map is applied.
    /// @param predicted true shear stress [Pa] and solid fraction [1] that the inner model (without
    ///        effects) predicts, for each condition in turn
    Eigen::VectorXd shown(const Truths& truths, const Eigen::VectorXd& predicted) const;
    /// Returns the derivatives of the values that the instrument shows (function `shown`) with
    /// respect to the values `predicted`: true shear stress [Pa] and solid fraction [1] for each
    /// condition in turn. The matrix has a row for each shown value and a column for each true
    /// value.
    Eigen::SparseMatrix<double> shown_by_predicted(const Truths& truths,
                                                   const Eigen::VectorXd& predicted) const;
    /// Whether the model has an effect that acts on the grains inside a simulation, such as rolling
    /// resistance.
    bool changes_grains() const;
    /// Sets the columns of `result.jacobian` for the parameters of the effects. If an effect acts
    /// on grains inside a simulation (`changes_grains`), the function also sets the columns for the
    /// parameters of the inner model. All derivatives are difference quotients.
    /// @param predicted true shear stress [Pa] and solid fraction [1] that the inner model (without
    ///        effects) predicts at `parameters`, for each condition in turn
    void add_slopes(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                    const Truths& truths, const Eigen::VectorXd& predicted,
                    Prediction& result) const;

    std::shared_ptr<const FlowPredictor> inside_;
    Study study_;
    std::vector<const Effect*> effects_;
    std::vector<Parameter> parameters_;
};

/// Whether a model with the effects `effects` must be fitted to dry and wet readings together. A
/// joint fit is needed if one of the effects may change dry readings, or if an effect has a
/// parameter to fit, since dry readings alone may not determine the parameter.
bool needs_joint_fit(const std::vector<const Effect*>& effects);

}  // namespace pendular
