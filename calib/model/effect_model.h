#pragma once

#include <memory>
#include <vector>

#include "calib/model/model_space.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Predictor with effects: its parameters are those of the model inside, then those of the effects,
/// "EFFECT.PARAMETER". Switches are on.
///
/// A reading's condition is what the instrument shows. The instrument map is inverted there to find
/// the condition that is truly imposed, effects on grains, liquid and grains change it, the model
/// inside predicts, and the map turns the prediction into the values shown. Where no effect touches
/// a reading it is predicted bit for bit as by the model inside. Derivatives by effects are central
/// differences over a thousandth of the smallest effect of interest: those of smooth functions, not
/// of noise.
class EffectModel : public Predictor {
  public:
    /// The effects must outlive it. The closure effects among them are the caller's.
    EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                std::vector<const Effect*> effects);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;

    /// Errors of the change from a model on the same inner model, with fewer effects, to this one.
    /// An effect on grains is known from runs of its own, whose errors are independent of those of
    /// the model without it. The change by other effects follows from predictions at neighbouring
    /// conditions, whose errors are nearly equal.
    ModelSpace::ChangeErrors change_errors(const Eigen::VectorXd& parameters,
                                           const EffectModel& without,
                                           const Eigen::VectorXd& parameters_without,
                                           const std::vector<Condition>& conditions) const;

    /// Effects with their values at these parameters.
    std::vector<ActiveEffect> effects_at(const Eigen::VectorXd& parameters) const;

    /// True conditions behind those that the instrument shows: the conditions requested from the
    /// inner model.
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;

  private:
    struct Truths;
    /// True states of the cell for readings at these conditions and parameters.
    Truths truths_at(const Eigen::VectorXd& parameters,
                     const std::vector<Condition>& conditions) const;
    Eigen::VectorXd inside_parameters(const Eigen::VectorXd& parameters) const {
        return parameters.head(static_cast<Eigen::Index>(inside_->parameters().size()));
    }
    /// Values that the instrument shows for the true ones.
    Eigen::VectorXd shown(const Truths& truths, const Eigen::VectorXd& predicted) const;
    Eigen::MatrixXd shown_by_predicted(const Truths& truths,
                                       const Eigen::VectorXd& predicted) const;
    void add_slopes(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                    const Truths& truths, const Eigen::VectorXd& predicted,
                    Prediction& result) const;

    std::shared_ptr<const FlowPredictor> inside_;
    Study study_;
    std::vector<const Effect*> effects_;
    std::vector<Parameter> parameters_;
};

/// Whether an effect needs a joint fit of all readings: it touches dry readings, or has an
/// amplitude that only wet readings determine.
bool needs_joint_fit(const std::vector<const Effect*>& effects);

}  // namespace pendular
