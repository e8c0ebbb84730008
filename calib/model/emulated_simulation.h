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

/// Predictor of dry and wet readings by the emulator (Gaussian processes trained on runs). Its only
/// parameter is the friction.
///
/// The emulated solid fraction of rigid grains is corrected to the study's stiffness by means of
/// the emulated overlaps. A liquid content is converted into a bridge volume by means of the
/// emulated coordination number.
class EmulatedSimulation : public FlowPredictor {
  public:
    EmulatedSimulation(const Study& study, const Fidelity& fidelity, Emulator emulator);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;

    /// Flow state of a condition at a friction of the study's grains. For a wet condition, its
    /// bridge volume gives the condition's liquid content.
    FlowState flow_state_at(double friction, const EffectiveCondition& condition) const;
    /// Returns a wet state with the bridge volume that gives a liquid content Phi_L/Phi_S [1].
    FlowState filled(const FlowState& state, double liquid_content) const;
    /// Effective coordination number Z* at a wet condition [1]; its derivative by friction is that
    /// at constant liquid content.
    StructureResponse effective_coordination(double friction,
                                             const EffectiveCondition& condition) const;
    /// Capillary shear stress a^2 s12cap/F0 at a wet condition [1]; its derivative by friction is
    /// that at constant liquid content.
    StructureResponse capillary_shear_stress(double friction,
                                             const EffectiveCondition& condition) const;

    const Emulator& emulator() const { return emulator_; }
    /// Friction within the parameter's range that is nearest to `friction` [1].
    double allowed(double friction) const;

  private:
    /// Contributions to the errors of predictions.
    struct Errors;
    /// Predicts values and derivatives; fills `errors` where it is not null.
    Prediction predict_slopes(const std::vector<FlowState>& states,
                              const std::vector<EffectiveCondition>& conditions,
                              Errors* errors) const;
    /// Predicts values alone.
    Eigen::VectorXd predict_values(const std::vector<FlowState>& states,
                                   const std::vector<EffectiveCondition>& conditions) const;
    /// Predicts values, derivatives and covariances.
    Prediction predict_all(const std::vector<FlowState>& states,
                           const std::vector<EffectiveCondition>& conditions) const;
    /// Part of the rigidity shift of the solid fraction at the emulator's reference stiffness
    /// number that separates it from the study's stiffness at this condition [1].
    double stiffness_left(const EffectiveCondition& condition) const;
    /// Converts the derivative by friction at constant bridge volume into that at constant liquid
    /// content.
    StructureResponse at_constant_content(StructureResponse response, const FlowState& state) const;

    Study study_;
    Fidelity fidelity_;
    Emulator emulator_;
    std::vector<Parameter> parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}};

    /// State that `filled` found for a liquid content. States are cached, since derivatives and
    /// covariances need them again; each state is the same whatever the order of requests.
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
