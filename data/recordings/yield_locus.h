#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/interval_roles.h"

namespace pendular {

/// Peak of the shear stress in an interval in which the sample was sheared to failure. The peak is
/// given twice: at the data point with the largest shear stress, and after smoothing.
struct FailurePoint {
    /// Number, in the file, of the interval in which the sample was sheared to failure.
    int interval = 0;
    int line = 0;  ///< line number, in the file, of the data point with the largest shear stress
    /// Normal stress at the data point with the largest shear stress [Pa].
    double normal_stress = 0;
    double shear_stress = 0;            ///< largest shear stress of the interval [Pa]
    double smoothed_normal_stress = 0;  ///< mean normal stress around the smoothed peak [Pa]
    double smoothed_shear_stress = 0;   ///< largest shear stress after smoothing [Pa]
    /// Rows of the interval that are averaged for the smoothed peak, from `smoothed_begin` to
    /// `smoothed_end` - 1, counted from 0.
    std::size_t smoothed_begin = 0, smoothed_end = 0;
    /// Whether the largest shear stress is in the last 5 % of the interval's rows, so that failure
    /// may not have been reached.
    bool at_end = false;
    /// Gap (height of the sample) at the data point with the largest shear stress [m], if recorded.
    std::optional<double> height;
};

/// State at the end of a preshear, which is the steady shear that consolidates the sample before
/// the sample is sheared to failure.
struct PreshearPoint {
    /// Mean normal stress over the last tenth of the preshear's rows [Pa].
    double normal_stress = 0;
    double shear_stress = 0;  ///< mean shear stress over the last tenth of the preshear's rows [Pa]
    /// Standard deviation of the shear stress over the last tenth of the preshear's rows [Pa].
    double shear_stress_deviation = 0;
    /// Index of the first row of the last tenth of the preshear, from 0.
    std::size_t begin = 0;
    /// Whether the shear stress of the preshear has reached a plateau: the mean shear stress over
    /// the last tenth of the rows differs by at most 2 % from the mean over the preceding tenth.
    bool plateau = true;
    /// Bulk density of the sample with its liquid [kg/m^3], if the file states the bulk density.
    std::optional<double> bulk_density = {};
};

/// Linear yield locus: straight line fitted to the shear stresses and normal stresses at failure,
/// with the strengths and flow properties that follow from the line.
struct LinearYieldLocus {
    /// Cohesion [Pa]: shear stress of the yield locus at zero normal stress; 0 if the fitted
    /// intercept is negative.
    double cohesion = 0;
    /// Shear stress of the fitted line at zero normal stress [Pa]. The intercept may be negative.
    double intercept = 0;
    /// Angle of the fitted line (shear stress against normal stress) to the axis of normal stress
    /// [rad].
    double slope_angle = 0;
    /// Tensile strength [Pa]: normal stress -cohesion/slope at which the line reaches zero shear
    /// stress. The tensile strength is 0 if the cohesion is 0, and otherwise -infinity for a slope
    /// <= 0.
    double tensile_strength = 0;
    double unconfined_strength = 0;  ///< unconfined yield strength of the consolidated sample [Pa]
    /// Centre of the Mohr circle of the preshear, a normal stress [Pa]; empty without a preshear.
    std::optional<double> preshear_centre;
    /// Major principal stress of the preshear [Pa]; empty without a preshear.
    std::optional<double> major_principal_stress;
    /// Effective angle of internal friction [rad]; empty without a preshear.
    std::optional<double> effective_angle;
    /// Flowability: major principal stress of the preshear divided by unconfined yield strength
    /// [1]. The flowability is empty without a preshear, and infinite if the strength is 0.
    std::optional<double> flowability;
    std::string flow_class;  ///< class of flowability, such as "cohesive"; empty without a preshear
};

/// Fits a straight line to the normal stresses [Pa] and shear stresses [Pa] at points of failure by
/// ordinary least squares. The slope angle phi and the cohesion c of the line (0 if the intercept
/// is negative) give strengths and flow properties:
///     unconfined strength = 2 c cos(phi)/(1 - sin(phi))
///     (s - C)^2 + t^2 = (C sin(phi) + c cos(phi))^2 = r^2
/// The second equation gives the centre C (smaller root) and the radius r of a Mohr circle. The
/// circle passes through the preshear (normal stress s, shear stress t) and touches the line. If
/// the preshear is above the line, the circle touches the line at the normal stress s instead. The
/// major principal stress is C + r, and sin(effective angle) = r/C. The class of flowability is
/// "not flowing" below 1, "very cohesive" below 2, "cohesive" below 4, "easy-flowing" below 10, and
/// "free-flowing" from 10 on.
/// @throws std::invalid_argument if there are fewer than two different normal stresses
/// Source: Jenike, Bulletin 123, University of Utah (1964); Schulze, Powders and Bulk Solids
/// (2008).
LinearYieldLocus linear_yield_locus(const std::vector<double>& normal_stress,
                                    const std::vector<double>& shear_stress,
                                    const std::optional<PreshearPoint>& preshear);

/// Yield locus: points of failure after preshears of equal normal stress, with straight lines
/// fitted to the points.
struct YieldLocus {
    std::string test;  ///< name of the test to which the points of failure belong, from the file
    /// Preshear before the first point of failure, if recorded.
    std::optional<PreshearPoint> preshear;
    std::vector<FailurePoint> points;
    /// Linear yield locus: straight line fitted to the normal stresses and shear stresses at
    /// failure. Each point of failure is the data point with the largest shear stress of an
    /// interval. The member is empty if all points have equal normal stress.
    std::optional<LinearYieldLocus> line;
    /// Linear yield locus: straight line fitted to the normal stresses and shear stresses at
    /// failure. Each point of failure is the smoothed peak of the shear stress of an interval. The
    /// member is empty if all points have equal normal stress.
    std::optional<LinearYieldLocus> smoothed;
};

/// Returns the state at the end of a preshear: means over the last tenth of the preshear's rows.
/// @param series columns of the preshear, with shear stress and normal stress
PreshearPoint preshear_point(const IntervalSeries& series);

/// Returns the point of failure of an interval: the data point with the largest shear stress, and
/// the largest mean shear stress over a window of 1/30 of the rows, but at least five rows.
/// @param series columns of the interval, with shear stress and normal stress
/// @throws std::bad_optional_access if the interval has no row with both stresses
FailurePoint failure_point(const Block& block, const IntervalSeries& series);

/// Returns the yield loci of a file. Each yield locus has the points of failure of one test after
/// preshears with equal normal stress (within 5 %). Intervals without stresses are left out.
/// @param series columns of each interval, in the order of the file's blocks
/// @param roles role of each interval, in the order of the file's blocks
std::vector<YieldLocus> yield_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const std::vector<IntervalRole>& roles);

}  // namespace pendular
