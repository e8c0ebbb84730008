#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/structure_response.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Predictor of shear stress and solid fraction of dry and wet grains by the emulator (Gaussian
/// processes trained on runs). Its only parameter is the friction.
///
/// Predictions hold for the stiffness number of the study's grains at each normal stress or, where
/// the study states no Young's modulus, that of the fidelity (set of simulation settings). A liquid
/// content is converted into a bridge volume by means of the emulated coordination number.
class EmulatedSimulation : public FlowPredictor {
  public:
    EmulatedSimulation(const Study& study, const Fidelity& fidelity, Emulator emulator);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;
    std::unique_ptr<const FlowNeighbourhood> neighbourhood(
        const Eigen::VectorXd& parameters,
        const std::vector<EffectiveCondition>& conditions) const override;

    /// Flow state of a condition where the study's grains have the friction coefficient `friction`,
    /// to which the condition's friction difference is added [1]. A wet state has the bridge volume
    /// that gives the condition's liquid content.
    FlowState flow_state_at(double friction, const EffectiveCondition& condition) const;
    /// Flow state as `flow_state_at` gives it, but without the bridge volume of a wet state.
    FlowState unfilled_state_at(double friction, const EffectiveCondition& condition) const;
    /// Shear stress [Pa] and solid fraction [1] at a condition where the emulator predicts `flow`:
    /// stress ratio and solid fraction of rigid grains, and overlap over grain diameter [1].
    Eigen::Vector2d reading_of(const Eigen::Vector3d& flow,
                               const EffectiveCondition& condition) const;
    /// Returns the wet flow state `state` with its bridge volume replaced by the one that gives the
    /// liquid content Phi_L/Phi_S [1].
    FlowState filled(const FlowState& state, double liquid_content) const;
    /// Effective coordination number Z* at a wet condition [1] with its derivative by the friction
    /// at constant liquid content.
    StructureResponse effective_coordination(double friction,
                                             const EffectiveCondition& condition) const;
    /// Approximate coordination number Z_c + 0.5 Z_d at a wet condition [1], with its derivative by
    /// the friction at constant liquid content (`closures::approximate_coordination`).
    StructureResponse approximate_coordination(double friction,
                                               const EffectiveCondition& condition) const;
    /// Capillary normal stress a^2 s22cap/F0 at a wet condition [1], negative, with its derivative
    /// by the friction at constant liquid content.
    StructureResponse capillary_normal_stress(double friction,
                                              const EffectiveCondition& condition) const;
    /// Capillary shear stress a^2 s12cap/F0 at a wet condition [1] with its derivative by the
    /// friction at constant liquid content.
    StructureResponse capillary_shear_stress(double friction,
                                             const EffectiveCondition& condition) const;

    const Emulator& emulator() const { return emulator_; }
    /// Friction within the parameter's range that is nearest to `friction` [1].
    double allowed(double friction) const;

  private:
    /// Contributions to the standard errors of predicted shear stresses and solid fractions.
    struct Errors;
    /// Predicts shear stress [Pa] and solid fraction [1] at each state, with derivatives by the
    /// friction; if `errors` is not null, also writes the contributions to their standard errors to
    /// it.
    Prediction predict_slopes(const std::vector<FlowState>& states,
                              const std::vector<EffectiveCondition>& conditions,
                              Errors* errors) const;
    /// Predicts shear stress [Pa] and solid fraction [1] at each state, stacked as in `Prediction`.
    Eigen::VectorXd predict_values(const std::vector<FlowState>& states,
                                   const std::vector<EffectiveCondition>& conditions) const;
    /// Predicts shear stress [Pa] and solid fraction [1] at each state, with derivatives by the
    /// friction and the covariances of their errors.
    Prediction predict_all(const std::vector<FlowState>& states,
                           const std::vector<EffectiveCondition>& conditions) const;
    /// Share [1] of the rigidity shift of the solid fraction (from rigid grains to grains of the
    /// emulator's reference stiffness number) that the study's grains at this condition do not
    /// have.
    double stiffness_left(const EffectiveCondition& condition) const;
    /// A stress over s22 at a wet condition, emulated, in units of F0/a^2 [1], with its derivative
    /// by the friction at constant liquid content.
    StructureResponse capillary_stress(dem::Observable which, double friction,
                                       const EffectiveCondition& condition) const;
    /// Returns `response`, a quantity at the wet state `state`, with its derivative by friction
    /// converted from constant bridge volume to constant liquid content.
    StructureResponse at_constant_content(StructureResponse response, const FlowState& state) const;

    Study study_;
    Fidelity fidelity_;
    Emulator emulator_;
    std::vector<Parameter> parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}};

    /// Flow state that `filled` found for a liquid content Phi_L/Phi_S [1]. States are cached,
    /// since derivatives and covariances need them again; each state is the same whatever the order
    /// of requests.
    struct Filled {
        double liquid_content;
        FlowState state;
    };
    struct Cache {
        std::mutex mutex;
        std::unordered_multimap<std::size_t, Filled> filled;
    };
    std::unique_ptr<Cache> cache_ = std::make_unique<Cache>();
};

}  // namespace pendular
