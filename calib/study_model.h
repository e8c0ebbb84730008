#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "calib/direct_simulation.h"
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
    std::unique_ptr<FlowModel> with_effects_;  ///< none for a study without
    std::vector<DirectMeasurement> direct_;
    FlowModel* model_ = nullptr;
};

}  // namespace pendular
