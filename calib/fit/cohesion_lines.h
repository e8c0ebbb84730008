#pragma once

#include <string>
#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/model/model.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Deviation of a cohesion line from a point that it was not fitted to.
struct Overestimate {
    double reduced_pressure = 0;  ///< P*
    Estimate relative;            ///< (line - value)/value of the stress ratio [1]
};

/// Mohr-Coulomb line of wet readings of one liquid content and one inertial number,
///     |s12|/s22 = intercept + c*/P*
/// with errors from the covariance of the points, not scaled by chi2/dof.
/// Source: Badetti et al. (2018), eq:mohrcoulomb2.
struct CohesionLine {
    std::string source;          ///< "measured" or "simulated"
    double liquid_content = 0;   ///< Phi_L/Phi_S [1], mean of the points
    double inertial_number = 0;  ///< I [1], mean of the points; 0: the quasi-static limit
    Estimate stress_ratio_intercept;
    Estimate reduced_cohesion;  ///< c* = a^2 c/F0 [1]
    double correlation = 0;     ///< correlation of intercept and c*
    Estimate cohesion;          ///< c = c* F0/a^2 [Pa]
    int points = 0;             ///< number of points that the line is fitted to
    double chi2 = 0;
    int dof = 0;
    double lowest_reduced_pressure = 0;  ///< lowest reduced pressure of these points [1]
    std::vector<Overestimate> below;     ///< points below the limit, by falling P*
};

/// Stress ratio of a line at a reduced pressure [1].
double stress_ratio(const CohesionLine& line, double reduced_pressure);

struct CohesionOptions {
    /// Points of a lower P* are not fitted: choice of Badetti et al. (2018); the straight line is
    /// too high for P* <= 1.
    double lowest_reduced_pressure = 2.3;

    /// Whether a point of this P* is fitted. A limit met up to rounding is met: stresses and P* are
    /// converted into each other.
    bool fits(double reduced_pressure) const;
};

/// @throws InputError where the limit is no reduced pressure
void check_options(const CohesionOptions& options);

/// Straight lines through the measured wet readings, one per group of `wet_groups` and in their
/// order. A group without two distinct P* (2 % apart) at or above the limit has no line; `notes`
/// says so, and which readings a line leaves out.
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const GrainProperties& grains, const Liquid& liquid,
                                         const CohesionOptions& options,
                                         std::vector<std::string>& notes);

/// Cohesion lines through the model's predictions of these readings: the line that the same
/// procedure, with the weights of the readings, draws through the predictions; its errors are those
/// that the full covariance of the predictions causes. (Weights by that covariance itself would go
/// wrong: points whose errors are nearly common decide a line by their small differences, and
/// simulated stress ratios are not exactly straight.) chi2 says whether the readings' errors would
/// show the bend.
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const Prediction& predicted, const GrainProperties& grains,
                                         const Liquid& liquid, const CohesionOptions& options,
                                         std::vector<std::string>& notes);

}  // namespace pendular
