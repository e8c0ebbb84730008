#include "calib/fit/common_inertial_number.h"

#include <Eigen/Dense>

#include "calib/fit/predicted_readings.h"
#include "calib/fit/wet_groups.h"

namespace pendular {
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

/// Indices of the readings that are to be moved to the inertial number `common`.
std::vector<std::size_t> readings_to_move(const std::vector<Reading>& readings, double common) {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (!agree(readings[k].condition.inertial_number, common, inertial_number_tolerance)) {
            result.push_back(k);
        }
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

ReadingsAtOneRate at_one_inertial_number(const Predictor& model, const Calibration& c) {
    ReadingsAtOneRate result{
        .inertial_number = c.cohesion.inertial_number.value_or(shared_inertial_number(c.readings)),
        .readings = c.readings,
        .moved = std::vector<bool>(c.readings.size(), false),
        .measured = stack(c.readings),
        .predicted = c.prediction};
    const auto moved = readings_to_move(c.readings, result.inertial_number);
    if (moved.empty()) return result;

    std::vector<Condition> conditions;  // as recorded, those that move; then all, as moved
    for (const std::size_t k : moved) {
        conditions.push_back(c.readings[k].condition);
        result.readings[k].condition.inertial_number = result.inertial_number;
        result.moved[k] = true;
    }
    for (const Reading& reading : result.readings)
        conditions.push_back(reading.condition);
    const Prediction both = predict_unseen(model, c, conditions);
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
    result.measured.covariance(at, at) += error;
    for (std::size_t j = 0; j < moved.size(); ++j) {
        Reading& reading = result.readings[moved[j]];
        const auto row = 2 * static_cast<Eigen::Index>(j);
        reading.value -= shift.segment<2>(row);
        reading.covariance += error.block<2, 2>(row, row);
    }
    return result;
}

}  // namespace pendular
