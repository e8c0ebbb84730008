#include "calib/fit/predicted_readings.h"

#include <Eigen/Dense>

#include "calib/fit/reading_order.h"

namespace pendular {
namespace {

/// Fisher information of direct measurements on the parameters: J' Sigma^-1 J.
Eigen::MatrixXd information_of(const std::vector<DirectMeasurement>& direct,
                               const std::vector<Parameter>& parameters) {
    const auto count = static_cast<Eigen::Index>(parameters.size());
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
    for (const DirectMeasurement& each : direct) {
        if (const auto place = place_of(each, parameters)) {
            information(*place, *place) += 1 / (each.standard_error * each.standard_error);
        }
    }
    return information;
}

}  // namespace

UnseenAndFitted predict_with_fitted(const Predictor& model, const Calibration& c,
                                    const std::vector<Condition>& conditions) {
    const auto seen = part(c.readings, 0, c.fitted);
    std::vector<Condition> all = conditions_of(seen);
    all.insert(all.end(), conditions.begin(), conditions.end());
    const Prediction both = model.predict(c.fit.parameters, all);
    const auto n = 2 * static_cast<Eigen::Index>(c.fitted);
    const Eigen::Index rest = both.value.size() - n;
    const Eigen::MatrixXd measured = stack(seen).covariance;
    const Eigen::MatrixXd weight = (measured + both.covariance.topLeftCorner(n, n)).inverse();
    // theta = K (y - f) + ..., so that errors e of the seen readings and d of all predictions make
    // an error J K (e - d_seen) + d_unseen.
    const Eigen::MatrixXd slopes = both.jacobian.bottomRows(rest) * c.fit.covariance;
    const Eigen::MatrixXd through_fit = slopes * both.jacobian.topRows(n).transpose() * weight;
    // Errors of the direct measurements come through the fit too.
    const Eigen::MatrixXd direct = information_of(c.direct, model.parameters());
    Eigen::MatrixXd map(rest, n + rest);
    map << -through_fit, Eigen::MatrixXd::Identity(rest, rest);
    return {
        .unseen = {.value = both.value.tail(rest),
                   .jacobian = both.jacobian.bottomRows(rest),
                   .covariance = map * both.covariance * map.transpose() +
                                 through_fit * measured * through_fit.transpose() +
                                 slopes * direct * slopes.transpose(),
                   .run_noise = both.run_noise.bottomRightCorner(rest, rest),
                   .discrepancy = both.discrepancy.size() > 0
                                      ? Eigen::MatrixXd(map * both.discrepancy * map.transpose())
                                      : both.discrepancy},
        .with_fitted = through_fit * measured};
}

Prediction predict_unseen(const Predictor& model, const Calibration& c,
                          const std::vector<Condition>& conditions) {
    return predict_with_fitted(model, c, conditions).unseen;
}

Prediction predict_readings(const Predictor& model, const Calibration& c) {
    Prediction all = model.predict(c.fit.parameters, conditions_of(c.readings));
    if (c.fitted == c.readings.size()) {
        return all;
    }
    const auto fitted = 2 * static_cast<Eigen::Index>(c.fitted);
    const Eigen::Index rest = all.value.size() - fitted;
    all.covariance.topRightCorner(fitted, rest).setZero();
    all.covariance.bottomLeftCorner(rest, fitted).setZero();
    const Prediction unseen =
        predict_unseen(model, c, conditions_of(part(c.readings, c.fitted, c.readings.size())));
    all.covariance.bottomRightCorner(rest, rest) = unseen.covariance;
    if (all.discrepancy.size() > 0) {
        all.discrepancy.topRightCorner(fitted, rest).setZero();
        all.discrepancy.bottomLeftCorner(rest, fitted).setZero();
        all.discrepancy.bottomRightCorner(rest, rest) = unseen.discrepancy;
    }
    return all;
}

}  // namespace pendular
