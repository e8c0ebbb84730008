#pragma once

#include <memory>
#include <vector>

#include "calib/model/assemble_model.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

struct Calibration;

/// Model of a study: simulation, base and effects. It is a value; copies share constant parts.
class StudyModel {
  public:
    StudyModel(const ResolvedStudy& study, std::shared_ptr<const EmulatedSimulation> simulation);
    /// Model of a finished calibration, assembled again from its runs.
    StudyModel(const ResolvedStudy& study, const Calibration& calibration);

    /// Model of the readings as the instrument shows them, with all effects.
    const EffectModel& model() const { return *model_; }
    std::shared_ptr<const EffectModel> predictor() const { return model_; }
    const EmulatedSimulation& simulation() const { return *simulation_; }
    /// Model on an ideal instrument: with the study's effects on grains and liquid, without those
    /// on the instrument.
    const EffectModel& flow() const { return *flow_; }
    /// Model at readings, followed by the study's direct measurements.
    ModelOfReadings at(const std::vector<Reading>& readings) const;
    /// Values of the parameters of flow(), from values of those of model().
    Eigen::VectorXd flow_parameters(const Eigen::VectorXd& parameters) const;
    /// Conditions as the study's effects on grains and liquid make them at these values of the
    /// parameters of model(), where the instrument shows the truth.
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;
    /// Effects that the study lists, in its order.
    const std::vector<const Effect*>& effects() const { return study_.effects(); }
    /// Direct measurements of the study, which the model predicts too.
    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

  private:
    ResolvedStudy study_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const EffectModel> model_, flow_;
};

}  // namespace pendular
