#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Shift of the calibrated parameters [their units] when the model takes into account an effect, or
/// an error of measurement, of a given size.
struct Shift {
    double size = 0;  ///< value of the effect's parameter [its unit] or amplitude of the error [1]
    /// Linear approximation: -(J'J)^-1 J' g A, with the whitened derivatives J and change g of the
    /// readings per unit of amplitude (`WeightedResiduals`), and the amplitude A at `size`.
    Eigen::VectorXd linear;
    Eigen::VectorXd bounded;   ///< `linear` within the bounds of the parameters
    Eigen::VectorXd refitted;  ///< by a refit with the size fixed; may be empty

    /// Returns `refitted` or, without a refit, `bounded`.
    const Eigen::VectorXd& best() const { return refitted.size() > 0 ? refitted : bounded; }
};

/// Impact of one effect, or of one error of measurement, on the calibrated parameters.
struct Impact {
    std::string name;  ///< of the effect or suspect measurement
    /// Effect's parameter or measured quantity, such as "shear stress"; empty if `name` says it.
    std::string quantity;
    std::string unit;          ///< of all sizes; "1" for relative errors
    std::string group;         ///< in the table of impacts, such as "instrument" or "files"
    bool measurement = false;  ///< whether an error of measurement, not an effect
    std::size_t index = 0;     ///< into ModelSpace::candidates() or Evidence::suspects
    Eigen::Index column = 0;   ///< of SuspectMeasurement::columns
    double neutral = 0;        ///< size that changes nothing [unit]
    double error = 0;          ///< standard error of the estimated size [unit]; 0: unknown

    Shift at_interest;  ///< at the smallest size of interest
    Shift at_estimate;
    /// Shifts at the estimated size plus and minus one standard error, within the bounds of the
    /// effect's parameter.
    Shift above, below;

    /// Returns (estimated size - neutral)/standard error [1]; not a number if the latter is
    /// unknown.
    double pull() const;
    /// Change of the shift [units of the parameters] from the estimated size by one standard error.
    Eigen::VectorXd up() const { return difference(above); }
    Eigen::VectorXd down() const { return difference(below); }
    /// Returns the larger of |up| and |down|.
    Eigen::VectorXd by_error() const { return up().cwiseAbs().cwiseMax(down().cwiseAbs()); }

  private:
    Eigen::VectorXd difference(const Shift& end) const {
        return end.refitted.size() > 0 && at_estimate.refitted.size() > 0
                   ? Eigen::VectorXd(end.refitted - at_estimate.refitted)
                   : Eigen::VectorXd(end.bounded - at_estimate.bounded);
    }
};

/// Impact of a group of effects or errors together: root of the sum of the squared shifts, by the
/// linear approximation within the bounds, as if the sizes were independent.
struct GroupImpact {
    std::string group;
    Eigen::VectorXd at_interest, at_estimate, by_error;  ///< [units of the parameters]
};

/// Impacts of all effects that a model may lack and of all errors of measurement.
struct ImpactTable {
    std::vector<Parameter> parameters;  ///< the first is the friction coefficient
    Eigen::VectorXd fitted, errors;     ///< in the order and units of `parameters`
    /// First those that the verdict names, then the others, each sorted by the absolute shift of
    /// the friction coefficient at the smallest size of interest, the largest first.
    std::vector<Impact> impacts;
    std::vector<GroupImpact> groups;
};

/// Returns the impacts in the linear approximation. For the first entries of the table, the model
/// is also refitted at the estimated size and at the smallest size of interest and, if the verdict
/// names the effect or error, one standard error above and below the estimated size.
///
/// The size of an effect is that of the diagnosis' refit with it alone; without one, and for a
/// switch, that of the score test. Sizes of errors of measurement come from linear least squares.
/// Effects with several free parameters are left out, and effects with which the model cannot give
/// the conditions that the instrument shows.
/// @param most_refitted number N of entries that are refitted, beside min(N, m) of the m named ones
/// @param threads largest number of threads; no result depends on it
ImpactTable impacts(const ModelSpace& space, const Evidence& evidence, const Diagnosis& diagnosis,
                    std::size_t most_refitted = 3, std::size_t threads = 1);

}  // namespace pendular
