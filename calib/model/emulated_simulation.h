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

/// Predictor of dry and wet readings by the emulator; its parameter is the friction.
///
/// The solid fraction is that of rigid grains, corrected for the study's stiffness by means of the
/// overlaps. A liquid content is turned into a bridge volume with the emulated coordination.
class EmulatedSimulation : public FlowPredictor {
  public:
    EmulatedSimulation(const Study& study, const Fidelity& fidelity, Emulator emulator);

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart what = PredictionPart::covariance) const override;
    ParameterBounds bounds() const override;

    /// State to simulate for a condition: a wet one at the bridge volume that has its liquid
    /// content.
    FlowState flow_state_at(double friction, const EffectiveCondition& condition) const;
    /// Wet state with the bridge volume that gives this liquid content.
    FlowState filled(const FlowState& state, double liquid_content) const;
    /// Z* and a^2 s12cap/F0 at a wet condition; derivatives by friction at constant liquid content.
    StructureResponse effective_coordination(double friction,
                                             const EffectiveCondition& condition) const;
    StructureResponse capillary_shear_stress(double friction,
                                             const EffectiveCondition& condition) const;

    const Emulator& emulator() const { return emulator_; }
    /// Friction within the bounds that is nearest to the given one [1].
    double allowed(double friction) const;

  private:
    /// Contributions to the errors of predictions.
    struct Errors;
    Prediction predict_slopes(const std::vector<FlowState>& states,
                              const std::vector<EffectiveCondition>& conditions,
                              Errors* errors) const;
    Eigen::VectorXd predict_values(const std::vector<FlowState>& states,
                                   const std::vector<EffectiveCondition>& conditions) const;
    Prediction predict_all(const std::vector<FlowState>& states,
                           const std::vector<EffectiveCondition>& conditions) const;
    /// Share of the stiffness correction of the solid fraction that a reading at this condition
    /// still needs [1].
    double stiffness_left(const EffectiveCondition& condition) const;
    StructureResponse at_constant_content(StructureResponse response, const FlowState& state) const;

    Study study_;
    Fidelity fidelity_;
    Emulator emulator_;
    std::vector<Parameter> parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}};

    /// Cache of the states that `filled` found, which derivatives and covariances need again. Its
    /// content does not depend on the order of requests.
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
