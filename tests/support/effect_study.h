#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/closure_model.h"
#include "calib/model/effect_model.h"
#include "tests/support/emulator_support.h"

// A study like the virtual laboratory's. Its model is the emulator of the atlas.
namespace pendular {

/// Friction coefficient from which tests predict readings, and which fits must find again [1].
constexpr double planted_friction = 0.12;

/// Returns a study without readings: 500 um grains, a liquid and an annular cell.
/// @param base base model, "dem" (simulations) or "rumpf" (analytical formulas)
inline Study study_with(const std::string& base) {
    Study study;
    study.grains = {.diameter = 500e-6, .density = 1050};
    study.liquid = Liquid{.surface_tension = 20.6e-3};
    study.cell = AnnularCell{21e-3, 45e-3, 60e-3 / 1050};
    study.model.base = base;
    return study;
}

/// Returns conditions of readings: dry and wet, at two inertial numbers, normal stresses of 300 to
/// 3000 Pa and liquid contents of 0.004, 0.007 and 0.03. The times are 30 s apart.
inline std::vector<Condition> conditions() {
    std::vector<Condition> all;
    double time = 0;
    const auto add = [&](double stress, double number, double content) {
        Condition c{.normal_stress = stress, .inertial_number = number, .liquid_content = content};
        const AnnularCell cell = *study_with("dem").cell;
        c.bead_volume = cell.bead_volume;
        c.height = height(0.6, cell);
        c.time = time += 30;
        all.push_back(c);
    };
    for (const double number : {3e-3, 3e-2}) {
        for (const double stress : {300.0, 1000.0, 3000.0}) {
            add(stress, number, 0);
        }
        for (const double content : {0.004, 0.007, 0.03}) {
            for (const double stress : {300.0, 600.0, 1000.0, 3000.0}) {
                add(stress, number, content);
            }
        }
    }
    return all;
}

/// Returns the conditions at which a model with these effects is tested: those of `conditions()`.
/// If an effect acts on points of failure only, every other condition is a point of failure.
inline std::vector<Condition> conditions_for(const std::vector<const Effect*>& effects) {
    std::vector<Condition> all = conditions();
    const bool at_failure = std::ranges::any_of(
        effects, [](const Effect* effect) { return effect->touches == Touches::failure; });
    for (std::size_t k = 0; k < all.size(); k += 2)
        all[k].at_failure = at_failure;
    return all;
}

/// Models of one study with any set of effects, predicted by an emulator that is trained on all
/// runs of the atlas.
class Laboratory {
  public:
    explicit Laboratory(const std::string& base, closures::Level level = closures::Level::strength3)
        : study_(study_with(base)) {
        for (const Effect& effect : built_in_effects()) {
            study_.model.effects.push_back({effect.name, {}});  // their runs serve
        }
        const Fidelity quick = fidelity_named("quick");
        KnownRuns known{runs_serving(study_, quick, all_shipped_runs()), shipped_hyperparameters(),
                        false};
        const auto simulation = std::make_shared<EmulatedSimulation>(
            study_, quick, Emulator(known.runs, std::move(known.hyperparameters)));
        inside_ = simulation;
        if (base == "rumpf") {
            inside_ = std::make_shared<ClosureModel>(simulation, study_, level);
        }
    }
    /// Returns a model that predicts the readings of the instrument with these effects.
    EffectModel predictor(std::vector<const Effect*> effects) const {
        return {inside_, study_, std::move(effects)};
    }
    /// Returns the model with these effects for the readings at `conditions_for(effects)`.
    ModelOfReadings with(std::vector<const Effect*> effects) const {
        const auto at = conditions_for(effects);
        return {std::make_shared<EffectModel>(predictor(std::move(effects))), at};
    }

  private:
    Study study_;
    std::shared_ptr<const FlowPredictor> inside_;  ///< model of the true flow without effects
};

/// Whether the emulator of the atlas can predict an effect. An effect on grains can be predicted if
/// the atlas has runs with this effect alone; every other effect can.
inline bool predictable(const Effect& effect) {
    static const std::vector<dem::RunResult> runs = all_shipped_runs();
    return !effect.of_grains() || std::ranges::any_of(runs, [&](const dem::RunResult& run) {
        const auto& effects = run.parameters.effects;
        return effects.size() == 1 && effects[0].effect == effect.name;
    });
}

/// Returns the laboratory with base model "dem" that all tests of a process share.
inline Laboratory& laboratory() {
    static Laboratory shared("dem");
    return shared;
}

}  // namespace pendular
