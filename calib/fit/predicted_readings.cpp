#include "calib/fit/predicted_readings.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "calib/fit/measured.h"
#include "data/input_error.h"

namespace pendular {
UnseenAndFitted predict_with_fitted(const Predictor& model, const Calibration& c,
                                    const std::vector<Condition>& conditions) {
    const auto seen = part(c.readings, 0, c.fitted);
    std::vector<Condition> all = conditions_of(seen);
    all.insert(all.end(), conditions.begin(), conditions.end());
    const Prediction p = predict_with_direct(model, c.fit.parameters, all, c.direct);
    const auto n = 2 * static_cast<Eigen::Index>(c.fitted);
    const Eigen::Index direct = std::ssize(c.direct), rest = p.value.size() - n - direct;
    // Fitted readings and direct measurements, then what the fit did not use.
    std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    for (Eigen::Index k = 0; k < direct + rest; ++k)
        order.push_back(k < direct ? n + rest + k : n + k - direct);
    const Eigen::VectorXd value = p.value(order);
    const Eigen::MatrixXd jacobian = p.jacobian(order, Eigen::all);
    const Eigen::MatrixXd covariance = p.covariance(order, order);
    const Eigen::Index known = n + direct;
    const Eigen::MatrixXd measured = stack(seen, c.direct).covariance;
    const Eigen::MatrixXd weight = (measured + covariance.topLeftCorner(known, known)).inverse();
    // theta = K (y - f) + ..., so that errors e of what was fitted and d of all predictions make
    // an error J K (e - d_fitted) + d_unseen.
    const Eigen::MatrixXd through_fit =
        jacobian.bottomRows(rest) * c.fit.covariance * jacobian.topRows(known).transpose() * weight;
    Eigen::MatrixXd map(rest, known + rest);
    map << -through_fit, Eigen::MatrixXd::Identity(rest, rest);
    const auto mapped = [&](const Eigen::MatrixXd& errors) {
        return Eigen::MatrixXd(map * errors * map.transpose());
    };
    return {.unseen = {.value = value.tail(rest),
                       .jacobian = jacobian.bottomRows(rest),
                       .covariance =
                           mapped(covariance) + through_fit * measured * through_fit.transpose(),
                       .run_noise = p.run_noise.block(n, n, rest, rest),
                       .discrepancy = p.discrepancy.size() > 0 ? mapped(p.discrepancy(order, order))
                                                               : p.discrepancy},
            .with_fitted = (through_fit * measured).leftCols(n)};
}

Prediction predict_unseen(const Predictor& model, const Calibration& c,
                          const std::vector<Condition>& conditions) {
    Prediction unseen = predict_with_fitted(model, c, conditions).unseen;
    if (unseen.discrepancy.size() > 0)
        unseen.covariance += (std::pow(c.fit.inexactness, 2) - 1) * unseen.discrepancy;
    return unseen;
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
    // With the expected discrepancy, as the fitted readings have it.
    const Prediction unseen =
        predict_with_fitted(model, c, conditions_of(part(c.readings, c.fitted, c.readings.size())))
            .unseen;
    all.covariance.bottomRightCorner(rest, rest) = unseen.covariance;
    if (all.discrepancy.size() > 0) {
        all.discrepancy.topRightCorner(fitted, rest).setZero();
        all.discrepancy.bottomLeftCorner(rest, fitted).setZero();
        all.discrepancy.bottomRightCorner(rest, rest) = unseen.discrepancy;
    }
    return all;
}

namespace {

bool is_steady(const Reading& reading) {
    return !reading.condition.at_failure;
}

/// Inertial number of the wet readings if they agree, otherwise 0 (quasi-static limit) [1].
double shared_inertial_number(const std::vector<Reading>& readings) {
    double sum = 0, first = -1;
    int count = 0;
    for (const Reading& reading : readings) {
        if (!is_steady(reading) || reading.condition.dry()) continue;
        const double own = reading.condition.inertial_number;
        if (first < 0) first = own;
        if (!agree(first, own, inertial_number_tolerance)) return 0;
        sum += own, ++count;
    }
    return count > 0 ? sum / count : 0;
}

/// Lowest inertial number of the wet readings [1].
double lowest_inertial_number(const std::vector<Reading>& readings) {
    double lowest = INFINITY;
    for (const Reading& reading : readings) {
        if (is_steady(reading) && !reading.condition.dry())
            lowest = std::min(lowest, reading.condition.inertial_number);
    }
    return lowest;
}

/// Whether the steady wet readings have the inertial number `common`, within the tolerance of a set
/// point.
bool wet_readings_have(const std::vector<Reading>& readings, double common) {
    return std::ranges::all_of(readings, [common](const Reading& reading) {
        return !is_steady(reading) || reading.condition.dry() ||
               agree(reading.condition.inertial_number, common, inertial_number_tolerance);
    });
}

/// Indices of the readings that are to be moved to the inertial number `common`. If all steady wet
/// readings have it as their set point, readings that scatter about it stay where they are.
/// Otherwise all are moved: a reading 20 % off would bias the line through readings that were. All
/// are moved, too, where effects of the instrument change what it shows.
std::vector<std::size_t> readings_to_move(const std::vector<Reading>& readings, double common,
                                          const Predictor& model) {
    const double tolerance = wet_readings_have(readings, common) ? inertial_number_tolerance : 0;
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (model.has_instrument() ||
            !agree(readings[k].condition.inertial_number, common, tolerance))
            result.push_back(k);
    }
    return result;
}

/// Rows of the two values of the readings with the indices `which`, whose first entry is `from`.
std::vector<Eigen::Index> rows_of(const std::vector<std::size_t>& which, Eigen::Index from = 0) {
    std::vector<Eigen::Index> rows;
    for (const std::size_t k : which) {
        const Eigen::Index row = from + 2 * static_cast<Eigen::Index>(k);
        rows.insert(rows.end(), {row, row + 1});
    }
    return rows;
}

}  // namespace

