#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Shift of the calibrated parameters [their units] where an effect, or an error of measurement, is
/// present at one size and the model takes it into account.
struct Shift {
    double size = 0;  ///< size: value of the effect's parameter, or relative error of readings
    /// Shift in the linear approximation, by the covariance of the fit:
    ///     -(J'J)^-1 J' g A,
    /// with the whitened derivatives J of the predictions by the parameters and the whitened change
    /// g of the readings by the amplitude A = 1.
    Eigen::VectorXd linear;
    /// Shift after a refit with the effect fixed at `size`; empty: not refitted.
    Eigen::VectorXd refitted;

    /// The refitted shift where there is one, else the linear shift.
    const Eigen::VectorXd& best() const { return refitted.size() > 0 ? refitted : linear; }
};

/// Impact of one effect, or of one error of measurement, on the calibrated parameters.
struct Impact {
    std::string name;          ///< effect or suspect measurement, as in "the readings of dry_1.csv"
    std::string quantity;      ///< parameter of the effect, or measured quantity that is in error
    std::string unit;          ///< unit of all sizes; "1": relative, or without a dimension
    std::string group;         ///< group of the table, as in "instrument" or "files"
    bool measurement = false;  ///< whether it is an error of measurement rather than an effect
    std::size_t index = 0;     ///< index of the candidate or of the suspect measurement
    Eigen::Index column = 0;   ///< column of the suspect measurement
    double neutral = 0;        ///< size at which nothing is changed [unit]
    double error = 0;          ///< standard error of the estimated size [unit]; 0: not known

    Shift at_interest;  ///< shift at the smallest size that matters
    Shift at_estimate;  ///< shift at the estimated size
    /// Shift at the estimate plus and minus its standard error, within the bounds of the parameter.
    Shift above, below;

    /// Distance of the estimate from no effect over its standard error [1]; not a number where the
    /// estimate has no error.
    double pull() const;
    /// Shift of the parameters from the estimate to one standard error above it or below it.
    Eigen::VectorXd up() const { return difference(above); }
    Eigen::VectorXd down() const { return difference(below); }
    /// For each parameter, the larger of the absolute values of `up` and `down`.
    Eigen::VectorXd by_error() const { return up().cwiseAbs().cwiseMax(down().cwiseAbs()); }

  private:
    Eigen::VectorXd difference(const Shift& end) const {
        return end.refitted.size() > 0 && at_estimate.refitted.size() > 0
                   ? Eigen::VectorXd(end.refitted - at_estimate.refitted)
                   : Eigen::VectorXd(end.linear - at_estimate.linear);
    }
};

/// Impacts of all effects or errors of one group together: for each calibrated parameter [its
/// unit], the root of the sum of squares of its shifts in the linear approximation.
struct GroupImpact {
    std::string group;
    Eigen::VectorXd at_interest, at_estimate, by_error;
};

/// Impact of each effect that a model may lack, and of each error of measurement, on the calibrated
/// parameters.
struct ImpactTable {
    std::vector<Parameter> parameters;  ///< calibrated parameters, friction first
    Eigen::VectorXd fitted, errors;     ///< fitted values and standard errors of the parameters
    /// The impacts: first those of the effects that the verdict names, if any; then those with the
    /// largest shift of the first parameter at the smallest size that matters.
    std::vector<Impact> impacts;
    std::vector<GroupImpact> groups;
};

/// Impacts on the fit of a diagnosis: in the linear approximation and, for the leading effects at
/// their estimates and at the smallest sizes that matter, by refits. The leading effects are up to
/// `most_refitted` that the verdict names, also refitted at one standard error above and below
/// their estimates, and the `most_refitted` others with the largest impacts. Estimates are those of
/// refits of the diagnosis where there are any, else those of score tests. Effects with several
/// free parameters, and effects with which the readings are impossible, are left out.
/// @param threads largest number of threads; no result depends on it
ImpactTable impacts(const ModelSpace& space, const Evidence& evidence, const Diagnosis& diagnosis,
                    std::size_t most_refitted = 3, std::size_t threads = 1);

}  // namespace pendular
