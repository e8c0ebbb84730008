#include "calib/study_model.h"

#include <fmt/format.h>

#include <utility>

#include "calib/calibration.h"
#include "calib/rumpf.h"

namespace pendular {

namespace {

/// @throws InputError where the study has effects, which no model here knows
void refuse_effects(const ModelChoice& model) {
    if (!model.effects.empty()) {
        throw InputError(model.effects.front().position,
                         fmt::format("the model cannot take '{}' in yet; write effects = []",
                                     model.effects.front().name));
    }
}

}  // namespace

StudyModel::StudyModel(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers,
                       const std::optional<KnownRuns>& known) {
    refuse_effects(study.model);
    if (known) {
        auto emulated = std::make_unique<EmulatedSimulation>(study, conditions, fidelity, seed,
                                                             std::move(workers), *known);
        emulated_ = emulated.get();
        simulation_ = std::move(emulated);
    } else {
        auto direct = std::make_unique<DirectSimulation>(study, conditions, fidelity, seed,
                                                         std::move(workers));
        direct_ = direct.get();
        simulation_ = std::move(direct);
    }
    model_ = simulation_.get();
    if (study.model.base == "rumpf") {
        closure_ = std::make_unique<RumpfModel>(*simulation_, study);
        model_ = closure_.get();
    }
    model_->predict_for(conditions);
}

StudyModel::StudyModel(const Study& study, const Calibration& c)
    : StudyModel(study, conditions_of(c.readings), c.fidelity, c.seed, {},
                 c.scales ? std::optional(KnownRuns{c.runs, *c.scales, false}) : std::nullopt) {
    if (direct_) {
        direct_->restore(c.runs, c.surface_centre);
    }
}

void StudyModel::note_in(Calibration& c) const {
    if (direct_) {
        c.surface_centre = direct_->centre();
    } else {
        c.scales = emulated_->emulator().scales();
        c.orders = emulated_->orders();
    }
}

}  // namespace pendular
