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

/// Part of the measurement that may be wrong, such as all readings of one condition.
struct SuspectMeasurement {
    std::string name;  ///< text, as in "the readings of dry_1.csv"
    /// Change of the readings' entries by each kind of error, entries x kinds, in the units of the
    /// readings. An entry is one observable of one reading, or a direct measurement.
    Eigen::MatrixXd columns;
};

/// Readings with errors, conditions and suspect measurements, as a diagnosis uses them.
struct Evidence {
    Measured measured;            ///< measured values with their errors as estimated
    ErrorKnowledge errors;        ///< uncertainty of these errors
    bool errors_assumed = false;  ///< whether errors of some readings are assumed, not measured
    /// Groups of entries that were measured at one condition; every entry is in one group.
    std::vector<std::vector<Eigen::Index>> conditions;
    std::vector<SuspectMeasurement> suspects;
};

/// Model with further effects, or with an error of a suspect measurement, refitted to the readings;
/// and whether it fits.
struct Explanation {
    EffectSet chosen;                    ///< candidates added to the model
    std::optional<std::size_t> suspect;  ///< index into Evidence::suspects; empty: no error fitted
    Fit fit;
    double chi2 = 0;
    double lack_of_fit_p = 0;  ///< p value of the lack of fit of the conditions' means
    /// p value of the best further effect or suspect measurement, corrected for the number of
    /// tests; 1: not tested.
    double further_p = 1;
    bool accepted = false;  ///< whether the model fits
};

/// Result of a diagnosis for one candidate (effect not in the model): its score test and, where the
/// model was refitted with it, the reduction of chi2.
struct Finding {
    std::size_t candidate = 0;  ///< index into ModelSpace::candidates()
    ScoreTest test;
    double value = 0;           ///< estimate of the parameter [its unit]; switch: amplitude [1]
    double standard_error = 0;  ///< standard error of `value` [unit of `value`]
    double p = 1;               ///< p value of the candidate, corrected for the number of tests
    double power = 0;           ///< probability of revealing the smallest effect of interest [1]
    /// Distance from the neutral value that the test reveals with the power
    /// DiagnosisOptions::wanted_power [unit of `value`].
    double detectable = 0;
    /// Reduction of chi2 by the refit with this candidate alone; empty: not refitted.
    std::optional<double> refitted_reduction;
    std::string decision;  ///< text, as in "missing" or "no sign of it"
    /// Whether the test would reveal some size of the effect within its bounds; for a switch,
    /// whether the power exceeds 0.1.
    bool identifiable = false;
};

/// Options of a diagnosis.
struct DiagnosisOptions {
    double significance = 0.05;  ///< probability that a complete model is called incomplete
    double wanted_power = 0.8;   ///< power from which on a candidate would have been seen [1]
    /// Number of random draws of errors, which all tests share; 6000 determine a limit of 0.025
    /// with a standard error of 0.002.
    Eigen::Index draws = 6000;
    std::uint64_t seed = 1;  ///< seed of the random draws
    /// Largest number of pairs of candidates to refit, where no single candidate explains the
    /// readings.
    std::size_t most_pairs = 12;
    std::size_t most_suspects = 12;  ///< largest number of suspect measurements to refit
    /// Starting values of the model's parameters; empty: the model's own starting values.
    std::optional<Eigen::VectorXd> start = {};
    /// Callback for progress: `done` of `of` steps of the work `what`; may be empty.
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
    std::size_t threads = 1;  ///< largest number of threads for refits; no result depends on it
};

}  // namespace pendular