namespace {

/// The readings as they were recorded.
ReadingsAtOneRate as_recorded(double inertial_number, const Calibration& c) {
    const Measured measured = stack(c.readings);
    return {.inertial_number = inertial_number,
            .readings = c.readings,
            .moved = std::vector<bool>(c.readings.size(), false),
            .measured = {"measured", measured.value, measured.covariance + measured.widening,
                         measured.covariance},
            .predicted = c.prediction};
}

ReadingsAtOneRate moved_to(double inertial_number, const Predictor& model, const Calibration& c) {
    ReadingsAtOneRate result = as_recorded(inertial_number, c);
    result.ideal_instrument = model.has_instrument();
    const auto moved = readings_to_move(c.readings, result.inertial_number, model);
    if (moved.empty()) return result;

    std::vector<Condition> conditions;  // as recorded, those that move; then all, as moved
    for (const std::size_t k : moved) {
        conditions.push_back(c.readings[k].condition);
        result.readings[k].condition.inertial_number = result.inertial_number;
        result.readings[k].condition.ideal_instrument = result.ideal_instrument;
        result.moved[k] = true;
    }
    for (const Reading& reading : result.readings)
        conditions.push_back(reading.condition);
    const auto [both, with_fitted] = predict_with_fitted(model, c, conditions);
    const auto recorded = 2 * std::ssize(moved), all = both.value.size() - recorded;
    result.predicted = {.value = both.value.tail(all),
                        .jacobian = both.jacobian.bottomRows(all),
                        .covariance = both.covariance.bottomRightCorner(all, all),
                        .run_noise = both.run_noise.bottomRightCorner(all, all)};

    // The shift is a difference of rows of one prediction, whose common errors cancel.
    const auto at = rows_of(moved), there = rows_of(moved, recorded);
    const Eigen::VectorXd shift = both.value.head(recorded) - both.value(there);
    const Eigen::MatrixXd cross = both.covariance(Eigen::seqN(0, recorded), there);
    const Eigen::MatrixXd error = both.covariance.topLeftCorner(recorded, recorded) +
                                  both.covariance(there, there) - cross - cross.transpose();
    result.measured.value(at) -= shift;
    const auto own = [&result](std::size_t k) {
        const auto row = 2 * static_cast<Eigen::Index>(k);
        return Eigen::Matrix2d(result.measured.covariance.block<2, 2>(row, row));
    };
    for (const std::size_t k : moved)
        result.readings[k].covariance -= own(k);
    result.measured.covariance(at, at) += error;
    result.measured.weighting(at, at) += error;
    // The parameters, and with them the shift, follow the errors of the fitted readings.
    // The weights do not know it: with few errors of the model, this covariance is nearly singular.
    const Eigen::MatrixXd follows = with_fitted.topRows(recorded) - with_fitted(there, Eigen::all);
    const auto fitted = Eigen::seqN(0, follows.cols());
    result.measured.covariance(at, fitted) -= follows;
    result.measured.covariance(fitted, at) -= follows.transpose();
    for (const std::size_t k : moved) {
        result.readings[k].covariance += own(k);
        result.readings[k].value =
            result.measured.value.segment<2>(2 * static_cast<Eigen::Index>(k));
    }
    return result;
}

}  // namespace

ReadingsAtOneRate at_one_inertial_number(const Predictor& model, const Calibration& c) {
    if (c.cohesion.inertial_number) return moved_to(*c.cohesion.inertial_number, model, c);
    const double shared = shared_inertial_number(c.readings);
    if (shared > 0) return moved_to(shared, model, c);
    try {
        return moved_to(0, model, c);
    } catch (const InputError&) {
        // A formula of the study has no limit, such as the logarithm of the inertial number.
    } catch (const std::domain_error&) {
        // An effect of the instrument has no limit.
    }
    const double lowest = lowest_inertial_number(c.readings);
    return std::isfinite(lowest) ? moved_to(lowest, model, c) : as_recorded(0, c);
}

}  // namespace pendular
