#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Shift of the calibrated parameters [their units] when the model takes into account an effect, or
/// an error of measurement, of one size.
struct Shift {
    /// Value of the effect's parameter [its unit], or amplitude of the error of measurement [1].
    double size = 0;
    /// Shift in the linear approximation:
    ///     -(J'J)^-1 J' g A,
    /// with the derivatives J of the predictions by the parameters and the change g of the readings
    /// per unit of the amplitude, both whitened (in units of the readings' errors), and the
    /// amplitude A at `size`.
    Eigen::VectorXd linear;
    /// Shift after a refit with the effect fixed at `size`; empty: not refitted.
    Eigen::VectorXd refitted;

    /// Returns the shift after a refit where there is one, else the linear shift.
    const Eigen::VectorXd& best() const { return refitted.size() > 0 ? refitted : linear; }
};

/// Impact of one effect, or of one error of measurement, on the calibrated parameters: shifts of
/// the parameters for several sizes of the effect or error.
struct Impact {
    std::string name;          ///< effect or suspect measurement, as in "the readings of dry_1.csv"
    std::string quantity;      ///< parameter of the effect, or measured quantity that is in error
    std::string unit;          ///< unit of all sizes; "1": relative, or without a dimension
    std::string group;         ///< group of the table, as in "instrument" or "files"
    bool measurement = false;  ///< true: an error of measurement; false: an effect
    std::size_t index = 0;     ///< index of the candidate or of the suspect measurement
    Eigen::Index column = 0;   ///< kind of error: column of SuspectMeasurement::columns
    double neutral = 0;        ///< size at which the readings are not changed [unit]
    double error = 0;          ///< standard error of the estimated size [unit]; 0: not known

    Shift at_interest;  ///< shift of the calibrated parameters at the smallest size that matters
    Shift at_estimate;  ///< shift of the calibrated parameters at the estimated size
    /// Shifts at the estimated size plus and minus its standard error, within the bounds of the
    /// parameter.
    Shift above, below;

    /// Significance of the estimated size [1]: its distance from `neutral` over its standard error;
    /// not a number where the standard error is not known.
    double pull() const;
    /// Changes of the calibrated parameters when the size increases or decreases from its estimate
    /// by one standard error.
    Eigen::VectorXd up() const { return difference(above); }
    Eigen::VectorXd down() const { return difference(below); }
    /// For each calibrated parameter, the larger of the absolute values of `up` and `down`.
    Eigen::VectorXd by_error() const { return up().cwiseAbs().cwiseMax(down().cwiseAbs()); }

  private:
    Eigen::VectorXd difference(const Shift& end) const {
        return end.refitted.size() > 0 && at_estimate.refitted.size() > 0
                   ? Eigen::VectorXd(end.refitted - at_estimate.refitted)
                   : Eigen::VectorXd(end.linear - at_estimate.linear);
    }
};

/// Impacts of all effects or errors of one group together: for each calibrated parameter [its
/// unit], the root of the sum of squares of its shifts in the linear approximation, at the smallest
/// sizes that matter (`at_interest`), at the estimated sizes and by the errors of the estimates.
struct GroupImpact {
    std::string group;
    Eigen::VectorXd at_interest, at_estimate, by_error;
};

/// Impacts of all effects that a model may lack, and of all errors of measurement, on the
/// calibrated parameters.
struct ImpactTable {
    std::vector<Parameter> parameters;  ///< calibrated parameters, friction first
    Eigen::VectorXd fitted, errors;     ///< fitted values and standard errors of the parameters
    /// Impacts of the effects or suspect measurements that the verdict names, then of the others;
    /// each in decreasing shift of the first parameter at the smallest size that matters.
    std::vector<Impact> impacts;
    std::vector<GroupImpact> groups;
};

/// Computes the impacts of effects and errors of measurement on the fit of a diagnosis in the
/// linear approximation. For the leading effects, they are also computed by refits, at the
/// estimated and at the smallest sizes that matter. The leading effects are up to `most_refitted`
/// effects that the verdict names, which are also refitted at one standard error above and below
/// their estimates, and the `most_refitted` others with the largest impacts. Sizes are estimated by
/// refits of the diagnosis where there are any, else by score tests. Effects with several free
/// parameters, and effects with which the readings are impossible, are left out.
/// @param threads largest number of threads; no result depends on it
ImpactTable impacts(const ModelSpace& space, const Evidence& evidence, const Diagnosis& diagnosis,
                    std::size_t most_refitted = 3, std::size_t threads = 1);

}  // namespace pendular
