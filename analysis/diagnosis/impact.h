#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Shift of the calibrated parameters [their units] when the model takes into account an effect, or
/// an error of measurement, of a given size.
struct Shift {
    /// Size of the effect or error: value of the effect's parameter [its unit], or amplitude of the
    /// error of measurement [1].
    double size = 0;
    /// Shift of the calibrated parameters [their units] in the linear approximation:
    ///     -(J'J)^-1 J' g A,
    /// with the derivatives J of the predictions with respect to the parameters, the change g of
    /// the readings by the effect or error per unit of its amplitude (J and g in units of the
    /// readings' errors, whitened), and the amplitude A at `size`.
    Eigen::VectorXd linear;
    /// Shift of the calibrated parameters [their units] in the linear approximation, limited to
    /// values that leave the parameters within their bounds.
    Eigen::VectorXd bounded;
    /// Shift of the calibrated parameters [their units] after a refit with the effect or error
    /// fixed at `size`. Empty if the model was not refitted.
    Eigen::VectorXd refitted;

    /// Returns the shift of the calibrated parameters [their units] after a refit or, if the model
    /// was not refitted, in the linear approximation within the bounds of the parameters.
    const Eigen::VectorXd& best() const { return refitted.size() > 0 ? refitted : bounded; }
};

/// Impact of one physical effect, or of one error of measurement, on the calibrated parameters:
/// shifts of the parameters for several sizes of the effect or error.
struct Impact {
    /// Name of the effect or of the suspect measurement (part of the measurement that may be
    /// wrong), such as "the readings of dry_1.csv".
    std::string name;
    /// Name of the effect's parameter, or of the measured quantity that is in error, such as "shear
    /// stress". Empty if `name` also names the quantity.
    std::string quantity;
    /// Unit of all sizes of the effect or error; "1" for dimensionless sizes, such as relative
    /// errors.
    std::string unit;
    /// Group to which the effect or error belongs in the table of impacts, such as "instrument" or
    /// "files".
    std::string group;
    /// Whether an error of measurement causes the impact. If false, a physical effect causes the
    /// impact.
    bool measurement = false;
    /// Index of the effect in ModelSpace::candidates(), or of the suspect measurement in
    /// Evidence::suspects.
    std::size_t index = 0;
    /// Index of the column of SuspectMeasurement::columns that describes the error of measurement.
    /// Unused for an effect.
    Eigen::Index column = 0;
    /// Size at which the effect or error does not change the readings [`unit`].
    double neutral = 0;
    /// Standard error of the estimated size of the effect or error [`unit`]. 0 if the standard
    /// error is not known.
    double error = 0;

    /// Shift of the calibrated parameters at the smallest size of the effect or error that is of
    /// interest to the user.
    Shift at_interest;
    /// Shift of the calibrated parameters at the estimated size of the effect or error.
    Shift at_estimate;
    /// Shifts of the calibrated parameters at the estimated size of the effect or error plus one
    /// standard error (`above`) and minus one standard error (`below`), within the bounds of the
    /// effect's parameter.
    Shift above, below;

    /// Returns the significance of the effect or error [1]: estimated size minus `neutral` (no
    /// effect or error), divided by the standard error of the estimated size. Not a number if the
    /// standard error is not known.
    double pull() const;
    /// Returns the change of the shift of the calibrated parameters [their units] when the size of
    /// the effect or error moves from the estimated size up (`up`) or down (`down`) by one standard
    /// error.
    Eigen::VectorXd up() const { return difference(above); }
    Eigen::VectorXd down() const { return difference(below); }
    /// Returns the uncertainty of the shift of each calibrated parameter [its unit] that comes from
    /// the standard error of the size of the effect or error: the larger of the absolute values of
    /// `up` and `down`.
    Eigen::VectorXd by_error() const { return up().cwiseAbs().cwiseMax(down().cwiseAbs()); }

  private:
    Eigen::VectorXd difference(const Shift& end) const {
        return end.refitted.size() > 0 && at_estimate.refitted.size() > 0
                   ? Eigen::VectorXd(end.refitted - at_estimate.refitted)
                   : Eigen::VectorXd(end.bounded - at_estimate.bounded);
    }
};

/// Impact of all effects or errors of measurement of one group together on the calibrated
/// parameters. For each parameter, the shift by the group is the square root of the sum of the
/// squared shifts by the single effects or errors, which are computed in the linear approximation.
struct GroupImpact {
    std::string group;
    /// Shift of each calibrated parameter [its unit] by the group: at the smallest sizes of
    /// interest of the effects or errors (`at_interest`), at the estimated sizes (`at_estimate`),
    /// and by a change of each estimated size by one standard error (`by_error`).
    Eigen::VectorXd at_interest, at_estimate, by_error;
};

/// Impacts of all effects that a model may lack, and of all errors of measurement, on the
/// calibrated parameters.
struct ImpactTable {
    /// Calibrated parameters; the first is the friction coefficient.
    std::vector<Parameter> parameters;
    /// Fitted values of the calibrated parameters (`fitted`) and their standard errors (`errors`),
    /// in the order and units of `parameters`.
    Eigen::VectorXd fitted, errors;
    /// Impacts of all effects and errors of measurement. First come the impacts of the effects or
    /// suspect measurements (parts of the measurement that may be wrong) that the verdict of the
    /// diagnosis names, then all other impacts. Each of the two groups is sorted by the absolute
    /// shift of the friction coefficient at the smallest size of interest, the largest first.
    std::vector<Impact> impacts;
    /// Impacts of each group of effects or errors together.
    std::vector<GroupImpact> groups;
};

/// Computes the impacts of physical effects and errors of measurement on the calibrated parameters,
/// in the linear approximation. For the first entries of the returned table, the function also
/// refits the model with the effect or error at the estimated size and at the smallest size of
/// interest. If the verdict of the diagnosis names the effect or error, the function also refits
/// the model at the sizes one standard error above and below the estimated size.
///
/// The size of an effect is estimated by the refit of the diagnosis with the effect alone. Without
/// such a refit, and for a switch (effect that is on or off), the score test estimates the size.
/// Sizes of errors of measurement are estimated by linear least squares. The table leaves out
/// effects with several free parameters, and effects with which the model cannot give the
/// conditions that the instrument shows.
/// @param most_refitted number N; the function refits the first N + min(N, m) entries of the table,
///        which begins with the m entries that the verdict names
/// @param threads largest number of threads; no result depends on the number of threads
ImpactTable impacts(const ModelSpace& space, const Evidence& evidence, const Diagnosis& diagnosis,
                    std::size_t most_refitted = 3, std::size_t threads = 1);

}  // namespace pendular
