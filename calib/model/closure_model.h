#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "sim/closures/level.h"

namespace pendular {

/// Predictor of the stress ratio mu* of wet grains by an analytical formula (closure) of Badetti et
/// al. (2018):
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z/(pi P*)]                        (level rumpf)
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)]                       (level strength3)
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)] - a^2 s12cap/(F0 P*)  (level strength2)
///     mu* = mu*_dry(mu, I) [1 - s22cap/s22] - s12cap/s22                (level strength1)
///     Z = Z_c + 0.5 Z_d,  Z* = Z_c + Z_d F_d/F0,  P* = a^2 s22/F0,
/// with the simulated stress ratio mu*_dry of dry grains of friction coefficient mu.
///
/// `EmulatedSimulation` predicts the shear stresses of dry grains and all solid fractions.
/// Covariances omit the errors of Z, Z*, s22cap and s12cap, which are a few per mille.
/// Source: Badetti et al. (2018), Eq. (24) after Rumpf, Eq. (19) to Eq. (23).
class ClosureModel : public FlowPredictor {
  public:
    /// @param level `rumpf`, `strength3`, `strength2` or `strength1`
    ClosureModel(std::shared_ptr<const EmulatedSimulation> simulation, const Study& study,
                 closures::Level level)
        : simulation_(std::move(simulation)), study_(study), level_(level) {}

    const std::vector<Parameter>& parameters() const override { return simulation_->parameters(); }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override { return simulation_->bounds(); }

  private:
    struct Closure;
    Closure closure_at(double friction, const EffectiveCondition& condition) const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    closures::Level level_;
};

/// Returns `conditions`, followed by a dry copy of each wet condition, in the order of the wet
/// conditions. A dry copy has liquid content 0 and lacks the effects on grains that need liquid.
std::vector<EffectiveCondition> with_dry_twins(const std::vector<EffectiveCondition>& conditions);

}  // namespace pendular
