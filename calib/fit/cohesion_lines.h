#pragma once

#include <string>
#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/model/model.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Deviation of a cohesion line from a point that the line was not fitted to.
struct Overestimate {
    double reduced_pressure = 0;  ///< P* of the point [1]
    Estimate relative;            ///< (line - value)/value of the stress ratio [1]
};

/// Mohr-Coulomb line fitted to wet readings of one liquid content and one inertial number,
///     |s12|/s22 = intercept + c*/P*
/// with errors from the covariance of the points, not scaled by chi2/dof.
/// Source: Badetti et al. (2018), eq:mohrcoulomb2.
struct CohesionLine {
    std::string source;                  ///< "measured" or "simulated"
    double liquid_content = 0;           ///< Phi_L/Phi_S [1], mean of the points
    double inertial_number = 0;          ///< I [1], mean of the points; 0: the quasi-static limit
    Estimate stress_ratio_intercept;     ///< intercept: stress ratio for 1/P* -> 0 [1]
    Estimate reduced_cohesion;           ///< c* = a^2 c/F0 [1]
    double correlation = 0;              ///< correlation of intercept and c*
    Estimate cohesion;                   ///< c = c* F0/a^2 [Pa]
    int points = 0;                      ///< number of points that the line is fitted to
    double chi2 = 0;                     ///< chi2 of the fit
    int dof = 0;                         ///< degrees of freedom of the fit
    double lowest_reduced_pressure = 0;  ///< lowest P* of the fitted points [1]
    /// Deviations at the points below `CohesionOptions::lowest_reduced_pressure`, in decreasing P*.
    std::vector<Overestimate> below;
};

/// Stress ratio [1] that a cohesion line gives at a reduced pressure [1].
double stress_ratio(const CohesionLine& line, double reduced_pressure);

/// Options for the fit of cohesion lines.
struct CohesionOptions {
    /// Lowest P* of the points to which a line is fitted [1]. The default is the choice of Badetti
    /// et al. (2018); the straight line is too high for P* <= 1.
    double lowest_reduced_pressure = 2.3;

    /// Whether a line is fitted to a point of this P*: whether P* is at or above the limit, up to
    /// rounding by the conversion of stresses to P*.
    bool fits(double reduced_pressure) const;
};

/// Checks the options for the fit of cohesion lines.
/// @throws InputError where the lowest reduced pressure is not positive and finite
void check_options(const CohesionOptions& options);

/// Fits straight lines to the measured wet readings, one line for each group of `wet_groups`, in
/// the order of the groups. A group without two distinct P* (2 % apart) at or above the limit has
/// no line. `notes` receives the groups without a line and the reduced pressures that a line leaves
/// out.
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const GrainProperties& grains, const Liquid& liquid,
                                         const CohesionOptions& options,
                                         std::vector<std::string>& notes);

/// Fits cohesion lines to the model's predictions of wet readings, with the same procedure as for
/// measured lines. The points are weighted by the covariance of the readings; the errors of the
/// lines follow from the full covariance of the predictions. (Weights by the covariance of the
/// predictions would mislead: where errors are nearly common to all points, small differences
/// between the points decide the line, and simulated stress ratios are not exactly linear in 1/P*.)
/// chi2 shows whether the errors of the readings are small enough to reveal this curvature.
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const Prediction& predicted, const GrainProperties& grains,
                                         const Liquid& liquid, const CohesionOptions& options,
                                         std::vector<std::string>& notes);

}  // namespace pendular
