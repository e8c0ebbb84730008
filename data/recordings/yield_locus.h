#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/interval_roles.h"

namespace pendular {

/// Peak of the shear stress in an interval in which the sample was sheared to failure. The peak is
/// given twice: at the sample with the largest shear stress, and after smoothing.
struct FailurePoint {
    int interval = 0;  ///< number in the file of the interval that was sheared to failure
    int line = 0;  ///< line in the file of the sample with the largest shear stress of the interval
    double normal_stress = 0;  ///< normal stress at the sample with the largest shear stress [Pa]
    double shear_stress = 0;   ///< largest shear stress of the interval [Pa]
    double smoothed_normal_stress = 0;  ///< mean normal stress around the smoothed peak [Pa]
    double smoothed_shear_stress = 0;   ///< largest shear stress after smoothing [Pa]
    /// Rows of the interval that are averaged for the smoothed peak, from `smoothed_begin` to
    /// `smoothed_end` - 1, counted from 0.
    std::size_t smoothed_begin = 0, smoothed_end = 0;
    /// True if the largest shear stress is in the last 5 % of the interval's rows: failure may not
    /// have been reached.
    bool at_end = false;
    /// Gap at the sample with the largest shear stress [m], if recorded.
    std::optional<double> height;
};

/// State at the end of a preshear, the steady shear that consolidates the sample before it is
/// sheared to failure.
struct PreshearPoint {
    /// Mean normal stress over the last tenth of the preshear's rows [Pa].
    double normal_stress = 0;
    double shear_stress = 0;  ///< mean shear stress over the last tenth of the preshear's rows [Pa]
    /// Standard deviation of the shear stress over the last tenth of the preshear's rows [Pa].
    double shear_stress_deviation = 0;
    /// Index of the first row of the last tenth of the preshear, from 0.
    std::size_t begin = 0;
    /// True if the shear stress of the preshear has reached a plateau: its mean over the last tenth
    /// of the rows differs by at most 2 % from its mean over the preceding tenth.
    bool plateau = true;
    /// Bulk density of the sample with liquid [kg/m^3], if the file states it.
    std::optional<double> bulk_density = {};
};

/// Straight line of shear stress against normal stress through points of failure, with the
/// strengths and flow properties that follow from the line.
struct LinearYieldLocus {
    /// Cohesion: shear stress at which the yield locus meets zero normal stress [Pa]; 0 if the
    /// fitted intercept is negative.
    double cohesion = 0;
    /// Shear stress of the fitted line at zero normal stress [Pa]; may be negative.
    double intercept = 0;
    /// Angle of the fitted line (shear stress against normal stress) to the axis of normal stress
    /// [rad].
    double slope_angle = 0;
    /// Tensile strength: normal stress -cohesion/slope at which the line reaches zero shear stress
    /// [Pa]; -infinity for a slope <= 0.
    double tensile_strength = 0;
    double unconfined_strength = 0;  ///< unconfined yield strength of the consolidated sample [Pa]
    /// Centre of the Mohr circle of the preshear, a normal stress [Pa]; empty without a preshear.
    std::optional<double> preshear_centre;
    /// Major principal stress of the preshear [Pa]; empty without a preshear.
    std::optional<double> major_principal_stress;
    /// Effective angle of internal friction [rad]; empty without a preshear.
    std::optional<double> effective_angle;
    /// Flowability: major principal stress of the preshear divided by unconfined yield strength
    /// [1]; empty without a preshear.
    std::optional<double> flowability;
    std::string flow_class;  ///< class of flowability, such as "cohesive"; empty without a preshear
};

/// Fits a straight line to points of failure (normal stress, shear stress) [Pa] by ordinary least
/// squares, and derives strengths and flow properties. With cohesion c and slope angle phi:
///     unconfined strength = 2 c cos(phi)/(1 - sin(phi))
///     (s - C)^2 + t^2 = (C sin(phi) + c cos(phi))^2 = r^2
/// The second line determines the Mohr circle of the preshear (normal stress s, shear stress t),
/// which is tangent to the line. Its centre C is the smaller root, r its radius, C + r the major
/// principal stress, and sin(effective angle) = r/C. If the preshear is above the line, the circle
/// touches the line at the normal stress s instead. A negative intercept means c = 0. Classes of
/// flowability: below 1 not flowing, below 2 very cohesive, below 4 cohesive, below 10
/// easy-flowing, else free-flowing.
/// @throws std::invalid_argument if there are fewer than two different normal stresses
/// Source: Jenike, Bulletin 123, University of Utah (1964); Schulze, Powders and Bulk Solids
/// (2008).
LinearYieldLocus linear_yield_locus(const std::vector<double>& normal_stress,
                                    const std::vector<double>& shear_stress,
                                    const std::optional<PreshearPoint>& preshear);

/// Points of failure after the same preshear, with straight lines fitted to the points.
struct YieldLocus {
    std::string test;  ///< name in the file of the test that the points of failure belong to
    /// Preshear before the first point of failure, if it was recorded.
    std::optional<PreshearPoint> preshear;
    std::vector<FailurePoint> points;
    /// Straight line through the points of failure, taken at the samples of largest shear stress.
    std::optional<LinearYieldLocus> line;
    /// Straight line through the points of failure, taken at the smoothed peaks of the shear
    /// stress.
    std::optional<LinearYieldLocus> smoothed;
};

/// Returns the state at the end of a preshear: means over the last tenth of its rows.
/// @param series columns of the preshear, with shear stress and normal stress
PreshearPoint preshear_point(const IntervalSeries& series);

/// Returns the point of failure of an interval: the sample with the largest shear stress, and the
/// largest mean shear stress over a window of 1/30 of the rows, at least five.
/// @param series columns of the interval, with shear stress and normal stress
/// @throws std::invalid_argument if the interval has no row with both stresses
FailurePoint failure_point(const Block& block, const IntervalSeries& series);

/// Returns the yield loci of a file. Each locus has the points of failure of one test after
/// preshears with the same normal stress (within 5 %). Intervals without stresses are left out.
/// @param series columns of each interval, in the order of the file's blocks
/// @param roles role of each interval, in the order of the file's blocks
std::vector<YieldLocus> yield_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const std::vector<IntervalRole>& roles);

}  // namespace pendular
