#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "calib/fit/fit.h"
#include "calib/model/predictor.h"
#include "data/reading.h"

namespace pendular {

/// Returns both ends of the profile-likelihood interval of one parameter, in its unit. In the
/// interval, chi2 minimised over all other parameters exceeds the minimum of chi2 by at most `rise`
/// [1]. A rise of 1 gives the 68 % interval. It ends at the latest at the ends of `Fit::range`.
/// @param best fit of the model, with the covariance of the predictions
/// @param which index of the parameter
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);
/// Returns the profile likelihood of one parameter: for each of `values` [unit of the parameter],
/// the rise of chi2 above its minimum [1] when all other parameters minimise chi2 within their
/// ranges. Infinite if no true state of the cell gives the conditions shown.
Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values);

/// Sets Fit::instrument: what each shared uncertainty of the model's study contributes to the
/// errors of the fitted parameters. With the change g of the readings by an error of one standard
/// uncertainty, the parameters change by (J' W J)^-1 J' W g, where J are the derivatives of the
/// predictions and W the inverse covariance of measured minus predicted values.
/// Source: law of propagation, JCGM 100:2008 (GUM), Eq. (13).
/// An error that does not count, but is measured directly, contributes what the measurement leaves.
/// A one-sided error contributes what a fit to readings without it changes, if that converges and
/// no parameter is at a bound.
/// @param readings fitted readings, to which the fit's prediction belongs
void add_instrument(Fit& fit, const Predictor& predictor, const std::vector<Reading>& readings,
                    const std::vector<DirectMeasurement>& direct);

/// Returns the contributions to the error of parameter `k` by the errors that count (or do not),
/// the largest first, at most `most` of them and none below 1 % of the largest.
std::vector<InstrumentError> largest_errors(const Fit& fit, Eigen::Index k, bool counts,
                                            std::size_t most);

/// Errors that change the readings alike, as one cause.
struct SharedCause {
    InstrumentError largest;  ///< the one that contributes most
    double together = 0;      ///< contribution of all of them [unit of the parameter]
};

/// Returns the causes that contribute most to the error of parameter `k`, the largest first, of the
/// errors that `largest_errors` returns. Errors that are alike (`InstrumentError::alike`) add up in
/// quadrature.
std::vector<SharedCause> largest_causes(const Fit& fit, Eigen::Index k, bool counts,
                                        std::size_t most);

/// Returns the shared errors that a fit needs two or more standard uncertainties away from 0, the
/// farthest first, whether or not they count.
std::vector<InstrumentError> far_errors(const Fit& fit);

}  // namespace pendular
