#pragma once

#include <string>
#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the condition that all suspect readings have and no other reading has, such as "liquid
/// content 0.03". Empty if there is none.
/// @param readings readings of the diagnosis
std::string own_condition(const std::vector<Reading>& readings, const SuspectMeasurement& suspect);

/// Error of measurement that would explain the residuals of a diagnosis.
struct SuspectError {
    const SuspectMeasurement& suspect;  ///< part of the measurement that would be wrong
    const Explanation& explanation;     ///< model refitted with the error
    /// Errors of the shear stress (index 0) and of the solid fraction (index 1), divided by the
    /// true value [1], positive for measured values that are too high, with the standard errors of
    /// the ratios [1]. 0 for direct measurements of effects.
    Eigen::Vector2d size = Eigen::Vector2d::Zero(), standard_error = Eigen::Vector2d::Zero();

    /// Whether the error of an observable (0: shear stress, 1: solid fraction) is significant.
    bool concerns(Eigen::Index observable) const {
        return std::abs(size(observable)) > 2 * standard_error(observable);
    }
    /// Returns the text of the significant sizes: "shear stress 9.5 +- 0.4 % too high".
    std::string text() const;
};

/// Returns the errors of measurement that explain the residuals. Empty unless the verdict is a
/// suspect measurement that the tests found. The result refers to the diagnosis.
std::vector<SuspectError> suspect_errors(const StudyDiagnosis& diagnosis);

/// Returns sentences on the errors of measurement that would explain the residuals, one for each
/// suspect measurement: size of the error with its standard error, chi2 per degree of freedom
/// without and with the error, and the condition that only the suspect readings have. Empty unless
/// the verdict is a suspect measurement that the tests found.
std::vector<std::string> suspect_lines(const StudyDiagnosis& diagnosis);

}  // namespace pendular
