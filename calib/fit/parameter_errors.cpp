#include "calib/fit/parameter_errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
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

namespace {

/// Contributions below this share of the largest do not show in any printed digit [1].
constexpr double least_share = 0.01;
/// Distance from 0, in standard uncertainties, from which an error is named [1]. The readings draw
/// an estimate towards 0: of 120 honest studies (tests/hostile/spoilings.py) none came beyond 1.54.
constexpr double far_away = 2;
/// Cosine [1] from which two changes of the readings count as alike: a tenth of the squared change
/// is left to tell one from the other. A change that the readings see at 5 standard errors would
/// then differ by 1.6 of them from one that is alike.
constexpr double least_cosine = 0.95;
/// Changes below this many standard errors of the readings are rounding errors of the differences.
constexpr double rounding = 1e-6;

/// 1/variance of each direct measurement [1/(its unit)^2].
Eigen::VectorXd precision_of(const std::vector<DirectMeasurement>& direct) {
    Eigen::VectorXd precision(std::ssize(direct));
    for (std::size_t k = 0; k < direct.size(); ++k)
        precision(static_cast<Eigen::Index>(k)) = std::pow(direct[k].standard_error, -2);
    return precision;
}

/// Standard errors of values by measurement, noise of the runs and inexactness of the model,
/// without what all readings share. Unlike the covariance of measurement alone, they are never 0:
/// readings of a coarse gap may repeat to the digit.
Eigen::VectorXd own_errors(const Measured& measured, const Prediction& prediction) {
    Eigen::VectorXd variance = measured.covariance.diagonal();
    for (const Eigen::MatrixXd* part : {&prediction.run_noise, &prediction.discrepancy})
        if (part->rows() == variance.size()) variance += part->diagonal();
    return variance.cwiseSqrt();
}

/// Sets `InstrumentError::alike`.
/// @param changes of the readings by each of `all`
/// @param errors_of_values standard errors of the readings
void add_alike(std::vector<InstrumentError>& errors, const std::vector<SharedUncertainty>& all,
               const Eigen::MatrixXd& changes, const Eigen::VectorXd& errors_of_values) {
    const Eigen::VectorXd weights =
        (errors_of_values.array() > 0).select(errors_of_values.cwiseInverse(), 0.0);
    Eigen::MatrixXd directions = weights.asDiagonal() * changes;
    for (auto direction : directions.colwise()) {
        if (direction.norm() < rounding)
            direction.setZero();
        else
            direction.normalize();
    }
    const Eigen::MatrixXd cosines = directions.transpose() * directions;
    for (InstrumentError& error : errors) {
        const auto row = std::ranges::find(all, error.name, &SharedUncertainty::name) - all.begin();
        for (std::size_t j = 0; j < all.size(); ++j)
            if (all[j].name != error.name &&
                std::abs(cosines(row, static_cast<Eigen::Index>(j))) >= least_cosine)
                error.alike.push_back(all[j].name);
    }
}

/// Change of the parameters by a one-sided error, as large as it is: against a fit to readings
/// without it, within the ranges of the parameters. Such an error may be a quarter of a reading, so
/// that the parameters do not change in proportion to it. Empty where a parameter of the fit is at
/// a bound, or no such fit converges.
std::optional<Eigen::VectorXd> shift_of_fit(const Fit& fit, const Model& model,
                                            const Measured& without, const Whitening& whitening) {
    if (std::ranges::find(fit.at_bound, true) != fit.at_bound.end()) return {};
    const Minimum minimum = minimise(model, without, whitening, allowed(model), fit.parameters, {});
    if (!minimum.usable || !minimum.converged) return {};
    return fit.parameters - minimum.parameters;
}

/// @param shift of the parameters; empty: that in proportion to the error stays
void be_one_sided(InstrumentError& error, const std::optional<Eigen::VectorXd>& shift) {
    // Readings that would need an error of the other sign need something else.
    error.needed = std::max(error.needed, 0.0);
    if (shift) error.shift = *shift;
}

}  // namespace

