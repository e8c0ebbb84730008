#include "calib/fit/profile.h"

#include <cmath>
#include <stdexcept>

#include "calib/fit/least_squares.h"

namespace pendular {
namespace {

/// Minimum of chi2 over all parameters but one, with the covariance of a fit.
class Profile {
  public:
    Profile(const Model& model, const Measured& measured, const Fit& best, Eigen::Index which)
        : model_(model),
          measured_(measured),
          best_(best),
          which_(which),
          whitening_(measured.covariance + best.prediction.covariance),
          range_(allowed(model)) {}

    const ParameterBounds& range() const { return range_; }
    /// chi2 where the parameter has this value; infinite where the readings are impossible.
    double chi2_at(double value, const FitEffort& effort) const {
        const Eigen::VectorXd start = start_at(value);
        if (start.size() > 1) {
            const Minimum minimum =
                minimise(model_, measured_, whitening_, range_, start, effort, {}, which_);
            return minimum.usable ? minimum.chi2 : INFINITY;
        }
        try {
            const Eigen::VectorXd predicted = model_.predict(start, PredictionPart::values).value;
            return whitening_.apply(measured_.value - predicted).squaredNorm();
        } catch (const std::domain_error&) {
            return INFINITY;
        }
    }

  private:
    /// Parameters that minimise chi2 where the model is linear.
    Eigen::VectorXd start_at(double value) const {
        Eigen::VectorXd start = best_.parameters;
        if (best_.covariance.rows() == start.size() && best_.covariance(which_, which_) > 0) {
            start += best_.covariance.col(which_) / best_.covariance(which_, which_) *
                     (value - best_.parameters(which_));
            start = start.cwiseMax(range_.lower).cwiseMin(range_.upper);
        }
        start(which_) = value;
        return start;
    }

    const Model& model_;
    const Measured& measured_;
    const Fit& best_;
    Eigen::Index which_;
    Whitening whitening_;
    ParameterBounds range_;
};

}  // namespace

std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise) {
    const Profile profile(model, measured, best, which);
    const auto chi2_at = [&](double value) { return profile.chi2_at(value, {}); };
    const double limit = chi2_at(best.parameters(which)) + rise;
    const auto end = [&](double inside, double outside) {
        if (chi2_at(outside) < limit) {
            return outside;
        }
        // 2^-50 of the distance is its rounding error.
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (inside + outside);
            (chi2_at(middle) < limit ? inside : outside) = middle;
        }
        return 0.5 * (inside + outside);
    };
    return {end(best.parameters(which), profile.range().lower(which)),
            end(best.parameters(which), profile.range().upper(which))};
}

Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values) {
    const FitEffort effort{.most_steps = 50, .tolerance = 1e-6, .elsewhere = false};
    const Profile profile(model, measured, best, which);
    const double least = profile.chi2_at(best.parameters(which), effort);
    return values.unaryExpr([&](double value) { return profile.chi2_at(value, effort) - least; });
}

}  // namespace pendular
