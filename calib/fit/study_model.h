#pragma once

#include <memory>
#include <vector>

#include "calib/model/assemble_model.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

struct Calibration;

/// Model that predicts the readings of a study. The model contains the emulated simulation
/// (interpolation between simulation runs), the base model for wet grains (the simulation or a
/// formula) and the effects that the study lists. Copies are cheap, since all copies share their
/// constant parts.
class StudyModel {
  public:
    /// Assembles the model of a study from the emulated simulation of the study's grains.
    /// @throws InputError if base = "mohr-coulomb" and the study has no wet reading to which a
    ///         cohesion could be fitted
    StudyModel(const ResolvedStudy& study, std::shared_ptr<const EmulatedSimulation> simulation);
    /// Assembles the model of a finished calibration again, with an emulator trained on the runs of
    /// the calibration.
    /// @throws std::invalid_argument if none of the runs of the calibration can serve as a training
    ///         run
    StudyModel(const ResolvedStudy& study, const Calibration& calibration);

    /// Returns the predictor of readings as the instrument shows them, with all effects of the
    /// study.
    const EffectModel& model() const { return *model_; }
    /// Returns the predictor of readings, model(), as a shared pointer, which may outlive the
    /// `StudyModel`.
    std::shared_ptr<const EffectModel> predictor() const { return model_; }
    /// Returns the emulated simulation (interpolation between simulation runs) that the base model
    /// for wet grains and the effects use.
    const EmulatedSimulation& simulation() const { return *simulation_; }
    /// Returns the predictor of readings as an ideal instrument would show them, with all effects
    /// of the study except effects on the instrument.
    const EffectModel& flow() const { return *flow_; }
    /// Returns the model that predicts first `readings` as the instrument shows them, then the
    /// direct measurements of the study.
    ModelOfReadings at(const std::vector<Reading>& readings) const;
    /// Returns the values of the parameters of flow(), the predictor for an ideal instrument.
    /// @param parameters values of all parameters of model(), including the parameters of effects
    ///        on the instrument
    Eigen::VectorXd flow_parameters(const Eigen::VectorXd& parameters) const;
    /// Returns the conditions (normal stress, inertial number and liquid content) truly imposed on
    /// the grains, in the order of `conditions`. The result includes the properties of grains and
    /// liquid as the study's effects change the properties.
    /// @param parameters values of the parameters of model()
    /// @param conditions conditions that an ideal instrument, without effects on the instrument,
    ///        shows
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;
    /// Returns the physical effects that the study lists, in the order of the study.
    const std::vector<const Effect*>& effects() const { return study_.effects(); }
    /// Returns the direct measurements of effects' parameters that the study states. The model
    /// predicts the direct measurements after the readings.
    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

  private:
    ResolvedStudy study_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const EffectModel> model_, flow_;
};

/// Checks that a calibration, which may have been read from a file, belongs to the model `model`.
/// The parameters of the calibration must have the names of the parameters of `model`. No parameter
/// value may lie outside the bounds of the parameter by more than the distance between the bounds.
/// @throws InputError if the calibration does not pass the check
void check_parameters(const Calibration& calibration, const EffectModel& model);

}  // namespace pendular
