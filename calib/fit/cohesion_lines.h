#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/emulator/query.h"
#include "calib/fit/fit.h"
#include "calib/model/model.h"
#include "calib/model/mohr_coulomb.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Group of wet readings with about equal liquid contents and inertial numbers, either all of
/// steady shear or all points of failure (peaks of the shear stress).
struct WetGroup {
    std::vector<std::size_t> members;  ///< indices in the list of all readings
    double liquid_content = 0;         ///< [1], mean of the members
    double inertial_number = 0;        ///< [1], mean; 0 in the quasi-static limit
    bool at_failure = false;           ///< rather than in steady shear
};

/// Groups the wet readings by liquid content and inertial number. Each member agrees with the first
/// member of the group within 2 % in liquid content and within 20 % in inertial number.
/// Quasi-static readings (inertial number 0) and points of failure form separate groups. The groups
/// are sorted by liquid content, then by inertial number, then by steady shear before failure.
std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings);

/// Whether two values differ by at most `tolerance` [1] times the larger of their magnitudes.
bool agree(double a, double b, double tolerance);

/// Largest relative difference of inertial numbers between first and other members of a `WetGroup`.
/// Chosen: wider than that of replicates, since the measured height and stress enter the number.
constexpr double inertial_number_tolerance = 0.2;

/// Overestimate of the stress ratio of a wet reading by a cohesion line that was not fitted to it.
struct Overestimate {
    double reduced_pressure = 0;  ///< reduced pressure P* of the reading [1]
    Estimate relative;            ///< (ratio of the line - ratio)/ratio [1]
};

/// Cohesion line: straight line (Mohr-Coulomb) fitted to the stress ratios of wet readings of one
/// liquid content at one inertial number (`at_one_inertial_number`),
///     |s12|/s22 = intercept + c*/P*,  c* = a^2 c/F0,  P* = a^2 s22/F0,
/// with the reduced cohesion c* and the cohesion c. A point is the stress ratio of one reading.
/// Errors follow from the covariance of the points, without a factor chi2/dof.
/// Source: Badetti et al. (2018), Eq. (16).
struct CohesionLine {
    std::string source;  ///< "measured" or "simulated"
    /// Mean of the group of wet readings (`wet_groups`) [1], fitted or left out.
    double liquid_content = 0;
    /// Mean of the group [1], fitted or left out; 0 in the quasi-static limit.
    double inertial_number = 0;
    Estimate stress_ratio_intercept;  ///< [1]
    Estimate reduced_cohesion;        ///< c* [1]
    double correlation = 0;           ///< of the errors of intercept and c* [1]
    Estimate cohesion;                ///< c = c* F0/a^2 [Pa]
    int points = 0;                   ///< number of fitted points
    double chi2 = 0;
    int dof = 0;
    double lowest_reduced_pressure = 0;  ///< lowest reduced pressure P* of the fitted points [1]
    /// Deviations from the points that the line leaves out, since their P* is below
    /// `CohesionOptions::lowest_reduced_pressure`, in the order of decreasing P*.
    std::vector<Overestimate> below;
};

/// Returns the stress ratio [1] of a line at the reduced pressure `reduced_pressure` [1].
double stress_ratio(const CohesionLine& line, double reduced_pressure);

/// Options for the fit of cohesion lines.
struct CohesionOptions {
    /// Lowest reduced pressure P* [1] of the fitted readings. The default is that of Badetti et al.
    /// (2018). For P* <= 1, a straight line overestimates the stress ratio of wet grains.
    double lowest_reduced_pressure = lowest_cohesion_pressure;
    /// Inertial number [1] to which readings are brought before the fit (`at_one_inertial_number`).
    /// If empty, that which the wet readings share, or 0 (quasi-static limit) if they differ.
    std::optional<double> inertial_number = {};

    /// Whether a line is fitted to readings at this reduced pressure [1], up to rounding errors.
    bool fits(double reduced_pressure) const;
};

/// Checks options for the fit of cohesion lines.
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

/// Returns a line for each group of wet readings of steady shear with about equal liquid contents
/// and inertial numbers, in the order of `wet_groups`. Readings whose P* is below the limit of
/// `options` are left out. A group has a line only if the P* of two remaining readings differ by
/// more than 2 %. A large chi2 of a simulated line means predictions that are not linear in 1/P*
/// within the errors of the readings.
/// @param notes receives sentences on groups without a line and on readings that a line leaves out
std::vector<CohesionLine> cohesion_lines(const std::vector<Reading>& readings,
                                         const LineValues& values, const GrainProperties& grains,
                                         const Liquid& liquid, const CohesionOptions& options,
                                         std::vector<std::string>* notes = nullptr);

}  // namespace pendular
