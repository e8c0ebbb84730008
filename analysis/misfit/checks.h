#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Quantity that varies between the entries of the readings.
struct Covariate {
    std::string name;
    Eigen::VectorXd values;  ///< value at each entry; not a number where it is unknown
};

/// Test whether a model's residuals are consistent with the errors alone.
struct Check {
    enum class Kind {
        lack_of_fit,  ///< lack of fit of the conditions' means
        score,        ///< scores of a calibrated parameter cumulated along a covariate
        trend,        ///< residuals of an observable growing or falling with a covariate
        runs,         ///< neighbouring readings on the same side of the model
        neighbours    ///< readings at neighbouring conditions alike in their residuals
    };
    Kind kind = Kind::lack_of_fit;
    std::string covariate = {};  ///< name of the covariate; empty: none
    std::string of = {};         ///< name of the parameter or observable; empty: none
    double statistic = 0;        ///< statistic of this kind of check
    double p = 1;  ///< probability of a statistic at least as large if the model is right
};
std::string_view to_string(Check::Kind kind);

/// All checks of one fit, and their joint probability if the model is right.
struct Checks {
    std::vector<Check> all;
    double p = 1;
};

/// Observable and condition of each entry of the readings.
struct EntryKinds {
    /// Observable of each entry, into `observables`.
    std::vector<std::size_t> observable;
    std::vector<std::string> observables;
    /// Groups of entries that were measured at one condition.
    std::vector<std::vector<Eigen::Index>> conditions;
    /// Calibrated parameters, by the columns of the slopes.
    std::vector<std::string> parameters;
    bool replicated = false;
};

/// Says where a model fails that its calibrated parameters could not take over: the residuals are
/// those that are left once they have. All laws under which nothing fails are those of the same
/// draws, so that the probability of all checks together is exact: it counts how often the least p
/// of any is as small.
///
/// The score process is  S(x) = sum_{x_i <= x} (L^-1 J)_i (L^-1 (y - f))_i,  which ends at zero at
/// the optimum and wanders like a Brownian bridge; its largest distance from zero over its standard
/// deviation counts (after Hjort and Koning 2002; of whitened entries, each of which has a part of
/// those before it where errors are correlated). Runs: of readings in their order. Neighbours:
/// r' K r with a Gaussian kernel over all covariates, at three lengths. Trends: of the readings of
/// one observable, in proportion to the covariate's rank.
Checks check_fit(const WeightedResiduals& residuals, const EntryKinds& kinds,
                 const std::vector<Covariate>& covariates, const NullDraws& draws);

}  // namespace pendular
