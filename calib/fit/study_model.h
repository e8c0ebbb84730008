#pragma once

#include <memory>
#include <vector>

#include "calib/model/assemble_model.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

struct Calibration;

/// Model of a study, assembled from the emulated simulation, the base model (the simulation itself
/// or the formula `rumpf`) and the effects that the study lists. Copies are cheap, since they share
/// constant parts.
class StudyModel {
  public:
    /// Assembles the model of a study from its emulated simulation.
    StudyModel(const ResolvedStudy& study, std::shared_ptr<const EmulatedSimulation> simulation);
    /// Assembles the model of a finished calibration again, with an emulator trained on the
    /// calibration's runs.
    StudyModel(const ResolvedStudy& study, const Calibration& calibration);

    /// Model that predicts readings as the instrument shows them, with all effects of the study.
    const EffectModel& model() const { return *model_; }
    /// Returns model() as a shared pointer, which may outlive this object.
    std::shared_ptr<const EffectModel> predictor() const { return model_; }
    /// Emulated simulation that the base model and the effects use.
    const EmulatedSimulation& simulation() const { return *simulation_; }
    /// Model that predicts readings as an ideal instrument would show them: with all effects of the
    /// study except effects on the instrument.
    const EffectModel& flow() const { return *flow_; }
    /// Returns the model that predicts `readings` as the instrument shows them, followed by the
    /// study's direct measurements.
    ModelOfReadings at(const std::vector<Reading>& readings) const;
    /// Values of the parameters of flow(), taken from `parameters`, the values of the parameters of
    /// model().
    Eigen::VectorXd flow_parameters(const Eigen::VectorXd& parameters) const;
    /// Conditions truly imposed on the grains, as the study's effects on grains and liquid change
    /// them, where an ideal instrument (without effects on the instrument) shows `conditions`.
    /// @param parameters values of the parameters of model()
    std::vector<EffectiveCondition> imposed(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const;
    /// Physical effects that the study lists, in its order.
    const std::vector<const Effect*>& effects() const { return study_.effects(); }
    /// Direct measurements that the study states, each of one effect's parameter; the model
    /// predicts them too.
    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

  private:
    ResolvedStudy study_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const EffectModel> model_, flow_;
};

/// Checks a calibration, which may have been read from a file: its parameters must be those of
/// `model`, and no value may lie further outside its bounds than the bounds are apart.
/// @throws InputError if the calibration fails the check
void check_parameters(const Calibration& calibration, const EffectModel& model);

}  // namespace pendular
