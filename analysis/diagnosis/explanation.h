#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/score_statistic.h"
#include "analysis/misfit/null_draws.h"
#include "calib/fit/fit.h"
#include "calib/model/model_space.h"

namespace pendular {

/// Suspect measurement: part of the measurement that may be wrong, such as all readings of one
/// condition.
struct SuspectMeasurement {
    /// Name of the part of the measurement, such as "the readings of dry_1.csv".
    std::string name;
    /// Change of the measured values [their units] by each kind of error that the part of the
    /// measurement may have, at amplitude 1 of the error: a row for each measured value (two for
    /// each reading, one for each direct measurement), a column for each kind of error.
    Eigen::MatrixXd columns;
    /// Name of the quantity that each kind of error changes, such as "shear stress". The list is
    /// empty if `name` names the quantity.
    std::vector<std::string> quantities = {};
    /// Smallest amplitude [1] of an error that is of interest to the user, for each kind of error.
    double smallest_of_interest = 1;
    /// Group to which the suspect measurement belongs in tables, such as "files". May be empty.
    std::string group = {};
};

/// Input of a diagnosis (search for effects that a study's model lacks): readings and direct
/// measurements of effects' parameters with their errors, their conditions, and the suspect
/// measurements (parts of the measurement that may be wrong).
struct Evidence {
    Measured measured;  ///< measured values, with the covariance of their errors
    /// Uncertainty of the standard errors of the measured values, which are estimated from few
    /// replicates (readings at the same condition).
    ErrorKnowledge errors;
    bool errors_assumed = false;  ///< whether the errors of some readings are assumed, not measured
    /// Groups of entries, as indices into the measured values. An entry is one observable of one
    /// reading, or one direct measurement of an effect's parameter. A group contains the entries of
    /// one observable at one condition, or a single direct measurement. Every entry is in one
    /// group.
    std::vector<std::vector<Eigen::Index>> conditions;
    /// Suspect measurements: parts of the measurement that may be wrong.
    std::vector<SuspectMeasurement> suspects;
};

/// Model that a diagnosis (search for effects that a study's model lacks) has refitted to the
/// readings, with the results of the tests whether the model fits. The refitted model is the
/// study's model with further effects, or with an error of a suspect measurement (part of the
/// measurement that may be wrong).
struct Explanation {
    /// Effects that the refitted model adds to the study's model, as indices into
    /// ModelSpace::candidates().
    EffectSet chosen;
    /// Suspect measurement (part of the measurement that may be wrong) whose error is fitted
    /// together with the parameters of the model, as index into Evidence::suspects. Empty if the
    /// model contains no error of measurement.
    std::optional<std::size_t> suspect;
    /// Fitted parameters and predictions of the refitted model, with their errors.
    Fit fit;
    /// chi2 [1] of all measured values in the fit of the refitted model.
    double chi2 = 0;
    /// Akaike's criterion [1] (ranking.h), set in TestResults::fitting and ::fitting_suspects if
    /// there are any of the latter.
    double criterion = 0;
    /// p value [1] of the test whether the refitted model misses the mean of the readings at a
    /// condition (lack of fit).
    double lack_of_fit_p = 0;
    /// p value [1] of the most significant effect or suspect measurement (part of the measurement
    /// that may be wrong) that the refitted model does not contain, corrected for the number of
    /// tests. 1 if no such effect or measurement was tested.
    double further_p = 1;
    /// Whether the refitted model counts as fitting the readings: the fit converged, and p() is at
    /// least DiagnosisOptions::significance. A model with one further effect may also be accepted
    /// if p() is at least DiagnosisOptions::least_p and no better model fits
    /// (`search_explanations`).
    bool accepted = false;

    /// Returns the p value [1] of both tests of the refitted model together (for lack of fit and
    /// for further effects), by Bonferroni's inequality: 2 min(lack_of_fit_p, further_p), at most
    /// 1.
    double p() const { return std::min(1.0, 2 * std::min(lack_of_fit_p, further_p)); }
};

/// Result of a diagnosis for one candidate effect (not in the study's model): the score test (test
/// without a refit) of the effect and, if the model was refitted with the effect, the reduction of
/// chi2.
struct Finding {
    /// Index of the candidate effect in ModelSpace::candidates().
    std::size_t candidate = 0;
    /// Score test (test without a refit) of the candidate effect on the residuals of the study's
    /// model.
    ScoreTest test;
    /// Value of the candidate effect's parameter that the score test estimates [unit of the
    /// parameter]. For a switch (effect that is on or off), the estimated amplitude [1], which is 1
    /// if the effect is on.
    double value = 0;
    /// Standard error of `value` [unit of `value`].
    double standard_error = 0;
    /// p value [1] of the score test of the candidate effect, corrected for the number of tests.
    double p = 1;
    /// Power of the score test [1]: probability that the test finds the effect if the effect's
    /// parameter differs from its neutral value (no effect) by the smallest amount of interest.
    double power = 0;
    /// Smallest difference [unit of `value`] between the effect's parameter and its neutral value
    /// (no effect) that the score test finds with the probability DiagnosisOptions::wanted_power.
    /// For a switch, the smallest amplitude [1].
    double detectable = 0;
    /// Reduction of chi2 [1] by a refit of the study's model to which the candidate effect alone is
    /// added. Empty if the model was not refitted with the effect.
    std::optional<double> refitted_reduction;
    /// Whether the readings can reveal the effect. For an effect with a parameter, the score test
    /// must find the effect with the probability DiagnosisOptions::wanted_power at some value
    /// within the bounds of the parameter. For a switch (effect that is on or off), `power` must
    /// exceed 0.1.
    bool identifiable = false;
};

/// Options of a diagnosis, which tests whether a study's model lacks physical effects.
struct DiagnosisOptions {
    /// Significance level [1]: probability that a complete model (a model that lacks no effect) is
    /// called incomplete.
    double significance = 0.05;
    /// Smallest p value [1] at which a model with one further effect may be accepted if all such
    /// models have p values below `significance`. A test at the 5 % level rejects one true model in
    /// twenty. Without `least_p`, the diagnosis would then name an effect that is not needed.
    double least_p = 0.01;
    /// Smallest power [1] of a score test (test without a refit) at which an effect that the test
    /// does not find counts as excluded. Power: probability that the test finds an effect of the
    /// smallest size of interest.
    double wanted_power = 0.8;
    /// Number of random draws of the readings' errors, from which all p values follow. With 6000
    /// draws, a p value of 0.025 has a standard error of 0.002.
    Eigen::Index draws = 6000;
    /// Seed of the random draws of errors.
    std::uint64_t seed = 1;
    /// Largest number of pairs of candidate effects (not in the model) with which the model is
    /// refitted.
    std::size_t most_pairs = 12;
    /// Largest number of suspect measurements (parts of the measurement that may be wrong) for
    /// which the model is refitted.
    std::size_t most_suspects = 12;
    /// Function that is called with the progress of the diagnosis: `done` of `of` pieces of the
    /// work `what`, such as "refits", are finished. May be empty.
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
    /// Largest number of threads for score tests (tests without a refit) and refits of models. No
    /// result depends on the number of threads.
    std::size_t threads = 1;
};

}  // namespace pendular
