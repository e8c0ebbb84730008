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

/// A part of the measurement that may be wrong, such as the readings of one condition: what an
/// error of it adds to the entries, a column for each way in which it can be off.
struct SuspectMeasurement {
    std::string name;
    Eigen::MatrixXd columns;
};

/// Readings as a diagnosis takes them.
struct Evidence {
    Measured measured;  ///< errors as estimated
    ErrorKnowledge errors;
    bool errors_assumed = false;  ///< of some readings, rather than measured
    /// Entries that were measured at the same condition; each entry once.
    std::vector<std::vector<Eigen::Index>> conditions;
    std::vector<SuspectMeasurement> suspects;
};

/// A model with something more, refitted, and whether it stands.
struct Explanation {
    EffectSet chosen;
    std::optional<std::size_t> suspect;
    Fit fit;
    double chi2 = 0;
    double lack_of_fit_p = 0;  ///< of the readings' means against the model
    double further_p = 1;      ///< that nothing further is missing; 1 where not asked
    bool accepted = false;
};

/// Result of the scan for one candidate.
struct Finding {
    std::size_t candidate = 0;
    ScoreTest test;
    double value = 0;           ///< estimate of the parameter [its unit]; 1 or 0 for a switch
    double standard_error = 0;  ///< [its unit]
    double p = 1;               ///< that some candidate looks so good where nothing is missing
    double power = 0;           ///< to see the smallest effect of interest
    double detectable = 0;      ///< how far from neutral it is seen in 4 of 5 cases [its unit]
    std::optional<double> refitted_reduction;  ///< of chi2, where it was refitted
    std::string decision;
    /// Whether there is a size within the bounds that would be seen.
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
