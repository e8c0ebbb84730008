#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/score_statistic.h"
#include "analysis/misfit/compare.h"
#include "analysis/misfit/null_draws.h"
#include "calib/fit/fitted_model.h"
#include "data/reading.h"

namespace pendular {

/// Part of the measurement that may be wrong, such as all readings of one condition, with one or
/// several kinds of error.
struct SuspectMeasurement {
    std::string name;  ///< such as "the readings of dry_1.csv"
    /// Change of the measured values [their units] by each kind of error, at amplitude 1: a row for
    /// each measured value (two for each reading, one for each direct measurement), a column for
    /// each kind.
    Eigen::MatrixXd columns;
    /// Quantity that each kind of error changes, such as "shear stress"; empty if `name` names it.
    std::vector<std::string> quantities = {};
    double smallest_of_interest = 1;  ///< smallest amplitude that matters [1]
    std::string group = {};           ///< in tables, such as "files"; may be empty
};

/// Input of a diagnosis.
struct Evidence {
    Measured measured;  ///< with the covariance of their errors
    ErrorKnowledge errors;
    bool errors_assumed = false;  ///< whether some errors are assumed, not measured
    /// Groups of measured values, by index: one observable at one condition, or one direct
    /// measurement. Each value is in one group.
    std::vector<std::vector<Eigen::Index>> conditions;
    std::vector<SuspectMeasurement> suspects;
};

/// Returns the input of a diagnosis: the readings, with errors estimated from replicates, then the
/// direct measurements, with errors stated in study.toml.
///
/// Suspect measurements are the readings of each condition, those of each file, and the direct
/// measurements of each parameter. If the files follow one another in time, the readings of each
/// file but the first together with all later ones are also suspect, since an instrument may change
/// between two recordings. An error of readings multiplies all their shear stresses by one factor
/// and all their solid fractions by another.
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Returns a text such as "300 Pa, I = 0.003, liquid content 0.03".
std::string condition_text(const Condition& condition);

/// Tests of one candidate effect, which the study's model lacks.
struct Finding {
    std::size_t candidate = 0;  ///< index into ModelSpace::candidates()
    ScoreTest test;             ///< on the residuals of the study's model
    /// Estimate by the score test [unit of the effect's parameter]; for a switch, the amplitude
    /// [1], which is 1 if it is on.
    double value = 0;
    double standard_error = 0;  ///< [unit of `value`]
    double p = 1;               ///< of the score test, corrected for the number of tests [1]
    double power = 0;  ///< probability that the test finds the smallest effect of interest [1]
    /// Smallest difference from the neutral value [unit of `value`] that the test finds with the
    /// probability DiagnosisOptions::wanted_power.
    double detectable = 0;
    /// Reduction of chi2 [1] by a refit with this effect alone; empty without such a refit.
    std::optional<double> refitted_reduction;
    /// Whether the readings can reveal the effect: the test finds it with `wanted_power` at some
    /// value within the bounds of its parameter; for a switch, `power` exceeds 0.1.
    bool identifiable = false;
};

/// Limits and accuracy of a diagnosis.
struct DiagnosisOptions {
    /// Significance level [1]: probability that a complete model is called incomplete.
    double significance = significant_p;
    /// Smallest p value [1] at which a model with one further effect may be accepted although it is
    /// below `significance`. A test at the 5 % level rejects one true model in twenty; without
    /// `least_p`, the diagnosis would then name an effect that is not needed.
    double least_p = 0.01;
    /// Smallest power [1] at which an effect that the test does not find counts as excluded.
    double wanted_power = 0.8;
    /// Random draws of errors for all p values: 6000 give a p value of 0.025 a standard error of
    /// 0.002.
    Eigen::Index draws = 6000;
    std::uint64_t seed = 1;
    std::size_t most_pairs = 12;     ///< most pairs of effects with which the model is refitted
    std::size_t most_suspects = 12;  ///< most suspect measurements that are refitted
    /// Called when `done` of `of` pieces of the work `what`, such as "refits", are finished; may be
    /// empty.
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
    std::size_t threads = 1;  ///< largest number; no result depends on it
};

}  // namespace pendular
