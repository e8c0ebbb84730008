#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "calib/emulator/known_range.h"
#include "calib/emulator/known_runs.h"
#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "calib/model/model.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/closures/level.h"

namespace pendular {

/// Returns the model of a study's readings: `simulation`, with the formula of `level_with` for the
/// stress ratio of wet grains, and with `effects`.
/// @param effects in the order of their parameters; must outlive the model
/// @throws InputError if the level is `closures::Level::mohr_coulomb` but the study has no wet
///         reading of steady shear at a reduced pressure of at least 2.3
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Returns the formula (or the simulation) for the stress ratio of wet grains: the highest level of
/// the study's base model and of the effects that replace approximations.
closures::Level level_with(const Study& study, const std::vector<const Effect*>& effects);

/// Effect that is neither in the study's model nor a candidate for addition to it.
struct UntestableEffect {
    std::string effect, why;
    /// Whether the effect applies to the study and cannot be tested only because no earlier
    /// simulation has the effect as its only effect.
    bool without_runs = false;
};

/// Set of all models of a study: the model with the effects that the study lists, and each model
/// with candidates in addition: all further effects that apply to the study and that the emulator
/// can predict. All models use one emulator, trained on earlier runs only.
class StudyModelSpace : public ModelSpace {
  public:
    /// Trains the emulator on earlier runs and finds the candidates.
    /// @param conditions conditions of the readings that the models predict
    /// @param known training runs, without effects and with effects on grains
    /// @throws InputError if the study lists or directly measures an effect on grains, such as
    ///         rolling resistance, that no earlier run has as its only effect
    /// @throws std::invalid_argument if none of the earlier runs can serve as a training run
    StudyModelSpace(const ResolvedStudy& study, std::vector<Condition> conditions,
                    const Fidelity& fidelity, KnownRuns known);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    /// Returns the predictor, at any conditions, of the study's model with the candidates `chosen`.
    std::shared_ptr<const EffectModel> predictor(const EffectSet& chosen) const;
    /// Returns the predictor, at any conditions, of the study's model with the effects named
    /// `effects` in place of those that the study lists.
    /// @throws std::invalid_argument if the catalogue has no effect with one of the names, or if
    ///         one of the effects acts on grains and no earlier run has only this effect
    std::shared_ptr<const EffectModel> with_only(const std::vector<std::string>& effects) const;
    /// Returns with_only() of the listed effects without `removed` and with `added`.
    std::shared_ptr<const EffectModel> exchanged(const std::string& removed,
                                                 const std::vector<std::string>& added) const;
    /// Returns a copy with the effects `more` as further candidates, after the present ones. They
    /// must not act on grains inside a simulation and must outlive the copy.
    StudyModelSpace offering(const std::vector<Effect>& more) const;
    /// Returns a copy whose models are expected to err by `discrepancy`: relative standard errors
    /// [1] of stress ratio and solid fraction.
    StudyModelSpace with_discrepancy(const std::array<double, 2>& discrepancy) const;
    int internally_fitted_values() const override;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, const Eigen::VectorXd& values) const override;

    /// Returns the predictor of dry and wet grains on which all models are based.
    const EmulatedSimulation& simulation() const { return *simulation_; }

    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

    /// Returns the effects that cannot be tested as missing from the model, each with the reason.
    const std::vector<UntestableEffect>& untestable_effects() const { return untestable_effects_; }

    /// Returns why the training runs do not support predictions of the study's readings by the
    /// model without effects, such as "reduced pressure 0.3 is below 0.5" (`KnownRange`), each
    /// reason once; empty if the runs support all predictions.
    /// @param friction friction coefficient of the grains [1]
    std::vector<std::string> why_unsupported(double friction) const;
    /// Returns the reason for one condition; empty if the runs support its prediction.
    /// @param friction friction coefficient of the grains [1]
    std::string why_unsupported(double friction, const Condition& condition) const;

    /// Returns a copy of the study whose model lists all effects of its catalogue, so that
    /// `runs_serving` accepts training runs with any of them.
    static Study with_all_effects(const ResolvedStudy& study);

  private:
    /// Whether runs suffice to predict an effect: one on grains needs a run with only this effect.
    bool has_runs(const Effect& effect) const;
    /// Adds an effect to the candidates or, with the reason, to `untestable_effects_`.
    void add_candidate(const Effect& effect);
    /// Whether side walls or a creeping gap suggest that the bed is not sheared throughout.
    bool bed_may_be_uneven() const;

    ResolvedStudy study_;
    std::vector<Condition> conditions_;
    std::vector<const Effect*> offered_;  ///< of each candidate
    std::vector<Candidate> candidates_;
    std::vector<UntestableEffect> untestable_effects_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const KnownRange> known_range_;
};

}  // namespace pendular
