#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/diagnosis/evidence.h"

namespace pendular {

/// Limits of the refits of a diagnosis: they end within seconds, at parameters that differ from the
/// best fit by far less than a standard error. The accuracy of a study's final fit would take
/// minutes.
inline constexpr FitEffort refit_effort{
    .most_steps = 12, .tolerance = 1e-6, .settled = 1e-4, .elsewhere = false};

/// Returns the whitened residuals of a fit. Derivatives with respect to parameters at a bound of
/// their range are set to zero, since these parameters cannot change to imitate an effect.
/// @param fit may contain amplitudes of an error of measurement after the model's parameters
WeightedResiduals residuals_of(const Model& model, const Measured& measured, const Fit& fit);

/// Refits a study's model with further effects, and tests whether the refitted models fit. All
/// tests use one set of random draws of errors. Several threads may call the constant member
/// functions at once.
class Explanations {
  public:
    /// Draws the errors. The arguments must outlive this object.
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);
    /// Takes readings and draws from `other`, for tests of the models of `space`, which must
    /// outlive this object, as must the arguments with which `other` was made.
    Explanations(const ModelSpace& space, const Explanations& other);

    /// Returns the fit of the study's model with the candidates `chosen` and, if given, an error of
    /// the suspect measurement `suspect`, without tests (`judge`).
    /// @param start parameters of the model, then the amplitudes of the errors of `suspect`
    /// @throws std::domain_error if no true state of the cell gives the conditions that the
    ///         instrument shows with the parameters `start`
    FittedModel refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Sets the p values and `accepted` of a refitted model: p() must be at least
    /// DiagnosisOptions::significance. Further effects are not tested if the fit did not converge
    /// or if the p value for lack of fit is below half of DiagnosisOptions::least_p.
    void judge(FittedModel& explanation) const;

    /// Returns the whitened residuals of a refitted model, as the function of that name.
    WeightedResiduals residuals_of(const FittedModel& explanation) const;
    /// Returns Akaike's criterion [1] of a refitted model (ranking.h), with ln det Sigma.
    double criterion(const FittedModel& explanation, double variance_factor = 1) const;
    /// Returns the p value [1] of the test for lack of fit.
    /// @param roughly whether only the first 600 draws count if the statistic is far above them all
    double lack_of_fit_p(const WeightedResiduals& residuals, bool roughly = false) const;
    /// Returns the score tests of all suspect measurements but the one of index `but`.
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// Returns a refitted model with one more candidate added.
    Addition addition(const FittedModel& explanation, std::size_t candidate) const;

    const NullDraws& draws() const { return *draws_; }
    /// Returns the p value [1] below which one of the two tests of a model rejects it.
    double half_significance() const { return options_.significance / 2; }

    /// Covariances of the errors of the predicted change of the readings by each candidate, per
    /// unit of its amplitude, in products of the units of the readings. The caller sets them once,
    /// before the first test of a refitted model.
    std::vector<ModelSpace::ChangeErrors> errors;

  private:
    /// Returns the score tests of all candidates and suspect measurements that a model lacks.
    std::vector<ScoreTest> further_tests(const WeightedResiduals& residuals,
                                         const FittedModel& explanation) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    std::shared_ptr<const NullDraws> draws_;
};

/// Smallest share [1] of the excess chi2 - dof of a study's model that further effects must remove
/// to count as explaining most of the misfit. Chosen: what remains is then a small part, whatever
/// its cause.
inline constexpr double most_of_misfit = 0.9;

/// Effects that explain most of a misfit that no refitted model explains within the errors.
struct Leaders {
    FittedModel model;     ///< study's model with only the leading effects added
    double explained = 0;  ///< share of the excess chi2 - dof that `model` removes [1]
    /// Share [1] of the simulated repetitions of the experiment in which the best model lacks at
    /// least one leading effect.
    double rival_share = 0;
};

/// Returns the share [1] of the excess chi2 - dof of a model that the refitted model `by` removes:
/// 1 if `by` leaves no excess, 0 if there was none.
double share_explained(double excess, const FittedModel& by);

/// Finds the leading effects if none of the refitted models `tried` fits the readings: the effects
/// that belong to the best model in at least 95 % of simulated repetitions of the experiment. In a
/// repetition with the errors e, the best model m has the smallest value of Akaike's criterion
///     (chi2 + 2 s r_m' e)/s^2 + ln det Sigma_m + 2 (number of parameters),
/// with the residuals r_m (r_m and e whitened) and the covariance Sigma_m of measurement and
/// prediction. The factor s^2 (`factor_on_variance`) enlarges all variances, since even the best
/// model leaves a misfit. Empty unless the fit with exactly the leading effects converged and
/// removes `most_of_misfit`.
/// @param excess chi2 - dof of the study's model without further effects
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), sections 2.5
/// (QAIC) and 2.12 (bootstrap frequencies).
std::optional<Leaders> find_leaders(double excess, const std::vector<FittedModel>& tried,
                                    const Explanations& explanations);

}  // namespace pendular
