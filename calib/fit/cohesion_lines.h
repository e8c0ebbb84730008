#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/fit/fit.h"
#include "calib/model/model.h"
#include "calib/model/mohr_coulomb.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Relative amount by which a cohesion line (straight line of stress ratio against the inverse
/// reduced pressure 1/P*) overestimates the measured or predicted stress ratio of a wet reading to
/// which the line was not fitted.
struct Overestimate {
    double reduced_pressure = 0;  ///< reduced pressure P* of the reading [1]
    /// Relative deviation of the line [1]: (stress ratio of the line - stress ratio of the
    /// reading)/(stress ratio of the reading).
    Estimate relative;
};

/// Cohesion line: straight line (Mohr-Coulomb) fitted to the stress ratios of wet readings of one
/// liquid content at one inertial number (`at_one_inertial_number`),
///     |s12|/s22 = intercept + c*/P*,  c* = a^2 c/F0,  P* = a^2 s22/F0,
/// with the shear stress s12, the normal stress s22, the reduced cohesion c*, the reduced pressure
/// P*, the grain diameter a, the cohesion c and the pull-off force F0 of a liquid bridge. A point
/// of the line is the stress ratio of one reading. The standard errors follow from the covariance
/// of the points, without a factor chi2/dof.
/// Source: Badetti et al. (2018), Eq. (16).
struct CohesionLine {
    /// Kind of the stress ratios to which the line is fitted: "measured" or "simulated".
    std::string source;
    /// Liquid content (liquid volume divided by grain volume) [1], mean over the group of wet
    /// readings (`wet_groups`), fitted or left out.
    double liquid_content = 0;
    /// Inertial number I [1], mean over the group of wet readings (`wet_groups`), fitted or left
    /// out; 0 in the quasi-static limit.
    double inertial_number = 0;
    /// Intercept of the line [1]: stress ratio in the limit 1/P* -> 0.
    Estimate stress_ratio_intercept;
    /// Slope of the line [1]: reduced cohesion c* = a^2 c/F0, with the grain diameter a, the
    /// cohesion c and the pull-off force F0 of a liquid bridge.
    Estimate reduced_cohesion;
    /// Correlation coefficient [1] between the error of the intercept and the error of the reduced
    /// cohesion c*.
    double correlation = 0;
    /// Cohesion c = c* F0/a^2 of the wet grains [Pa], which follows from the slope c* of the line.
    Estimate cohesion;
    /// Number of points (stress ratios of readings) to which the line is fitted.
    int points = 0;
    /// chi2 of the fit of the line to the points [1].
    double chi2 = 0;
    /// Number of degrees of freedom of the fit of the line.
    int dof = 0;
    double lowest_reduced_pressure = 0;  ///< lowest reduced pressure P* of the fitted points [1]
    /// Deviations of the line from the stress ratios that the line leaves out, since their reduced
    /// pressures P* are below `CohesionOptions::lowest_reduced_pressure`. The deviations are in the
    /// order of decreasing P*.
    std::vector<Overestimate> below;
};

/// Returns the stress ratio (shear stress divided by normal stress) [1] of a cohesion line at the
/// reduced pressure P* = `reduced_pressure` [1]. A cohesion line is a straight line of stress ratio
/// against 1/P*.
double stress_ratio(const CohesionLine& line, double reduced_pressure);

/// Options for the fit of cohesion lines: straight lines of stress ratio against the inverse
/// reduced pressure 1/P*.
struct CohesionOptions {
    /// Lowest reduced pressure P* [1] of the readings to which a line is fitted. The default is the
    /// value of Badetti et al. (2018). For P* <= 1, a straight line overestimates the stress ratio
    /// of wet grains.
    double lowest_reduced_pressure = lowest_cohesion_pressure;
    /// Inertial number [1] to which readings are brought before lines are fitted
    /// (`at_one_inertial_number`). If empty, the inertial number that the wet readings share, or 0
    /// (quasi-static limit) if they differ.
    std::optional<double> inertial_number = {};

    /// Whether a line is fitted to readings at the reduced pressure `reduced_pressure` [1]. The
    /// reduced pressure must be at least `lowest_reduced_pressure`, with a tolerance for rounding
    /// errors.
    bool fits(double reduced_pressure) const;
};

/// Checks the options for the fit of cohesion lines (straight lines of stress ratio against the
/// inverse reduced pressure 1/P*).
/// @throws InputError if the lowest reduced pressure is not positive and finite, or if the inertial
///         number is negative or one at which grains do not flow densely
void check_options(const CohesionOptions& options);

/// Values of all readings, measured or predicted, to which cohesion lines are fitted: shear stress
/// [Pa] and solid fraction [1] of each reading in turn.
struct LineValues {
    std::string source;  ///< "measured" or "simulated"
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;  ///< of the errors, from which those of the lines follow
    /// Covariance whose inverse weights the points. That of predictions would give misleading
    /// weights, since they share most of their errors: model and measurement have the same weights.
    Eigen::MatrixXd weighting;
};

/// Fits a straight line of the stress ratio against the inverse reduced pressure 1/P* to each group
/// of wet readings of steady shear with about equal liquid contents and inertial numbers, in the
/// order of `wet_groups`. Readings whose P* is below the limit of `options` are left out. A group
/// has a line only if the P* of two remaining readings differ by more than 2 %. A large chi2 of a
/// simulated line means that predictions are not linear in 1/P* within the errors of the readings.
/// @param notes receives sentences for the user on groups without a line and on readings that a
///        line leaves out, if given
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const LineValues& values, const GrainProperties& grains,
                                         const Liquid& liquid, const CohesionOptions& options,
                                         std::vector<std::string>* notes = nullptr);

}  // namespace pendular
