#include "analysis/left_out.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/misfit/compare.h"
#include "calib/model/mohr_coulomb.h"
#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

/// Accumulates the squared relative errors of predictions, for their RMS.
class Squares {
  public:
    void add(const Predictor& model, const Eigen::VectorXd& parameters,
             const std::vector<Reading>& readings) {
        if (readings.empty()) {
            return;
        }
        const Prediction predicted =
            model.predict(parameters, conditions_of(readings), PredictionPart::slopes);
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const Eigen::Vector2d value =
                predicted.value.segment<2>(2 * static_cast<Eigen::Index>(k));
            sum_ += (value.cwiseQuotient(readings[k].value).array() - 1).square().matrix();
        }
        count_ += static_cast<double>(readings.size());
    }
    std::array<double, 2> rms_percent() const {
        return {100 * std::sqrt(sum_(0) / count_), 100 * std::sqrt(sum_(1) / count_)};
    }

  private:
    Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
    double count_ = 0;
};

/// Readings divided into those left out of a fit and the others.
struct Split {
    std::vector<Reading> left_out, others;
};
Split split(const std::vector<Reading>& readings, const std::vector<std::size_t>& left_out) {
    Split result;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const bool out = std::ranges::find(left_out, k) != left_out.end();
        (out ? result.left_out : result.others).push_back(readings[k]);
    }
    return result;
}

/// Whether the readings of a fit determine every combination of its parameters.
bool determined(const Fit& fit, const Measured& measured) {
    Eigen::MatrixXd slopes =
        measured.covariance.diagonal().cwiseSqrt().cwiseInverse().asDiagonal() *
        fit.prediction.jacobian;
    for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
        slopes.col(k) /= std::max(slopes.col(k).norm(), 1e-300);
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(slopes);
    decomposed.setThreshold(1e-7);  // columns of length 1: less is rounding of the derivatives
    return fit.converged && decomposed.rank() == slopes.cols();
}

}  // namespace

std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& c) {
    const auto end_of_fitted = c.readings.begin() + static_cast<std::ptrdiff_t>(c.fitted);
    const std::vector<Reading> fitted(c.readings.begin(), end_of_fitted);
    const auto groups = replicate_groups(fitted);
    if (groups.size() < 2 || fitted_cohesions(c.model, c.grains, c.liquid) > 0) {
        return std::nullopt;
    }
    LeftOut result{.conditions = groups.size()};
    Squares squares;
    for (const auto& group : groups) {
        const Split parts = split(fitted, group);
        const ModelOfReadings rest(model, conditions_of(parts.others), c.direct);
        const Measured measured = stack(parts.others, c.direct);
        Fit refit = fit(rest, measured, c.fit.parameters);
        if (!determined(refit, measured)) {
            // A fit that started from the optimum would leave undetermined parameters at values
            // that this condition set.
            refit = fit(rest, measured, start_of(rest));
            ++result.undetermined;
        }
        squares.add(*model, refit.parameters, parts.left_out);
    }
    squares.add(*model, c.fit.parameters, {end_of_fitted, c.readings.end()});
    result.rms_percent = squares.rms_percent();
    return result;
}

}  // namespace pendular
