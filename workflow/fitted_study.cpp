#include "workflow/fitted_study.h"

#include <utility>

#include "calib/fit/predicted_readings.h"

namespace pendular {

FittedStudy fitted(const ResolvedStudy& study, Calibration c) {
    FittedStudy result{.calibration = std::move(c)};
    Calibration& own = result.calibration;
    const EffectModel& model = result.model.emplace(study, own).model();
    check_parameters(own, model);
    if (own.prediction.value.size() == 0) own.prediction = predict_readings(model, own);
    result.comparison = compare(own);
    return result;
}

void cross_validate(FittedStudy& fitted, bool refits) {
    const auto left_out =
        refits ? left_out_errors(fitted.model->predictor(), fitted.calibration) : std::nullopt;
    fitted.ladder_step = ladder_step_of(fitted.calibration, fitted.comparison, left_out);
    fitted.left_out = left_out.value_or(LeftOut{});
}

Belief belief_in(const FittedStudy& fitted, const ResolvedStudy& study,
                 const Measurements& measurements) {
    const Calibration& c = fitted.calibration;
    const auto mistake =
        find_unit_mistake(fitted.model->model(), c.readings, study, c.fit.parameters);
    return belief_in(c.fit, c.parameters, fitted.comparison.fitted, measurements, mistake);
}

WhereItFails where_it_fails(const FittedStudy& fitted, const Measurements& measurements) {
    const Calibration& c = fitted.calibration;
    // The prediction is without errors of the fitted parameters, which the checks project out.
    return where_it_fails(c.readings, measurements.scatter,
                          fitted.model->at(c.readings).predict(c.fit.parameters), c.parameters,
                          c.direct);
}

}  // namespace pendular
