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
/// added to an inner model without effects. Its parameters are those of the inner model, then those
/// of the effects, named "EFFECT.PARAMETER". An effect that is a switch (on or off) is on in this
/// model and has no parameter.
///
/// A prediction starts from the condition that the instrument shows and takes four steps. (1) The
/// inverse of the instrument's map gives the condition truly imposed. (2) Effects on grains and
/// liquid change this condition. (3) The inner model predicts the true shear stress and solid
/// fraction, which effects on the flow may change. (4) The instrument's map turns these into the
/// values that the instrument shows. If no effect acts on a reading, the prediction is that of the
/// inner model.
///
/// Derivatives with respect to an effect's parameter are central differences with a step of a
/// thousandth of the parameter's smallest effect of interest; predictions are smooth in the
/// parameters, so that the differences contain no noise. The covariance of a prediction includes
/// the discrepancy (expected error of the model) that the study states. Predictions throw
/// std::domain_error if no true state of the cell gives a condition that the instrument shows.
class EffectModel : public Predictor {
  public:
    /// Adds the effects `effects`, which must outlive this model, to the inner model `inside`.
    /// Effects that replace an approximation of the formula for wet grains (ChangeClosure) change
    /// nothing here: the caller passes an inner model whose formula contains them.
    EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                std::vector<const Effect*> effects);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;

    /// Returns the covariances of the simulation errors of a change of predictions: from the model
    /// `without`, which has the same inner model and fewer effects, to this model. The predictions
    /// are shear stress [Pa] and solid fraction [1] at each of `conditions` in turn; the
    /// covariances have their squared units. The errors of both predictions are computed together,
    /// since they nearly cancel if an effect changes a condition little.
    /// @param parameters parameters of this model
    /// @param parameters_without parameters of the model `without`
    ModelSpace::ChangeErrors change_errors(const Eigen::VectorXd& parameters,
                                           const EffectModel& without,
                                           const Eigen::VectorXd& parameters_without,
                                           const std::vector<Condition>& conditions) const;

    /// Returns the effects of the model, each with the values of its parameters in SI units. A
    /// switch (effect without a parameter) has the value 1.
    /// @param parameters values of all parameters, in the order of parameters()
    std::vector<ActiveEffect> effects_at(const Eigen::VectorXd& parameters) const;

    /// Returns, for each condition that the instrument shows, the condition truly imposed on the
    /// grains, with grains and liquid as the effects change them. The inner model (without effects)
    /// predicts at the returned conditions.
    /// @param parameters values of all parameters, in the order of parameters()
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;

  private:
    struct Truths;
    /// Returns the truly imposed condition, the true state of the cell and the instrument's map for
    /// each of the `conditions` that the instrument shows.
    Truths truths_at(const Eigen::VectorXd& parameters,
                     const std::vector<Condition>& conditions) const;
    /// Returns the values of the inner model's parameters, which come first in `parameters`.
    Eigen::VectorXd inside_parameters(const Eigen::VectorXd& parameters) const {
        return parameters.head(static_cast<Eigen::Index>(inside_->parameters().size()));
    }
    /// Returns the shear stress [Pa] and solid fraction [1] that the instrument shows for each
    /// reading in turn.
    /// @param predicted true shear stresses [Pa] and solid fractions [1] that the inner model
    ///        predicts, for each reading in turn
    Eigen::VectorXd shown(const Truths& truths, const Eigen::VectorXd& predicted) const;
    /// Derivatives of the values that the instrument shows (function `shown`) with respect to the
    /// true shear stresses [Pa] and solid fractions [1] `predicted`: a row for each shown value and
    /// a column for each true value.
    Eigen::SparseMatrix<double> shown_by_predicted(const Truths& truths,
                                                   const Eigen::VectorXd& predicted) const;
    /// Whether an effect of the model acts on grains.
    bool changes_grains() const;
    /// Sets the derivatives of the prediction `result` with respect to the effects' parameters and,
    /// if an effect acts on grains, also with respect to the inner model's parameters. All
    /// derivatives are difference quotients.
    /// @param predicted true values that the inner model predicts at `parameters`
    void add_slopes(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                    const Truths& truths, const Eigen::VectorXd& predicted,
                    Prediction& result) const;

    std::shared_ptr<const FlowPredictor> inside_;
    Study study_;
    std::vector<const Effect*> effects_;
    std::vector<Parameter> parameters_;
};

/// Whether a model with the effects `effects` must be fitted to dry and wet readings together. It
/// must if one of the effects also changes readings that are not wet, or has a parameter to fit,
/// since dry readings alone do not determine this parameter.
bool needs_joint_fit(const std::vector<const Effect*>& effects);

}  // namespace pendular
