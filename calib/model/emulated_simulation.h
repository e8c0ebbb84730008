#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "calib/emulator/emulated_state.h"
#include "calib/emulator/emulator.h"
#include "calib/model/predictor.h"
#include "data/study/study.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Predictor of the shear stress [Pa] and solid fraction [1] of dry and wet grains by the emulator.
/// The only parameter is the friction coefficient.
///
/// A prediction holds for the stiffness number of the study's grains at the normal stress of the
/// condition or, if the study states no Young's modulus, for the stiffness number of `Fidelity`.
/// The emulated coordination number converts the liquid content to a bridge volume.
///
/// A `friction` argument is the friction coefficient of the study's grains [1], to which the
/// friction difference of the condition is added. Structural quantities come with their derivative
/// with respect to it at constant liquid content.
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

    /// Returns the state of the study's grains at a condition. A wet state has the bridge volume
    /// that yields the liquid content of the condition.
    FlowState flow_state_at(double friction, const EffectiveCondition& condition) const;
    /// Returns flow_state_at() with bridge volume 0, which saves the time to compute the volume.
    FlowState unfilled_state_at(double friction, const EffectiveCondition& condition) const;
    /// Returns the shear stress [Pa] and solid fraction [1] of a reading at `condition`, converted
    /// from rigid grains to the stiffness number of the study's grains.
    /// @param flow stress ratio [1], solid fraction of rigid grains [1], and mean overlap divided
    ///        by grain diameter [1]
    Eigen::Vector2d reading_of(const Eigen::Vector3d& flow,
                               const EffectiveCondition& condition) const;
    /// Returns the wet state `state` with the bridge volume that yields `liquid_content` [1].
    FlowState filled(const FlowState& state, double liquid_content) const;
    /// Returns the effective coordination number Z* = Z_c + Z_d F_d/F0 at a wet condition [1].
    StructureResponse effective_coordination(double friction,
                                             const EffectiveCondition& condition) const;
    /// Returns the approximate coordination number Z_c + 0.5 Z_d at a wet condition [1].
    StructureResponse approximate_coordination(double friction,
                                               const EffectiveCondition& condition) const;
    /// Returns the normal stress of the capillary forces at a wet condition, divided by F0/a^2 [1].
    /// Compression is positive, so that the capillary stress is negative.
    StructureResponse capillary_normal_stress(double friction,
                                              const EffectiveCondition& condition) const;
    /// Returns the shear stress of the capillary forces at a wet condition, divided by F0/a^2 [1].
    /// A positive capillary stress lowers the stress ratio.
    StructureResponse capillary_shear_stress(double friction,
                                             const EffectiveCondition& condition) const;

    const Emulator& emulator() const { return emulator_; }
    /// Returns the value nearest to `friction` within the range of the parameter, 0 to 1.
    double allowed(double friction) const;

  private:
    /// Contributions to the errors of predictions other than the errors of the emulator.
    struct Errors;
    /// Predicts values and derivatives at each state.
    /// @param errors receives the contributions to the errors; may be null
    Prediction predict_slopes(const std::vector<FlowState>& states,
                              const std::vector<EffectiveCondition>& conditions,
                              Errors* errors) const;
    Eigen::VectorXd predict_values(const std::vector<FlowState>& states,
                                   const std::vector<EffectiveCondition>& conditions) const;
    Prediction predict_all(const std::vector<FlowState>& states,
                           const std::vector<EffectiveCondition>& conditions) const;
    /// Returns (phi_study - phi_reference)/(phi_rigid - phi_reference) at a condition [1]
    /// (`stiffness_share`), with the solid fraction phi_reference of grains of stiffness number
    /// `emulated::reference_stiffness`. Negative if the study's grains are softer.
    double stiffness_left(const EffectiveCondition& condition) const;
    /// Returns a capillary stress at a wet condition, divided by F0/a^2 [1].
    /// @param which emulated observable: a capillary stress divided by the normal stress
    StructureResponse capillary_stress(dem::Observable which, double friction,
                                       const EffectiveCondition& condition) const;
    /// Converts the derivative by friction from constant bridge volume to constant liquid content.
    StructureResponse at_constant_content(StructureResponse response, const FlowState& state) const;

    Study study_;
    Fidelity fidelity_;
    Emulator emulator_;
    std::vector<Parameter> parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}};

    /// Cached state with its bridge volume: derivatives and covariances need each state again.
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
