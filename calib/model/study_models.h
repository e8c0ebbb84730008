#pragma once

#include <memory>
#include <string>
#include <vector>

#include "calib/emulator/known_range.h"
#include "calib/emulator/known_runs.h"
#include "calib/model/assemble_model.h"
#include "calib/model/model_space.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Physical effect that the program cannot test as missing from a study's model: name of the effect
/// (`effect`) and reason for the user (`why`). The effect is neither in the study's model nor a
/// candidate for addition to the model.
struct UntestableEffect {
    std::string effect, why;
    /// Whether the effect applies to the study and cannot be tested only because no earlier
    /// simulation has the effect as its only effect.
    bool without_runs = false;
};

/// Set of all models of a study: the model with the effects that the study lists, and each model
/// that also has one or more of the candidates for addition. The candidates are all further effects
/// that apply to the study and that the emulator can predict. All models use one emulator (Gaussian
/// processes trained on earlier runs). No new runs are simulated.
class StudyModels : public ModelSpace {
  public:
    /// Trains the emulator on earlier simulation runs and finds the candidates for addition to the
    /// study's model.
    /// @param conditions conditions of the readings that the models predict
    /// @param known training runs of the emulator, without effects and with effects on grains
    /// @throws InputError if the study lists or directly measures an effect on grains, such as
    ///         rolling resistance, that no earlier run has as its only effect
    /// @throws std::invalid_argument if none of the earlier runs can serve as a training run
    StudyModels(const ResolvedStudy& study, std::vector<Condition> conditions,
                const Fidelity& fidelity, KnownRuns known);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    /// Returns the study's model with the candidates `chosen` (indices into candidates()) added.
    /// The returned predictor can predict readings at any conditions.
    std::shared_ptr<const EffectModel> predictor(const EffectSet& chosen) const;
    /// Returns the study's model with the effects named `effects` in place of the effects that the
    /// study lists. The returned predictor can predict readings at any conditions.
    /// @throws std::invalid_argument if the catalogue has no effect with one of the names, or if
    ///         one of the effects acts on grains and no earlier run has only this effect
    std::shared_ptr<const EffectModel> with_only(const std::vector<std::string>& effects) const;
    /// Returns the study's model with the effects named `added` in place of the listed effect
    /// `removed`. The returned predictor can predict readings at any conditions.
    /// @throws std::invalid_argument if the catalogue has no effect with one of the names, or if
    ///         one of the effects acts on grains and no earlier run has only this effect
    std::shared_ptr<const EffectModel> exchanged(const std::string& removed,
                                                 const std::vector<std::string>& added) const;
    /// Returns a copy of the set of models with the effects `more` as further candidates, after the
    /// present candidates. The effects must not act on grains inside a simulation and must outlive
    /// the copy.
    StudyModels offering(const std::vector<Effect>& more) const;
    int internally_fitted_values() const override;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, double value) const override;

    /// Returns the predictor of dry and wet grains on which all models are based. The predictor
    /// uses an emulator (Gaussian processes trained on simulations).
    const EmulatedSimulation& simulation() const { return *simulation_; }

    /// Returns the direct measurements of effects' parameters (made without shearing grains) that
    /// the study states. The models predict the measured parameters after the readings.
    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

    /// Returns the physical effects that the study does not list and that cannot be tested as
    /// missing from the model, each with the reason.
    const std::vector<UntestableEffect>& untestable_effects() const { return untestable_effects_; }

    /// Returns the reasons why the training runs of the emulator do not support predictions of the
    /// study's readings by the model without effects, such as "reduced pressure 0.3 is below 0.5"
    /// (`KnownRange`). Each reason occurs once. The list is empty if the runs support all
    /// predictions.
    /// @param friction friction coefficient of the grains [1]
    std::vector<std::string> why_unsupported(double friction) const;
    /// Returns the reason why the training runs of the emulator do not support a prediction at a
    /// condition by the model without effects. The text is empty if the runs support the
    /// prediction.
    /// @param friction friction coefficient of the grains [1]
    std::string why_unsupported(double friction, const Condition& condition) const;

    /// Returns a copy of the study whose model lists all effects of the study's catalogue. For the
    /// returned study, `runs_serving` accepts training runs with any effect of the catalogue.
    static Study with_all_effects(const ResolvedStudy& study);

  private:
    /// Whether the emulator's training runs suffice to predict an effect. For an effect on grains,
    /// at least one run must have only this effect. All other effects need no runs.
    bool has_runs(const Effect& effect) const;
    /// Adds an effect to the candidates for addition to the model. If the effect cannot be tested,
    /// the function adds the effect to `untestable_effects_` instead, with the reason.
    void add_candidate(const Effect& effect);

    ResolvedStudy study_;
    std::vector<Condition> conditions_;
    /// Physical effect of each candidate, in the order of candidates().
    std::vector<const Effect*> offered_;
    std::vector<Candidate> candidates_;
    std::vector<UntestableEffect> untestable_effects_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const KnownRange> known_range_;
};

}  // namespace pendular
