#pragma once

#include <string>
#include <vector>

#include "sim/catalogue/effect_catalogue.h"
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

/// Returns sentences that ask to repeat the readings of a suspect measurement, which they name,
/// with what to expect.
/// @param readings of the diagnosis
std::string repetition_of(const SuspectError& error, const std::vector<Reading>& readings);

/// Returns the rank correlation gamma [1] between the liquid contents and the times of the wet
/// readings: 1 if the content never decreases with time, -1 if it never increases. Pairs with equal
/// contents or times do not count; 0 if no pair counts.
/// Source: Goodman and Kruskal, J. Am. Stat. Assoc. 49 (1954) 732.
double order_of_contents(const std::vector<Reading>& readings);

/// Returns a warning that the diagnosis may have mistaken a dependence on the liquid content for a
/// change with time. Empty unless the diagnosis names an effect that changes with time, and
/// `order_of_contents` is at least 0.9 or at most -0.9.
std::string order_line(const StudyDiagnosis& diagnosis, const EffectCatalogue& catalogue);

/// Returns a text for the user on rival models: their effects, their chi2 [1], and how the effects
/// can be measured directly. Empty if there are none.
/// @param chi2 chi2 of the study's model [1]
std::string rivals_line(const std::vector<FittedModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// Returns a text on how each effect can be measured directly, such as "contact-angle by ...;
/// torque-gain by ...". Effects without a direct measurement are left out.
std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue);

}  // namespace pendular
