#include "calib/study_model.h"

#include <utility>

#include "calib/calibration.h"
#include "calib/rumpf.h"

namespace pendular {

StudyModel::StudyModel(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers)
    : simulation_(std::make_unique<DirectSimulation>(study, conditions, fidelity, seed,
                                                     std::move(workers))),
      model_(simulation_.get()) {
    if (study.model.base == "rumpf") {
        closure_ = std::make_unique<RumpfModel>(*simulation_, study);
        model_ = closure_.get();
    }
    model_->predict_for(conditions);
}

StudyModel::StudyModel(const Study& study, const Calibration& calibration)
    : StudyModel(study, conditions_of(calibration.readings), calibration.fidelity, calibration.seed,
                 {}) {
    simulation_->restore(calibration.runs, calibration.surface_centre);
}

}  // namespace pendular
