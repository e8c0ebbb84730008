#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "calib/model/model.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Predictor of shear stress [Pa] and solid fraction [1] with effects, such as wall slip, added to
/// an inner model without effects. The parameters of the inner model come first, then the
/// parameters of the effects, named "EFFECT.PARAMETER"; switches have none.
///
/// A prediction starts from the condition that the instrument shows and takes four steps:
/// 1. The inverse of the instrument's map (`InstrumentMap`, from true to shown states of the cell)
///    yields the condition truly imposed.
/// 2. Effects on grains and liquid change the imposed condition.
/// 3. The inner model predicts the true shear stress and solid fraction, which effects on the flow
///    may change.
/// 4. The instrument's map converts the true values to the values that the instrument shows.
///
/// The covariance of a prediction includes the discrepancy that the study states and the shared
/// uncertainties that count. Predictions throw
/// std::domain_error if no true state of the cell gives a condition that the instrument shows.
class EffectModel : public Predictor {
  public:
    /// Adds `effects`, which must outlive the model, to the inner model `inside`. An effect that
    /// replaces an approximation of the formula for wet grains (ChangeClosure) must already be part
    /// of `inside`: EffectModel does not apply such effects.
    EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                std::vector<const Effect*> effects);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;
    bool has_instrument() const override;
    const std::vector<SharedUncertainty>& uncertainties() const override { return uncertainties_; }
    Eigen::MatrixXd shared_changes(const Eigen::VectorXd& parameters,
                                   const std::vector<Condition>& conditions) const override;

    /// Returns the covariances that simulation errors cause in a change of predictions, present
    /// model minus `without`, at each of `conditions`. The model `without` has the same inner model
    /// and fewer effects.
    ModelSpace::ChangeErrors change_errors(const Eigen::VectorXd& parameters,
                                           const EffectModel& without,
                                           const Eigen::VectorXd& parameters_without,
                                           const std::vector<Condition>& conditions) const;

    /// Returns the effects with their parameter values in SI units; a switch has the value 1.
    std::vector<ActiveEffect> effects_at(const Eigen::VectorXd& parameters) const;

    std::vector<EffectiveCondition> imposed(
        const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions) const override;

  private:
    struct Truths;
    /// @param near truths from which to search, at nearby parameters or effects; null: none
    Truths truths_at(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                     const Truths* near = nullptr) const;
    Truths truths_with(std::vector<ActiveEffect> effects, const std::vector<Condition>& conditions,
                       const Truths* near = nullptr) const;
    /// Returns the study's cell, or one of typical size where only ratios of stresses matter,
    /// because the study has none.
    AnnularCell cell() const;
    /// Predictions near `truths`, at conditions that differ a little from these.
    class Nearby;
    /// Returns the columns of `shared_changes` for the uncertainties that count and, if `all`, also
    /// for the others, which otherwise are 0.
    /// @param here shown values without errors
    Eigen::MatrixXd changes_by(bool all, const std::vector<Condition>& conditions,
                               const Truths& truths, const Nearby& nearby,
                               const Eigen::VectorXd& here) const;
    Eigen::VectorXd inside_parameters(const Eigen::VectorXd& parameters) const {
        return parameters.head(static_cast<Eigen::Index>(inside_->parameters().size()));
    }
    /// Returns the shown values if the inner model predicts the true values `predicted`: effects on
    /// the flow apply first, then the instrument's map.
    Eigen::VectorXd shown(const Truths& truths, const Eigen::VectorXd& predicted) const;
    /// Returns the derivatives of `shown` (rows) with respect to `predicted` (columns).
    Eigen::SparseMatrix<double> shown_by_predicted(const Truths& truths,
                                                   const Eigen::VectorXd& predicted) const;
    /// Whether an effect acts inside a simulation, such as rolling resistance.
    bool changes_grains() const;
    /// Sets the columns of `result.jacobian` for the parameters of the effects and, if
    /// changes_grains(), also those of the inner model, by difference quotients.
    void add_slopes(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                    const Truths& truths, const Nearby& nearby, Prediction& result) const;

    std::shared_ptr<const FlowPredictor> inside_;
    Study study_;
    std::vector<const Effect*> effects_;
    std::vector<Parameter> parameters_;
    std::vector<SharedUncertainty> uncertainties_;
};

/// Whether a model with `effects` must be fitted to dry and wet readings together: if an effect may
/// change dry readings, or has a parameter to fit, which dry readings alone may not determine.
bool needs_joint_fit(const std::vector<const Effect*>& effects);

}  // namespace pendular
