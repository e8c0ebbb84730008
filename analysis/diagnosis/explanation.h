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

/// Part of the measurement that may be wrong, such as the readings of one condition, with the
/// change of the entries by an error of it: a column for each kind of error.
struct SuspectMeasurement {
    std::string name;
    Eigen::MatrixXd columns;
};

/// Readings with errors, conditions and suspect measurements, as a diagnosis uses them.
struct Evidence {
    Measured measured;  ///< errors as estimated
    ErrorKnowledge errors;
    bool errors_assumed = false;  ///< errors of some readings are assumed, not measured
    /// Groups of entries that were measured at one condition; each entry once.
    std::vector<std::vector<Eigen::Index>> conditions;
    std::vector<SuspectMeasurement> suspects;
};

/// Refitted model with further effects or a suspect measurement, and whether it fits.
struct Explanation {
    EffectSet chosen;
    std::optional<std::size_t> suspect;
    Fit fit;
    double chi2 = 0;
    double lack_of_fit_p = 0;  ///< probability of the lack of fit of the conditions' means
    double further_p =
        1;  ///< probability of the residuals if no further effect is missing; 1: not tested
    bool accepted = false;
};

/// Result of the scan for one candidate.
struct Finding {
    std::size_t candidate = 0;
    ScoreTest test;
    double value = 0;           ///< estimate of the parameter [its unit]; 1 or 0 for a switch
    double standard_error = 0;  ///< [its unit]
    double p = 1;               ///< probability that the best candidate looks so good by chance
    double power = 0;           ///< probability of revealing the smallest effect of interest
    double detectable = 0;      ///< distance from neutral revealed with a power of 0.8 [its unit]
    std::optional<double> refitted_reduction;  ///< reduction of chi2 by the refit, if there was one
    std::string decision;
    /// Whether some size within the bounds would be revealed.
    bool identifiable = false;
};

struct DiagnosisOptions {
    double significance = 0.05;  ///< how often a complete model is called incomplete
    double wanted_power = 0.8;
    Eigen::Index draws = 6000;  ///< of errors, for all tests: a limit of 0.025 is off by 0.002
    std::uint64_t seed = 1;
    std::size_t most_pairs = 12;     ///< refitted where no single candidate explains the readings
    std::size_t most_suspects = 12;  ///< likewise
    std::optional<Eigen::VectorXd> start = {};
    std::function<void(std::string_view what, std::size_t done, std::size_t of)> progress = {};
    std::size_t threads = 1;  ///< of refits; what is found does not depend on how many there are
};

}  // namespace pendular
