#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "sim/closures/strength.h"
#include "sim/closures/terms.h"

namespace pendular {

/// Base model `rumpf`: shear stress of wet grains from the simulated stress ratio mu*_dry of dry
/// grains and a cohesion after Rumpf's formula, with simulated solid fraction Phi_S and
/// coordination number Z*,
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)]                          (eq:strength3)
/// or, with the term for the capillary shear stress, this mu* minus a^2 s12cap/(F0 P*)
/// (eq:strength2). Dry shear stresses and all solid fractions are those of `EmulatedSimulation`.
/// Without this term, mu* is too high at small liquid contents. The covariance of predictions
/// leaves out the error of Z*, a few per mille.
/// Source: Badetti et al. (2018), eq:strength3 and eq:cohesion3, after Rumpf.
class RumpfModel : public FlowPredictor {
  public:
    RumpfModel(std::shared_ptr<const EmulatedSimulation> simulation, const Study& study,
               const closures::Terms& terms = {})
        : simulation_(std::move(simulation)), study_(study), terms_(terms) {}

    const std::vector<Parameter>& parameters() const override { return simulation_->parameters(); }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override { return simulation_->bounds(); }

  private:
    /// Quantities that the closure (formula for the shear stress of wet grains) needs at a wet
    /// condition.
    struct Closure {
        /// Coordination number Z* and capillary shear stress a^2 s12cap/F0 [1].
        StructureResponse z, shear;
        double pressure = 0;  ///< reduced pressure P* [1]
        /// Shear stress of wet grains [Pa] by eq:strength3, from the simulated shear stress `dry`
        /// of the grains without liquid [Pa] and the solid fraction `fraction` of the wet grains
        /// [1].
        double rumpf_stress(double dry, double fraction, const EffectiveCondition& condition) const;
    };
    Closure closure_at(double friction, const EffectiveCondition& condition) const;

    Eigen::VectorXd predict_values(const Eigen::VectorXd& parameters,
                                   const std::vector<EffectiveCondition>& conditions) const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    closures::Terms terms_;
};

/// Returns `conditions`, followed by a copy of each wet one with liquid content 0, in the same
/// order. The copies lack effects on grains that need liquid and keep all else, such as the
/// friction.
std::vector<EffectiveCondition> with_dry_twins(const std::vector<EffectiveCondition>& conditions);

}  // namespace pendular
