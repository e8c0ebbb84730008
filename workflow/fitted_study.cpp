#include "workflow/fitted_study.h"

#include <utility>

#include "calib/fit/measured.h"
#include "calib/fit/predicted_readings.h"

namespace pendular {

namespace {

/// Prediction of the readings that were not fitted, whose covariance contains the error of the fit.
Prediction predicted_part(const Calibration& c) {
    const auto rest = c.prediction.value.size() - 2 * static_cast<Eigen::Index>(c.fitted);
    const auto corner = [rest](const Eigen::MatrixXd& whole) -> Eigen::MatrixXd {
        return whole.size() > 0 ? whole.bottomRightCorner(rest, rest) : whole;
    };
    return {.value = c.prediction.value.tail(rest),
            .jacobian = Eigen::MatrixXd::Zero(rest, 1),  // nothing is fitted to them
            .covariance = corner(c.prediction.covariance),
            .run_noise = {},
            .discrepancy = corner(c.prediction.discrepancy)};
}

}  // namespace

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
    const auto seen = part(c.readings, 0, c.fitted);
    const Agreement of_fitted = agreement_of(
        seen, c.direct, fitted.model->at(seen).predict(c.fit.parameters), c.fit.at_bound,
        fitted.comparison.fitted, c.model, excess_of_errors(measurements));
    std::optional<Agreement> of_predicted;
    if (c.fitted < c.readings.size())
        of_predicted = agreement_of(part(c.readings, c.fitted, c.readings.size()), {},
                                    predicted_part(c), {}, fitted.comparison.predicted, c.model);
    return belief_in(c.fit, c.parameters, of_fitted, of_predicted, measurements, mistake);
}

WhereItFails where_it_fails(const FittedStudy& fitted, const Measurements& measurements) {
    const Calibration& c = fitted.calibration;
    // The prediction is without errors of the fitted parameters, which the checks project out.
    return where_it_fails(c.readings, measurements.scatter,
                          fitted.model->at(c.readings).predict(c.fit.parameters), c.parameters,
                          c.direct);
}

}  // namespace pendular
