#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "sim/closures/strength.h"
#include "sim/closures/terms.h"

namespace pendular {

/// Base `rumpf`: the simulated dry law with the cohesion of Rumpf's formula, its solid fraction and
/// coordination simulated,
///     mu* = mu*_dry(mu, I) [1 + Phi_S Z*/(pi P*)]                          (eq:strength3)
/// or, with the capillary shear stress, that less a^2 s12cap/(F0 P*) (eq:strength2). Dry readings
/// and all solid fractions are those of the simulation. Without the capillary shear stress it is
/// too high at small liquid contents. The error of Z*, a few per mille, is not in its covariance.
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
    /// Closure applied to a wet condition: its stresses and their derivatives.
    struct Closure {
        StructureResponse z, shear;  ///< Z* and a^2 s12cap/F0
        double pressure = 0;         ///< P*
        /// Shear stress [Pa] with Rumpf's cohesion alone, of the dry one and the solid fraction.
        double rumpf_stress(double dry, double fraction, const EffectiveCondition& condition) const;
    };
    Closure closure_at(double friction, const EffectiveCondition& condition) const;

    Eigen::VectorXd predict_values(const Eigen::VectorXd& parameters,
                                   const std::vector<EffectiveCondition>& conditions) const;

    std::shared_ptr<const EmulatedSimulation> simulation_;
    Study study_;
    closures::Terms terms_;
};

/// Conditions, then a dry twin of each wet one in their order, which gives the dry law at the
/// friction of the wet grains; effects on grains that need liquid are off there.
std::vector<EffectiveCondition> with_dry_twins(const std::vector<EffectiveCondition>& conditions);

}  // namespace pendular
