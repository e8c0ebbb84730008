#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"

namespace pendular {

/// Lowest reduced pressure P* of readings to which a straight line of stress ratio against 1/P* is
/// fitted [1]. Source: Badetti et al. (2018), who find the line too high below.
constexpr double lowest_cohesion_pressure = 2.3;

/// Measured strengths at one liquid content from which a constant cohesion is fitted.
struct CohesionGroup {
    double liquid_content = 0;  ///< liquid content Phi_L/Phi_S [1], mean of the members
    std::vector<MeasuredStrength> strengths;  ///< strengths at P* >= `lowest_cohesion_pressure`
};

/// Groups the study's strengths at P* >= `lowest_cohesion_pressure` by liquid content, 2 % apart at
/// most, in increasing liquid content; empty where the study has no liquid.
std::vector<CohesionGroup> cohesion_groups(const ModelSettings& model,
                                           const GrainProperties& grains,
                                           const std::optional<Liquid>& liquid);

/// Base model `mohr-coulomb`: stress ratio of wet grains as a straight line in 1/P*,
///     mu* = mu*_dry(mu, I) + c*/P*
/// with the simulated stress ratio mu*_dry of dry grains and a constant reduced cohesion c* for
/// each liquid content. Each c* is fitted by weighted least squares to the study's strengths y_i at
/// P*_i >= `lowest_cohesion_pressure`, wherever the friction is:
///     c* = sum w_i (y_i - mu*_dry(mu, I_i))/P*_i / sum w_i/P*_i^2,    w_i = 1/error(y_i)^2.
/// At other liquid contents c* is that of the nearest fitted content, by ratio. Dry shear stresses
/// and all solid fractions are those of `EmulatedSimulation`. The covariance includes the errors of
/// c* at conditions to which it was not fitted; at the others the fit leaves residuals smaller than
/// the errors of the readings, and a misfit has one degree of freedom less for each c*.
/// Source: Badetti et al. (2018), eq:mohrcoulomb2.
class MohrCoulombModel : public FlowPredictor {
  public:
    /// @param study with `strengths` in its model settings
    /// @throws InputError where the study has no strength at P* >= `lowest_cohesion_pressure`
    MohrCoulombModel(std::shared_ptr<const EmulatedSimulation> simulation, const Study& study);

    const std::vector<Parameter>& parameters() const override { return simulation_->parameters(); }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override { return simulation_->bounds(); }

    /// Fitted reduced cohesions: liquid content [1] and c* [1] at a friction [1].
    std::vector<std::pair<double, double>> cohesions(double friction) const;

  private:
    /// One fitted cohesion as a linear function of the simulated dry shear stresses tau_i [Pa] at
    /// its strengths: c* = constant - sum weight_i tau_i.
    struct Line {
        double liquid_content = 0, constant = 0, variance = 0;
        std::vector<Condition> conditions;  ///< dry conditions of the strengths
        std::vector<Condition> fitted;      ///< wet conditions of the strengths
        Eigen::RowVectorXd weight;
    };
    std::size_t line_at(double liquid_content) const;
    std::vector<EffectiveCondition> dry_conditions() const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    std::vector<Line> lines_;
};

/// Number of cohesions that a study's model fits to the strengths of wet readings: 0 unless the
/// model is on the level `mohr_coulomb` of the ladder of closures.
int fitted_cohesions(const ModelSettings& model, const GrainProperties& grains,
                     const std::optional<Liquid>& liquid);

/// Returns the study with the strengths of its wet readings in its model settings, where its base
/// model is "mohr-coulomb"; else the study as it is.
Study with_strengths(Study study, const std::vector<Reading>& readings);

}  // namespace pendular
