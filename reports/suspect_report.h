#pragma once

#include <string>
#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the values of liquid content, normal stress or volume of beads that all readings of a
/// suspect measurement have and no other reading has, such as "liquid content 0.03". Returns an
/// empty text if there is no such value. A suspect measurement is a part of the measurement that
/// may be wrong.
/// @param readings readings of the diagnosis
std::string own_condition(const std::vector<Reading>& readings, const SuspectMeasurement& suspect);

/// Error of measurement that would explain the residuals of a diagnosis.
struct SuspectError {
    /// Part of the measurement that would be wrong, such as all readings of one file.
    const SuspectMeasurement& suspect;
    /// Model refitted with the error of measurement.
    const Explanation& explanation;
    /// Errors of the shear stress (index 0) and of the solid fraction (index 1), divided by the
    /// true value [1], positive for measured values that are too high, with the standard errors of
    /// the ratios [1]. 0 for direct measurements of effects.
    Eigen::Vector2d size = Eigen::Vector2d::Zero(), standard_error = Eigen::Vector2d::Zero();

    /// Whether the error of an observable (0: shear stress, 1: solid fraction) exceeds two of its
    /// standard errors.
    bool concerns(Eigen::Index observable) const {
        return std::abs(size(observable)) > 2 * standard_error(observable);
    }
    /// Returns the text of the errors that exceed two standard errors, such as "shear stress 9.5 +-
    /// 0.4 % too high". Empty if there is none.
    std::string text() const;
};

/// Returns the errors of measurement that would explain the residuals, one for each suspect
/// measurement (part of the measurement that may be wrong). Returns an empty list unless the
/// verdict of the diagnosis is a suspect measurement that the tests found. The errors contain
/// references to parts of `diagnosis`.
std::vector<SuspectError> suspect_errors(const StudyDiagnosis& diagnosis);

/// Returns sentences on the errors of measurement that would explain the residuals, one for each
/// suspect measurement (part of the measurement that may be wrong). A sentence states the size of
/// the error with its standard error, and chi2 per degree of freedom without and with the error. A
/// second sentence names the condition that only the suspect readings have, if there is one.
/// Returns an empty list unless the verdict of the diagnosis is a suspect measurement that the
/// tests found.
std::vector<std::string> suspect_lines(const StudyDiagnosis& diagnosis);

}  // namespace pendular
