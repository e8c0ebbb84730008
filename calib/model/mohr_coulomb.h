#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Lowest reduced pressure P* [1] of the readings to which a straight line of stress ratio against
/// the inverse reduced pressure 1/P* is fitted.
/// Source: Badetti et al. (2018), who find that the stress ratio of the line is too high at lower
/// P*.
constexpr double lowest_cohesion_pressure = 2.3;

/// Measured strengths (stress ratios) of wet readings of nearly equal liquid content, to which one
/// constant cohesion is fitted.
struct CohesionGroup {
    /// Mean liquid content of the readings in the group (liquid volume divided by grain volume)
    /// [1].
    double liquid_content = 0;
    /// Measured stress ratios of the readings of the group, all at reduced pressures P* >=
    /// `lowest_cohesion_pressure`.
    std::vector<MeasuredStrength> strengths;
};

/// Groups the strengths (stress ratios) of the wet readings, `model.strengths`, by liquid content.
/// The groups are in the order of increasing liquid content. Strengths at reduced pressures below
/// `lowest_cohesion_pressure` are left out. All liquid contents of a group agree within 2 % with
/// the liquid content of the first strength of the group. The list is empty if the study has no
/// liquid.
std::vector<CohesionGroup> cohesion_groups(const ModelSettings& model,
                                           const GrainProperties& grains,
                                           const std::optional<Liquid>& liquid);

/// Predictor of the base model "mohr-coulomb", in which the stress ratio mu* of wet grains is a
/// straight line in 1/P*,
///     mu* = mu*_dry(mu, I) + c*/P*
/// with the reduced pressure P*, the simulated stress ratio mu*_dry of dry grains of friction
/// coefficient mu at inertial number I, and a constant reduced cohesion c* for each liquid content.
/// For every value of mu, c* follows by weighted least squares from the study's measured strengths
/// (stress ratios) y_i at P*_i >= `lowest_cohesion_pressure`:
///     c* = sum w_i (y_i - mu*_dry(mu, I_i))/P*_i / sum w_i/P*_i^2,    w_i = 1/error(y_i)^2.
/// At a liquid content without a fitted c*, the c* of the nearest liquid content (nearest in its
/// logarithm) applies. `EmulatedSimulation` predicts the shear stresses of dry grains and all solid
/// fractions. The covariance of a prediction includes the error of c* only at conditions to which
/// c* was not fitted. Each fitted c* reduces the degrees of freedom of a misfit by one
/// (`fitted_cohesions`), but `Fit::dof` does not include this reduction.
/// Source: Badetti et al. (2018), Eq. (16).
class MohrCoulombModel : public FlowPredictor {
  public:
    /// @param study study with the measured strengths (stress ratios) of the wet readings
    ///        (`with_strengths`)
    /// @throws InputError if the study has no strength at a reduced pressure P* >=
    ///         `lowest_cohesion_pressure`
    MohrCoulombModel(std::shared_ptr<const EmulatedSimulation> simulation, const Study& study);

    const std::vector<Parameter>& parameters() const override { return simulation_->parameters(); }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override { return simulation_->bounds(); }

    /// Returns the fitted reduced cohesion c* = a^2 c/F0 [1] for each liquid content, with the
    /// cohesion c, the grain diameter a and the pull-off force F0 of a bridge. In each pair, the
    /// first number is the liquid content [1] and the second number is c*. The pairs are in the
    /// order of increasing liquid content.
    /// @param friction friction coefficient of the study's grains [1]
    std::vector<std::pair<double, double>> cohesions(double friction) const;

  private:
    /// Fitted reduced cohesion c* of one liquid content, as a linear function of the simulated
    /// shear stresses tau_i [Pa] of dry grains at the conditions of the strengths (stress ratios)
    /// to which c* is fitted: c* = constant - sum weight_i tau_i.
    struct Line {
        double liquid_content = 0, constant = 0, variance = 0;
        /// Conditions of the strengths (stress ratios of wet readings) to which c* is fitted, with
        /// liquid content 0.
        std::vector<Condition> conditions;
        /// Conditions of the strengths (stress ratios of wet readings) to which c* is fitted, with
        /// the liquid contents of the readings.
        std::vector<Condition> fitted;
        Eigen::RowVectorXd weight;
    };
    std::size_t line_at(double liquid_content) const;
    std::vector<EffectiveCondition> dry_conditions() const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    std::vector<Line> lines_;
};

/// Returns the number of constant cohesions that the model with the settings `model` fits to the
/// strengths (stress ratios) of wet readings. With the base model "mohr-coulomb", there is one
/// cohesion for each liquid content. The number is 0 for all other base models, and if an effect of
/// the model replaces the cohesions by a formula or by the simulation.
int fitted_cohesions(const ModelSettings& model, const GrainProperties& grains,
                     const std::optional<Liquid>& liquid);

/// Returns `study` with new `ModelSettings::strengths`, to which constant cohesions are fitted. The
/// strengths are the stress ratios, with standard errors, of all wet readings of steady shear among
/// `readings`. Any earlier strengths are removed. If the base model is not "mohr-coulomb", the
/// study is returned unchanged.
Study with_strengths(Study study, const std::vector<Reading>& readings);

}  // namespace pendular
