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

/// Predictor of the shear stress [Pa] and solid fraction [1] of dry and wet grains by the emulator
/// (Gaussian processes trained on simulation runs). The only parameter is the friction coefficient.
///
/// A prediction holds for the stiffness number of the study's grains at the normal stress of the
/// condition. If the study states no Young's modulus, the stiffness number of the simulation
/// settings (`Fidelity`) applies. The emulated coordination number converts the liquid content to a
/// bridge volume.
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

    /// Returns the state of steady shear, in dimensionless numbers, of the study's grains at a
    /// condition. A wet state has the bridge volume that yields the liquid content of the
    /// condition.
    /// @param friction friction coefficient of the study's grains [1], to which the friction
    ///        difference of the condition is added
    FlowState flow_state_at(double friction, const EffectiveCondition& condition) const;
    /// Returns the state of steady shear of the study's grains at a condition, with bridge volume
    /// 0. The function does not spend the time to compute the bridge volume that yields the liquid
    /// content of the condition.
    /// @param friction friction coefficient of the study's grains [1], to which the friction
    ///        difference of the condition is added
    FlowState unfilled_state_at(double friction, const EffectiveCondition& condition) const;
    /// Converts emulated quantities to the shear stress [Pa] and solid fraction [1] of a reading at
    /// `condition`. The function converts the solid fraction of rigid grains to the solid fraction
    /// of grains with the study's stiffness number.
    /// @param flow stress ratio [1], solid fraction of rigid grains [1], and mean overlap divided
    ///        by grain diameter [1]
    Eigen::Vector2d reading_of(const Eigen::Vector3d& flow,
                               const EffectiveCondition& condition) const;
    /// Returns the wet state `state` with the bridge volume at which the liquid content of the
    /// grains is `liquid_content`, the volume of liquid divided by the volume of grains [1].
    FlowState filled(const FlowState& state, double liquid_content) const;
    /// Returns the effective coordination number Z* = Z_c + Z_d F_d/F0 at a wet condition [1], with
    /// the derivative of Z* with respect to the friction coefficient at constant liquid content.
    /// Each grain has Z_c contacts and Z_d bridges without contact. F_d is the mean force of
    /// bridges without contact, and F0 the pull-off force of a bridge.
    /// @param friction friction coefficient of the study's grains [1]
    StructureResponse effective_coordination(double friction,
                                             const EffectiveCondition& condition) const;
    /// Returns the approximate coordination number Z_c + 0.5 Z_d at a wet condition [1], with the
    /// derivative of the coordination number with respect to the friction coefficient at constant
    /// liquid content. There are Z_c contacts per grain and Z_d bridges without contact per grain.
    /// @param friction friction coefficient of the study's grains [1]
    StructureResponse approximate_coordination(double friction,
                                               const EffectiveCondition& condition) const;
    /// Returns the normal stress of the capillary forces at a wet condition, divided by F0/a^2 [1],
    /// with its derivative with respect to the friction coefficient at constant liquid content.
    /// Compression is positive, so that the capillary stress is negative. F0 is the pull-off force
    /// of a bridge, and a the grain diameter.
    /// @param friction friction coefficient of the study's grains [1]
    StructureResponse capillary_normal_stress(double friction,
                                              const EffectiveCondition& condition) const;
    /// Returns the shear stress of the capillary forces at a wet condition, divided by F0/a^2 [1],
    /// with its derivative with respect to the friction coefficient at constant liquid content. A
    /// positive capillary stress lowers the stress ratio. F0 is the pull-off force of a bridge, and
    /// a the grain diameter.
    /// @param friction friction coefficient of the study's grains [1]
    StructureResponse capillary_shear_stress(double friction,
                                             const EffectiveCondition& condition) const;

    const Emulator& emulator() const { return emulator_; }
    /// Returns the value between 0 and 1 that is nearest to the friction coefficient `friction`
    /// [1].
    double allowed(double friction) const;

  private:
    /// Contributions to the errors of predicted shear stresses and solid fractions, other than the
    /// errors of the emulated stress ratios and solid fractions.
    struct Errors;
    /// Predicts the shear stress [Pa] and solid fraction [1] at each state in turn, with
    /// derivatives with respect to the friction coefficient.
    /// @param errors receives the contributions to the errors of the predictions; may be null
    Prediction predict_slopes(const std::vector<FlowState>& states,
                              const std::vector<EffectiveCondition>& conditions,
                              Errors* errors) const;
    /// Predicts the shear stress [Pa] and solid fraction [1] at each state in turn.
    Eigen::VectorXd predict_values(const std::vector<FlowState>& states,
                                   const std::vector<EffectiveCondition>& conditions) const;
    /// Predicts the shear stress [Pa] and solid fraction [1] at each state in turn, with
    /// derivatives with respect to the friction coefficient and with the covariance of the errors.
    Prediction predict_all(const std::vector<FlowState>& states,
                           const std::vector<EffectiveCondition>& conditions) const;
    /// Returns (phi_study - phi_reference)/(phi_rigid - phi_reference) at a condition [1]
    /// (`stiffness_share`). The solid fractions are phi_study of the study's grains, phi_reference
    /// of grains with the stiffness number `emulated::reference_stiffness`, and phi_rigid of rigid
    /// grains. The result is negative if the study's grains are softer than the reference.
    double stiffness_left(const EffectiveCondition& condition) const;
    /// Returns an emulated capillary stress at a wet condition, divided by F0/a^2 [1], with its
    /// derivative with respect to the friction coefficient at constant liquid content. F0 is the
    /// pull-off force of a bridge, and a the grain diameter.
    /// @param which emulated observable: a capillary stress divided by the normal stress
    StructureResponse capillary_stress(dem::Observable which, double friction,
                                       const EffectiveCondition& condition) const;
    /// Converts the derivative of `response` with respect to the friction coefficient, at the wet
    /// state `state`, from constant bridge volume to constant liquid content.
    StructureResponse at_constant_content(StructureResponse response, const FlowState& state) const;

    Study study_;
    Fidelity fidelity_;
    Emulator emulator_;
    std::vector<Parameter> parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}};

    /// Cached state of steady shear with the bridge volume that yields a given liquid content
    /// (liquid volume divided by grain volume) [1]. The computation of derivatives and covariances
    /// needs each state again.
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