void add_instrument(Fit& fit, const Predictor& predictor, const std::vector<Reading>& readings,
                    const std::vector<DirectMeasurement>& direct) {
    fit.instrument.clear();
    const std::vector<SharedUncertainty>& uncertainties = predictor.uncertainties();
    if (uncertainties.empty()) return;
    const Measured measured = stack(readings, direct);
    const std::shared_ptr<const Predictor> unowned(std::shared_ptr<void>(), &predictor);
    const ModelOfReadings model(unowned, conditions_of(readings), direct);
    const Eigen::MatrixXd of_direct = changes_of_direct(predictor, direct);
    Eigen::MatrixXd changes(measured.value.size(), std::ssize(uncertainties));
    changes << predictor.shared_changes(fit.parameters, conditions_of(readings)), of_direct;
    const Whitening whitening(measured.covariance + fit.prediction.covariance);
    const Eigen::MatrixXd weighted = whitening.solve(changes);
    const Eigen::MatrixXd shifts = fit.covariance * fit.prediction.jacobian.transpose() * weighted;
    // As inexact as the model is, the lack of fit between conditions is no sign of these errors.
    const double more = fit.inexactness * fit.inexactness - 1;
    const Eigen::MatrixXd weighted_inexact =
        more > 0 ? Whitening(measured.covariance + fit.prediction.covariance +
                             more * fit.prediction.discrepancy)
                       .solve(changes)
                 : weighted;
    const Eigen::VectorXd along =
        weighted_inexact.transpose() * (measured.value - fit.prediction.value);
    // What is left of each change after the parameters imitated it.
    const Eigen::MatrixXd left = changes - fit.prediction.jacobian * shifts;
    for (std::size_t k = 0; k < uncertainties.size(); ++k) {
        if (uncertainties[k].unbudgeted) continue;
        const auto j = static_cast<Eigen::Index>(k);
        // An error that does not count is not among the weights: the readings and its uncertainty
        // together estimate it, as if it were the only one.
        const double information = weighted_inexact.col(j).dot(left.col(j));
        const double known =
            uncertainties[k].counts ? 0 : of_direct.col(j).cwiseAbs2().dot(precision_of(direct));
        fit.instrument.push_back(
            {.name = uncertainties[k].name,
             .standard = uncertainties[k].standard,
             .unit = uncertainties[k].unit,
             .assumed = uncertainties[k].assumed,
             .counts = uncertainties[k].counts,
             .shift = shifts.col(j) / std::sqrt(1 + known),
             .needed = uncertainties[k].counts ? along(j) : along(j) / (1 + information)});
        if (!uncertainties[k].one_sided) continue;
        // The drag of walls adds to the torque, about as much to that of weaker grains.
        Measured without = measured;
        without.value -= changes.col(j);
        be_one_sided(fit.instrument.back(), shift_of_fit(fit, model, without, whitening));
    }
    const auto values = 2 * std::ssize(readings);
    add_alike(fit.instrument, uncertainties, changes.topRows(values),
              own_errors(measured, fit.prediction).head(values));
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

std::vector<SharedCause> largest_causes(const Fit& fit, Eigen::Index k, bool counts,
                                        std::size_t most) {
    std::vector<SharedCause> causes;
    for (InstrumentError& each : largest_errors(fit, k, counts, fit.instrument.size())) {
        const auto known = std::ranges::find_if(causes, [&](const SharedCause& cause) {
            return std::ranges::find(cause.largest.alike, each.name) != cause.largest.alike.end();
        });
        const double part = std::abs(each.shift(k));
        if (known != causes.end())
            known->together = std::hypot(known->together, part);
        else
            causes.push_back({.largest = std::move(each), .together = part});
    }
    std::ranges::stable_sort(causes, std::greater{}, &SharedCause::together);
    if (causes.size() > most) causes.resize(most);
    return causes;
}

std::vector<InstrumentError> far_errors(const Fit& fit) {
    std::vector<InstrumentError> errors = fit.instrument;
    const auto distance = [](const InstrumentError& each) { return std::abs(each.needed); };
    std::erase_if(errors, [&](const InstrumentError& e) { return !(distance(e) >= far_away); });
    std::ranges::stable_sort(errors, std::greater{}, distance);
    return errors;
}

}  // namespace pendular
