#include "calib/fit/study_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "calib/fit/calibration.h"
#include "data/input_error.h"

namespace pendular {
namespace {

std::shared_ptr<const EmulatedSimulation> simulation_of(const Study& study, const Calibration& c) {
    const double stiffness_number =
        c.cold ? c.fidelity.stiffness_number : emulated::reference_stiffness;
    return std::make_shared<EmulatedSimulation>(
        study, c.fidelity, Emulator(c.runs, c.hyperparameters, stiffness_number));
}

}  // namespace

StudyModel::StudyModel(const ResolvedStudy& study,
                       std::shared_ptr<const EmulatedSimulation> simulation)
    : study_(study),
      simulation_(std::move(simulation)),
      model_(assemble_model(study, simulation_, study.effects())) {
    std::vector<const Effect*> of_flow = effects();
    std::erase_if(of_flow, [](const Effect* effect) { return effect->of_instrument(); });
    Study exact = study;
    exact.instrument = {};  // its errors are none of the flow
    flow_ = assemble_model(exact, simulation_, of_flow);
}

StudyModel::StudyModel(const ResolvedStudy& study, const Calibration& c)
    : StudyModel(study, simulation_of(study, c)) {}

ModelOfReadings StudyModel::at(const std::vector<Reading>& readings) const {
    return {model_, conditions_of(readings), direct()};
}

Eigen::VectorXd StudyModel::flow_parameters(const Eigen::VectorXd& parameters) const {
    const std::vector<Parameter>&all = model_->parameters(), &own = flow_->parameters();
    Eigen::VectorXd values(std::ssize(own));
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const std::string& name = own[static_cast<std::size_t>(k)].name;
        values(k) = parameters(std::ranges::find(all, name, &Parameter::name) - all.begin());
    }
    return values;
}

std::vector<EffectiveCondition> StudyModel::imposed(
    const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions) const {
    return flow_->imposed(flow_parameters(parameters), conditions);
}

void check_parameters(const Calibration& c, const EffectModel& model) {
    const ParameterBounds bounds = model.bounds();
    const bool same_names = std::ranges::equal(c.parameters, model.parameters(), {},
                                               &Parameter::name, &Parameter::name);
    // One range beyond either end is allowed: bounds of the friction grow with the runs.
    const auto inside = [&](Eigen::Index k) {
        const double width = bounds.upper(k) - bounds.lower(k);
        return std::abs(c.fit.parameters(k) - (bounds.lower(k) + bounds.upper(k)) / 2) <=
               1.5 * width;
    };
    bool all_inside = same_names;
    for (Eigen::Index k = 0; all_inside && k < bounds.lower.size(); ++k)
        all_inside = inside(k);
    if (!all_inside)
        throw InputError(
            "fit.json has other parameters than the model of the study, or values that no fit "
            "gives; "
            "run 'pendular calibrate' again");
}

}  // namespace pendular
