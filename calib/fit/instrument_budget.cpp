#include "calib/fit/instrument_budget.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "calib/fit/least_squares.h"

namespace pendular {
namespace {

/// Contributions below this share of the largest do not show in any printed digit [1].
constexpr double least_share = 0.01;
/// Distance from 0, in standard uncertainties, from which an error is named [1]. The readings draw
/// an estimate towards 0, so that of 120 honest studies none came beyond 1.54 (docs/validation.md).
constexpr double far_away = 2;

}  // namespace

void add_instrument(Fit& fit, const Predictor& predictor, const std::vector<Reading>& readings,
                    const Measured& measured) {
    fit.instrument.clear();
    const std::vector<SharedUncertainty>& uncertainties = predictor.uncertainties();
    if (uncertainties.empty()) return;
    const Eigen::Index n = measured.value.size();
    Eigen::MatrixXd changes =
        Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(uncertainties.size()));
    changes.topRows(2 * static_cast<Eigen::Index>(readings.size())) =
        predictor.shared_changes(fit.parameters, conditions_of(readings));
    const Whitening whitening(measured.covariance + fit.prediction.covariance);
    const Eigen::MatrixXd weighted = whitening.solve(changes);
    const Eigen::MatrixXd shifts = fit.covariance * fit.prediction.jacobian.transpose() * weighted;
    const Eigen::VectorXd along = weighted.transpose() * (measured.value - fit.prediction.value);
    // What is left of each change after the parameters imitated it.
    const Eigen::MatrixXd left = changes - fit.prediction.jacobian * shifts;
    for (std::size_t k = 0; k < uncertainties.size(); ++k) {
        const auto j = static_cast<Eigen::Index>(k);
        // An error that does not count is not among the weights: the readings and its uncertainty
        // together estimate it, as if it were the only one.
        const double information = weighted.col(j).dot(left.col(j));
        fit.instrument.push_back(
            {.name = uncertainties[k].name,
             .standard = uncertainties[k].standard,
             .unit = uncertainties[k].unit,
             .assumed = uncertainties[k].assumed,
             .counts = uncertainties[k].counts,
             .shift = shifts.col(j),
             .needed = uncertainties[k].counts ? along(j) : along(j) / (1 + information)});
    }
}

std::vector<InstrumentError> largest_errors(const Fit& fit, Eigen::Index k, bool counts,
                                            std::size_t most) {
    std::vector<InstrumentError> errors = fit.instrument;
    std::erase_if(errors, [&](const InstrumentError& each) { return each.counts != counts; });
    const auto size = [k](const InstrumentError& each) { return std::abs(each.shift(k)); };
    std::ranges::stable_sort(errors, std::greater{}, size);
    std::erase_if(
        errors, [&, largest = errors.empty() ? 0 : size(errors.front())](
                    const InstrumentError& each) { return !(size(each) > least_share * largest); });
    if (errors.size() > most) errors.resize(most);
    return errors;
}

std::vector<InstrumentError> far_errors(const Fit& fit) {
    std::vector<InstrumentError> errors = fit.instrument;
    const auto distance = [](const InstrumentError& each) { return std::abs(each.needed); };
    std::erase_if(errors, [&](const InstrumentError& e) { return !(distance(e) >= far_away); });
    std::ranges::stable_sort(errors, std::greater{}, distance);
    return errors;
}

}  // namespace pendular
