#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "calib/direct_simulation.h"
#include "calib/effect_model.h"
#include "calib/emulated_simulation.h"
#include "data/study.h"
#include "sim/effect_catalogue.h"

namespace pendular {

struct Calibration;

/// The simulation behind a study, emulated or direct, on top of it the model that the study's base
/// names, and on top of that the study's effects.
class StudyModel {
  public:
    /// Emulated where there are known runs that can serve the study.
    StudyModel(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers,
               const std::optional<KnownRuns>& known = {});
    /// The model of a finished calibration, made again from its runs.
    StudyModel(const Study& study, const Calibration& calibration);

    FlowModel& model() { return *model_; }
    const FlowModel& model() const { return *model_; }
    const SimulationModel& simulation() const { return *simulation_; }
    /// The same model on an instrument that shows the truth: without the study's effects on the
    /// instrument. What grains and liquid do is all in it.
    const FlowModel& flow() const { return *flow_; }
    /// Values of the parameters of flow(), from values of those of model().
    Eigen::VectorXd flow_parameters(const Eigen::VectorXd& parameters) const;
    /// Conditions as the study's effects on grains and liquid make them at these values of the
    /// parameters of model(), where the instrument shows the truth.
    std::vector<Condition> imposed(const Eigen::VectorXd& parameters,
                                   const std::vector<Condition>& conditions) const;
    /// The effects that the study lists, in its order.
    const std::vector<const Effect*>& effects() const { return effects_; }
    /// The study's direct measurements, which the model predicts too.
    const std::vector<DirectMeasurement>& direct() const { return direct_; }

    /// Writes into a calibration what makes this model again, and what it ordered.
    void note_in(Calibration& calibration) const;

  private:
    std::unique_ptr<SimulationModel> simulation_;
    DirectSimulation* simulated_ = nullptr;   ///< the simulation, if it is this
    EmulatedSimulation* emulated_ = nullptr;  ///< or this
    std::unique_ptr<FlowModel> closure_;      ///< none for base "dem"
    std::unique_ptr<EffectCatalogue> catalogue_;
    std::vector<const Effect*> effects_;
    std::unique_ptr<FlowModel> with_effects_;  ///< none for a study without
    std::unique_ptr<EffectModel>
        with_grain_effects_;  ///< likewise; those on the instrument are off
    std::vector<DirectMeasurement> direct_;
    FlowModel* model_ = nullptr;
    FlowModel* flow_ = nullptr;
};

}  // namespace pendular
