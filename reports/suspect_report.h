#pragma once

#include <string>
#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the liquid content, normal stress or volume of beads that all readings of a suspect
/// measurement and no other reading have, such as "liquid content 0.03"; empty if there is none.
std::string own_condition(const std::vector<Reading>& readings, const SuspectMeasurement& suspect);

/// Error of measurement that would explain the residuals.
struct SuspectError {
    const SuspectMeasurement& suspect;  ///< part of the measurement that would be wrong
    const FittedModel& model;           ///< refit with the error
    /// Errors of shear stress (0) and solid fraction (1) over the true value [1], positive for
    /// measured values that are too high, with standard errors. 0 for direct measurements of
    /// effects.
    Eigen::Vector2d size = Eigen::Vector2d::Zero(), standard_error = Eigen::Vector2d::Zero();

    /// Whether the error of an observable exceeds two of its standard errors.
    bool concerns(Eigen::Index observable) const {
        return std::abs(size(observable)) > 2 * standard_error(observable);
    }
    /// Returns the errors that exceed two standard errors, such as "shear stress 9.5 +- 0.4 % too
    /// high".
    std::string text() const;
};

/// Returns one error for each suspect measurement; empty unless a suspect measurement that the
/// tests found is the verdict. The errors contain references to parts of `diagnosis`.
std::vector<SuspectError> suspect_errors(const StudyDiagnosis& diagnosis);

/// Returns sentences on the `suspect_errors`: size with standard error, chi2/dof without and with
/// the error, and the condition that only the suspect readings have (`own_condition`).
std::vector<std::string> suspect_lines(const StudyDiagnosis& diagnosis);

}  // namespace pendular
