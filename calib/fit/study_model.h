#pragma once

#include <memory>
#include <vector>

#include "calib/model/predictor.h"
#include "calib/model/study_model_space.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

struct Calibration;

/// Model that predicts the readings of a study: the emulated simulation, the base model for wet
/// grains (the simulation or a formula) and the effects that the study lists. Copies are cheap,
/// since all copies share their constant parts.
class StudyModel {
  public:
    /// Assembles the model of a study from the emulated simulation of the study's grains.
    /// @throws InputError if base = "mohr-coulomb" and the study has no wet reading to which a
    ///         cohesion could be fitted
    StudyModel(const ResolvedStudy& study, std::shared_ptr<const EmulatedSimulation> simulation);
    /// Assembles the model of a finished calibration again, with an emulator trained on its runs.
    /// @throws std::invalid_argument if none of the runs can serve as a training run
    StudyModel(const ResolvedStudy& study, const Calibration& calibration);

    /// Returns the predictor of readings as the instrument shows them, with all effects.
    const EffectModel& model() const { return *model_; }
    /// Returns model() as a shared pointer, which may outlive the `StudyModel`.
    std::shared_ptr<const EffectModel> predictor() const { return model_; }
    const EmulatedSimulation& simulation() const { return *simulation_; }
    /// Returns the predictor for an ideal instrument, without the effects on the instrument.
    const EffectModel& flow() const { return *flow_; }
    /// Returns the model of `readings` as the instrument shows them and of the direct measurements.
    ModelOfReadings at(const std::vector<Reading>& readings) const;
    /// Returns the values of the parameters of flow() among those of model().
    Eigen::VectorXd flow_parameters(const Eigen::VectorXd& parameters) const;
    /// Returns the conditions truly imposed, with the changes of grains and liquid by effects,
    /// where an ideal instrument shows `conditions`.
    /// @param parameters values of the parameters of model()
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;
    const std::vector<const Effect*>& effects() const { return study_.effects(); }
    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

  private:
    ResolvedStudy study_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const EffectModel> model_, flow_;
};

/// Checks that a calibration, perhaps read from a file, belongs to `model`: its parameters have the
/// same names, and no value lies outside the bounds by more than the distance between them.
/// @throws InputError if it does not
void check_parameters(const Calibration& calibration, const EffectModel& model);

}  // namespace pendular
