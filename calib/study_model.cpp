#include "calib/study_model.h"

#include <utility>

#include "calib/calibration.h"
#include "calib/effect_model.h"
#include "calib/rumpf.h"

namespace pendular {

StudyModel::StudyModel(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers,
                       const std::optional<KnownRuns>& known) {
    catalogue_ = std::make_unique<EffectCatalogue>(study);
    const std::vector<const Effect*> effects = catalogue_->active(study);
    if (known) {
        auto emulated = std::make_unique<EmulatedSimulation>(study, conditions, fidelity, seed,
                                                             std::move(workers), *known);
        emulated_ = emulated.get();
        simulation_ = std::move(emulated);
    } else {
        auto direct = std::make_unique<DirectSimulation>(study, conditions, fidelity, seed,
                                                         std::move(workers));
        simulated_ = direct.get();
        simulation_ = std::move(direct);
    }
    model_ = simulation_.get();
    if (study.model.base == "rumpf") {
        closure_ = std::make_unique<RumpfModel>(*simulation_, study, terms_of(effects));
        model_ = closure_.get();
    }
    if (!effects.empty()) {
        with_effects_ = std::make_unique<EffectModel>(*model_, study, effects);
        model_ = with_effects_.get();
    }
    direct_ = direct_measurements(study, *catalogue_);
    model_->predict_for(conditions);
    model_->predict_direct(direct_);
}

StudyModel::StudyModel(const Study& study, const Calibration& c)
    : StudyModel(study, conditions_of(c.readings), c.fidelity, c.seed, {},
                 c.scales ? std::optional(KnownRuns{c.runs, *c.scales, false}) : std::nullopt) {
    if (simulated_) {
        simulated_->restore(c.runs, c.surface_centre);
    }
}

void StudyModel::note_in(Calibration& c) const {
    if (simulated_) {
        c.surface_centre = simulated_->centre();
    } else {
        c.scales = emulated_->emulator().scales();
        c.orders = emulated_->orders();
    }
}

}  // namespace pendular
