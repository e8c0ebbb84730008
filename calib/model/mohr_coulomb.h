#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Lowest P* [1] of the readings to which a straight line of stress ratio against 1/P* is fitted.
/// Source: Badetti et al. (2018), who find that the line is too high at lower P*.
constexpr double lowest_cohesion_pressure = 2.3;

/// Measured strengths (stress ratios) of wet readings of nearly equal liquid content, to which one
/// constant cohesion is fitted.
struct CohesionGroup {
    double liquid_content = 0;                ///< mean of the readings [1]
    std::vector<MeasuredStrength> strengths;  ///< all at P* >= `lowest_cohesion_pressure`
};

/// Groups the strengths `model.strengths` by liquid content, in increasing order. Strengths at
/// reduced pressures below `lowest_cohesion_pressure` are left out. All liquid contents of a group
/// agree within 2 % with that of its first strength. Empty if the study has no liquid.
std::vector<CohesionGroup> cohesion_groups(const ModelSettings& model,
                                           const GrainProperties& grains,
                                           const std::optional<Liquid>& liquid);

/// Predictor of the base model "mohr-coulomb", with a straight line for the stress ratio of wet
/// grains,
///     mu* = mu*_dry(mu, I) + c*/P*
/// with the simulated stress ratio mu*_dry of dry grains of friction coefficient mu, and a constant
/// reduced cohesion c* for each liquid content. For every value of mu, c* follows by weighted least
/// squares from the study's measured strengths y_i at P*_i >= `lowest_cohesion_pressure`:
///     c* = sum w_i (y_i - mu*_dry(mu, I_i))/P*_i / sum w_i/P*_i^2,    w_i = 1/error(y_i)^2.
/// At a liquid content without a fitted c*, the c* of the nearest liquid content (nearest in its
/// logarithm) applies. `EmulatedSimulation` predicts the shear stresses of dry grains and all solid
/// fractions. The covariance of a prediction includes the error of c* only at conditions to which
/// c* was not fitted. Each fitted c* reduces the degrees of freedom of a misfit by one
/// (`fitted_cohesions`), but `Fit::dof` does not include this reduction.
/// Source: Badetti et al. (2018), Eq. (16).
class MohrCoulombModel : public FlowPredictor {
  public:
    /// @param study with the measured strengths (`with_strengths`)
    /// @throws InputError if the study has no strength at P* >= `lowest_cohesion_pressure`
    MohrCoulombModel(std::shared_ptr<const EmulatedSimulation> simulation, const Study& study);

    const std::vector<Parameter>& parameters() const override { return simulation_->parameters(); }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override { return simulation_->bounds(); }

    /// Returns pairs of liquid content [1] and fitted c* = a^2 c/F0 [1], by increasing liquid
    /// content.
    /// @param friction friction coefficient of the study's grains [1]
    std::vector<std::pair<double, double>> cohesions(double friction) const;

  private:
    /// Fitted c* of one liquid content, as a linear function of the simulated shear stresses tau_i
    /// [Pa] of dry grains at the conditions of the strengths: c* = constant - sum weight_i tau_i.
    struct Line {
        double liquid_content = 0, constant = 0, variance = 0;
        std::vector<Condition> conditions;  ///< of the strengths, with liquid content 0
        std::vector<Condition> fitted;      ///< of the strengths, with their liquid contents
        Eigen::RowVectorXd weight;
    };
    std::size_t line_at(double liquid_content) const;
    std::vector<EffectiveCondition> dry_conditions() const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    std::vector<Line> lines_;
};

/// Returns the number of constant cohesions that a model fits: with the base model "mohr-coulomb",
/// one for each liquid content; 0 for other base models, and if an effect of the model replaces the
/// cohesions by a formula or by the simulation.
int fitted_cohesions(const ModelSettings& model, const GrainProperties& grains,
                     const std::optional<Liquid>& liquid);

/// Returns `study` with the stress ratios of all wet readings of steady shear as new
/// `ModelSettings::strengths`, in place of any earlier ones. A study whose base model is not
/// "mohr-coulomb" is returned unchanged.
Study with_strengths(Study study, const std::vector<Reading>& readings);

}  // namespace pendular
