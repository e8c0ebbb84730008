#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "sim/closures/strength.h"
#include "sim/closures/terms.h"

namespace pendular {

/// Base `rumpf`: the simulated dry law mu*_dry with a cohesion after Rumpf's formula, which uses
/// simulated solid fractions Phi_S and coordination numbers Z*,
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)]                          (eq:strength3)
/// or, with the capillary shear stress, this mu* minus a^2 s12cap/(F0 P*) (eq:strength2). Dry
/// readings and all solid fractions are those of the simulation. Without the capillary shear
/// stress, mu* is too high at small liquid contents. The covariance of predictions leaves out the
/// error of Z*, a few per mille.
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
    /// Quantities that the closure needs at a wet condition.
    struct Closure {
        StructureResponse z, shear;  ///< Z* and a^2 s12cap/F0 [1]
        double pressure = 0;         ///< reduced pressure P* [1]
        /// Shear stress of wet grains [Pa] with Rumpf's cohesion alone, from the shear stress `dry`
        /// of dry grains [Pa] and the solid fraction [1].
        double rumpf_stress(double dry, double fraction, const EffectiveCondition& condition) const;
    };
    Closure closure_at(double friction, const EffectiveCondition& condition) const;

    Eigen::VectorXd predict_values(const Eigen::VectorXd& parameters,
                                   const std::vector<EffectiveCondition>& conditions) const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    closures::Terms terms_;
};

/// Returns the conditions, followed by a dry copy of each wet condition, in order. A dry copy gives
/// the dry law at the friction of the wet grains, without effects on grains that need liquid.
std::vector<EffectiveCondition> with_dry_twins(const std::vector<EffectiveCondition>& conditions);

}  // namespace pendular
