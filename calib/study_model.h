#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "calib/direct_simulation.h"
#include "data/study.h"

namespace pendular {

struct Calibration;

/// The simulation behind a study and, on top of it, the model that the study's base names.
class StudyModel {
  public:
    StudyModel(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers);
    /// The model of a finished calibration, made again from its runs.
    StudyModel(const Study& study, const Calibration& calibration);

    FlowModel& model() { return *model_; }
    const FlowModel& model() const { return *model_; }
    const DirectSimulation& simulation() const { return *simulation_; }

  private:
    std::unique_ptr<DirectSimulation> simulation_;
    std::unique_ptr<FlowModel> closure_;  ///< none for base "dem"
    FlowModel* model_;
};

}  // namespace pendular
