#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Lowest reduced pressure P* [1] of readings to which a straight line of stress ratio against 1/P*
/// is fitted.
/// Source: Badetti et al. (2018), who find that the line is too high at lower P*.
constexpr double lowest_cohesion_pressure = 2.3;

/// Measured strengths (stress ratios) of wet readings of about one liquid content, to which a
/// constant cohesion is fitted.
struct CohesionGroup {
    /// Liquid content (liquid volume divided by grain volume) [1], mean of the strengths.
    double liquid_content = 0;
    /// Measured stress ratios of the group's readings at reduced pressures P* >=
    /// `lowest_cohesion_pressure`.
    std::vector<MeasuredStrength> strengths;
};

/// Groups the strengths (stress ratios) of wet readings, `ModelSettings::strengths`, at reduced
/// pressures P* >= `lowest_cohesion_pressure` by liquid content, in increasing liquid content.
/// Liquid contents of a group agree within 2 %. Empty if the study has no liquid.
std::vector<CohesionGroup> cohesion_groups(const ModelSettings& model,
                                           const GrainProperties& grains,
                                           const std::optional<Liquid>& liquid);

/// Predictor of the base model "mohr-coulomb": the stress ratio mu* of wet grains is a straight
/// line in 1/P*,
///     mu* = mu*_dry(mu, I) + c*/P*
/// with the reduced pressure P*, the simulated stress ratio mu*_dry of dry grains of friction
/// coefficient mu at inertial number I, and a constant reduced cohesion c* for each liquid content.
/// Each c* is fitted, for every value of mu, by weighted least squares to the study's measured
/// strengths (stress ratios) y_i at P*_i >= `lowest_cohesion_pressure`:
///     c* = sum w_i (y_i - mu*_dry(mu, I_i))/P*_i / sum w_i/P*_i^2,    w_i = 1/error(y_i)^2.
/// At any other liquid content, c* is that of the fitted liquid content with the nearest logarithm.
/// Shear stresses of dry grains and all solid fractions are those of `EmulatedSimulation`. The
/// covariance of predictions includes the error of c* only at conditions to which c* was not
/// fitted; a misfit has one degree of freedom less for each fitted c* (`fitted_cohesions`).
/// Source: Badetti et al. (2018), eq:mohrcoulomb2.
class MohrCoulombModel : public FlowPredictor {
  public:
    /// @param study study with the measured strengths of its wet readings (`with_strengths`)
    /// @throws InputError if the study has no strength at P* >= `lowest_cohesion_pressure`
    MohrCoulombModel(std::shared_ptr<const EmulatedSimulation> simulation, const Study& study);

    const std::vector<Parameter>& parameters() const override { return simulation_->parameters(); }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override { return simulation_->bounds(); }

    /// Returns the fitted reduced cohesions at a friction coefficient [1]: pairs of liquid content
    /// [1] and reduced cohesion c* [1], in increasing liquid content.
    std::vector<std::pair<double, double>> cohesions(double friction) const;

  private:
    /// Fitted reduced cohesion c* of one liquid content, as a linear function of the simulated
    /// shear stresses tau_i [Pa] of dry grains at the conditions of its strengths: c* = constant -
    /// sum weight_i tau_i.
    struct Line {
        double liquid_content = 0, constant = 0, variance = 0;
        /// Conditions of the strengths (stress ratios of wet readings) to which c* is fitted, with
        /// their liquid removed.
        std::vector<Condition> conditions;
        /// Conditions of the strengths (stress ratios of wet readings) to which c* is fitted, with
        /// their liquid.
        std::vector<Condition> fitted;
        Eigen::RowVectorXd weight;
    };
    std::size_t line_at(double liquid_content) const;
    std::vector<EffectiveCondition> dry_conditions() const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    std::vector<Line> lines_;
};

/// Number of constant cohesions that a study's model fits to the strengths (stress ratios) of wet
/// readings. It is one for each liquid content with base model "mohr-coulomb", and 0 for other base
/// models or if an effect replaces the cohesions by another formula.
int fitted_cohesions(const ModelSettings& model, const GrainProperties& grains,
                     const std::optional<Liquid>& liquid);

/// Returns `study` with the strengths (stress ratios with standard errors) of those `readings` that
/// are wet and of steady shear added to its model settings. Returns it unchanged unless its base
/// model is "mohr-coulomb".
Study with_strengths(Study study, const std::vector<Reading>& readings);

}  // namespace pendular
