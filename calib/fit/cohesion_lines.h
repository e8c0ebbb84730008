#pragma once

#include <string>
#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/model/model.h"
#include "calib/model/mohr_coulomb.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Relative deviation of a cohesion line from the stress ratio of a point that the line was not
/// fitted to.
struct Overestimate {
    double reduced_pressure = 0;  ///< P* of the point [1]
    Estimate relative;  ///< (line - value)/value, with the stress ratio `value` of the point [1]
};

/// Mohr-Coulomb line fitted to wet readings of one liquid content and one inertial number,
///     |s12|/s22 = intercept + c*/P*
/// with the reduced cohesion c* and reduced pressure P*, and errors from the covariance of the
/// points, not scaled by chi2/dof.
/// Source: Badetti et al. (2018), eq:mohrcoulomb2.
struct CohesionLine {
    std::string source;         ///< "measured" or "simulated"
    double liquid_content = 0;  ///< liquid content Phi_L/Phi_S [1], mean of the points
    /// Inertial number I [1], mean of the points; 0: the quasi-static limit.
    double inertial_number = 0;
    Estimate stress_ratio_intercept;     ///< intercept: stress ratio for 1/P* -> 0 [1]
    Estimate reduced_cohesion;           ///< c* = a^2 c/F0 [1]
    double correlation = 0;              ///< correlation of the errors of intercept and c* [1]
    Estimate cohesion;                   ///< c = c* F0/a^2 [Pa]
    int points = 0;                      ///< number of points that the line is fitted to
    double chi2 = 0;                     ///< chi2 of the fit
    int dof = 0;                         ///< degrees of freedom of the fit
    double lowest_reduced_pressure = 0;  ///< lowest P* of the fitted points [1]
    /// Deviations of the line from the points with P* below
    /// `CohesionOptions::lowest_reduced_pressure`, in decreasing P*.
    std::vector<Overestimate> below;
};

/// Stress ratio |s12|/s22 [1] that a cohesion line gives at a reduced pressure P* [1].
double stress_ratio(const CohesionLine& line, double reduced_pressure);

/// Options for the fit of cohesion lines (stress ratio of wet grains against 1/P*).
struct CohesionOptions {
    /// Lowest reduced pressure P* of the points to which a line is fitted [1]. The default is the
    /// choice of Badetti et al. (2018); the straight line is too high for P* <= 1.
    double lowest_reduced_pressure = lowest_cohesion_pressure;

    /// Whether a line is fitted to points at this reduced pressure P*: true if P* is at or above
    /// `lowest_reduced_pressure`, with a tolerance for rounding errors of P*.
    bool fits(double reduced_pressure) const;
};

/// Checks the options for the fit of cohesion lines.
/// @throws InputError where the lowest reduced pressure is not positive and finite
void check_options(const CohesionOptions& options);

/// Fits straight lines of stress ratio against 1/P* to the wet readings as measured, one line for
/// each group of `wet_groups`, in the order of the groups. A group without two distinct P* (2 %
/// apart) at or above the limit of `options` has no line. Notes on groups without a line, and on
/// the reduced pressures that a line leaves out, are appended to `notes`.
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const GrainProperties& grains, const Liquid& liquid,
                                         const CohesionOptions& options,
                                         std::vector<std::string>& notes);

/// Fits straight lines of stress ratio against 1/P* to the model's predictions of the wet readings,
/// with the same procedure as for measured lines. The points are weighted by the covariance of the
/// readings; the errors of the lines follow from the full covariance of the predictions. (Weights
/// by the covariance of the predictions would mislead: where errors are nearly common to all
/// points, small differences between the points decide the line, and simulated stress ratios are
/// not exactly linear in 1/P*.) chi2 shows whether the errors of the readings are small enough to
/// reveal this curvature.
/// @param predicted predictions of all `readings`, with their covariance
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const Prediction& predicted, const GrainProperties& grains,
                                         const Liquid& liquid, const CohesionOptions& options,
                                         std::vector<std::string>& notes);

}  // namespace pendular
