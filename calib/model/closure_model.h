#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "sim/closures/level.h"

namespace pendular {

/// Model of wet grains by a closure (analytical formula): shear stress of wet grains from the
/// simulated stress ratio mu*_dry of dry grains and the simulated structure at the reduced pressure
/// P*, with solid fraction Phi_S and coordination number Z,
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z/(pi P*)]                        (rumpf, strength3)
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)] - a^2 s12cap/(F0 P*)  (strength2)
///     mu* = mu*_dry(mu, I) [1 - s22cap/s22] - s12cap/s22                (strength1)
/// where Z is Z_c + 0.5 Z_d on the level `rumpf` of the ladder of closures, and Z* above. Dry shear
/// stresses and all solid fractions are those of `EmulatedSimulation`. The covariance of
/// predictions leaves out the errors of Z and of the capillary stresses, a few per mille.
/// Source: Badetti et al. (2018), eq:cohesion3 after Rumpf, eq:strength1 to eq:strength3.
class ClosureModel : public FlowPredictor {
  public:
    /// @param level one of the levels with the formulas above
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

/// Returns `conditions`, followed by a copy of each wet one with liquid content 0, in the same
/// order. The copies lack effects on grains that need liquid and keep all else, such as the
/// friction.
std::vector<EffectiveCondition> with_dry_twins(const std::vector<EffectiveCondition>& conditions);

}  // namespace pendular
