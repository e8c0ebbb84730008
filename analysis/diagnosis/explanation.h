#pragma once

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
    /// Name of the part of the measurement, as in "the readings of dry_1.csv".
    std::string name;
    /// Change of the measured values by each kind of error of this part of the measurement, at
    /// amplitude 1 of the error. A row for each measured value (two for each reading, one for each
    /// direct measurement, in its unit), a column for each kind of error.
    Eigen::MatrixXd columns;
    /// Quantity that each kind of error changes, as in "shear stress"; empty if `name` names the
    /// quantity.
    std::vector<std::string> quantities = {};
    /// Smallest amplitude of interest to the user, of each kind of error of this part of the
    /// measurement [1].
    double smallest_of_interest = 1;
    /// Group to which the part belongs in tables, such as "files"; may be empty.
    std::string group = {};
};

/// Input of a diagnosis: readings and direct measurements with their errors, conditions, and
/// suspect measurements (parts of the measurement that may be wrong). An entry is one observable of
/// one reading, or a direct measurement.
struct Evidence {
    Measured measured;  ///< measured values with their errors
    /// How uncertain the standard errors of the measured values are, since they are estimated from
    /// few replicates (repeated measurements).
    ErrorKnowledge errors;
    bool errors_assumed = false;  ///< whether errors of some readings are assumed, not measured
    /// Groups of entries, as indices. A group contains the values of one observable at one
    /// condition, or a single direct measurement; every entry is in one group.
    std::vector<std::vector<Eigen::Index>> conditions;
    std::vector<SuspectMeasurement> suspects;  ///< parts of the measurement that may be wrong
};

/// Refitted model of a diagnosis: the study's model with further effects, or with an error of a
/// suspect measurement (part of the measurement that may be wrong), fitted to the readings, and the
/// result of the tests whether it fits.
struct Explanation {
    /// Effects added to the study's model, as indices into ModelSpace::candidates().
    EffectSet chosen;
    /// Suspect measurement (part of the measurement that may be wrong) whose error is fitted too,
    /// as index into Evidence::suspects; empty if the model contains no error of measurement.
    std::optional<std::size_t> suspect;
    /// Fit of the refitted model to the readings.
    Fit fit;
    /// Chi2 of all measured values in the fit of the refitted model.
    double chi2 = 0;
    double lack_of_fit_p = 0;  ///< p value of the test for lack of fit of the conditions' means [1]
    /// p value [1] of the most significant effect or suspect measurement (part of the measurement
    /// that may be wrong) that the model does not contain, corrected for the number of tests; 1 if
    /// this was not tested.
    double further_p = 1;
    /// Whether the model fits: neither p value is significant, and the fit converged.
    bool accepted = false;
};

/// Result of a diagnosis for one candidate (effect not in the model): its score test (test without
/// a refit) and, if the model was refitted with the candidate, the reduction of chi2.
struct Finding {
    /// Candidate effect that was tested, as index into ModelSpace::candidates().
    std::size_t candidate = 0;
    /// Score test (test without a refit) of the candidate effect on the residuals of the study's
    /// model.
    ScoreTest test;
    /// Value of the candidate effect's parameter, estimated by the score test [its unit]; for a
    /// switch (on or off), the amplitude [1].
    double value = 0;
    /// Standard error of the estimated `value` of the candidate effect's parameter [unit of
    /// `value`].
    double standard_error = 0;
    /// p value of the score test of the candidate effect [1], corrected for the number of tests.
    double p = 1;
    /// Power of the score test [1]: probability that it finds the effect if the effect's parameter
    /// differs from its neutral value (no effect) by the smallest amount of interest.
    double power = 0;
    /// Smallest difference of the effect's parameter from its neutral value (no effect) that the
    /// score test finds with the probability DiagnosisOptions::wanted_power [unit of `value`].
    double detectable = 0;
    /// Reduction of chi2 from the study's model to the model refitted with this candidate effect
    /// alone [1]; empty: not refitted.
    std::optional<double> refitted_reduction;
    std::string decision;  ///< conclusion on the candidate effect, as in "missing"
    /// Whether the readings can reveal the effect: within the bounds of the effect's parameter is a
    /// value at which the score test would find the effect with the probability
    /// DiagnosisOptions::wanted_power. For a switch (on or off), whether `power` exceeds 0.1.
    bool identifiable = false;
};

/// Options of a diagnosis.
struct DiagnosisOptions {
    /// Probability that a model which lacks nothing is called incomplete [1].
    double significance = 0.05;
    /// Smallest power [1] of the score test of a candidate effect (not in the model) at which the
    /// effect counts as excluded if the test does not find it.
    double wanted_power = 0.8;
    /// Number of random draws of the readings' errors, from which all p values follow. With 6000
    /// draws, a p value of 0.025 has a standard error of 0.002.
    Eigen::Index draws = 6000;
    /// Seed of the random draws of errors.
    std::uint64_t seed = 1;
    /// Largest number of pairs of candidate effects (not in the model) to refit if neither a single
    /// candidate nor a suspect measurement explains the readings.
    std::size_t most_pairs = 12;
    /// Largest number of suspect measurements (parts of the measurement that may be wrong) for
    /// which the model is refitted.
    std::size_t most_suspects = 12;
    /// Starting values for the fit of the model without further effects, in the order of its
    /// parameters; empty: Parameter::start.
    std::optional<Eigen::VectorXd> start = {};
    /// Function that is called with the progress: `done` of `of` steps of the work that `what`
    /// names are finished; may be empty.
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
    /// Largest number of threads for refits of models; no result depends on it.
    std::size_t threads = 1;
};

}  // namespace pendular
