#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/interval_roles.h"

namespace pendular {

/// Peak of the shear stress in an interval in which the sample was sheared to failure: at the data
/// point with the largest shear stress, and after smoothing.
struct FailurePoint {
    int interval = 0;                   ///< number in the file
    int line = 0;                       ///< of the data point in the file
    double normal_stress = 0;           ///< at the data point [Pa]
    double shear_stress = 0;            ///< largest of the interval [Pa]
    double smoothed_normal_stress = 0;  ///< mean around the smoothed peak [Pa]
    double smoothed_shear_stress = 0;   ///< largest after smoothing [Pa]
    /// Averaged rows of the interval, from `smoothed_begin` to `smoothed_end` - 1.
    std::size_t smoothed_begin = 0, smoothed_end = 0;
    /// Whether the peak is in the last 5 % of the rows: failure may not have been reached.
    bool at_end = false;
    std::optional<double> height;  ///< gap at the data point [m], if recorded
    std::optional<double> liquid_content = {};  ///< [1], if a table states it
    /// Mean shear stress of the locus's preshears over that of the point's own [1]; empty if they
    /// are not known or there is one preshear.
    std::optional<double> prorating = {};
};

/// State at the end of a preshear, the steady shear that consolidates the sample before it is
/// sheared to failure: means over the last tenth of the rows.
struct PreshearPoint {
    double normal_stress = 0;  ///< [Pa]
    /// [Pa]; NaN if a table of points states the normal stress alone, without which there is no
    /// Mohr circle.
    double shear_stress = 0;
    double shear_stress_deviation = 0;  ///< standard deviation over the last tenth [Pa]
    std::size_t begin = 0;              ///< index of the first row of the last tenth
    /// Whether the shear stress differs by at most 2 % from that over the preceding tenth.
    bool plateau = true;
    std::optional<double> bulk_density = {};  ///< with the liquid [kg/m^3], if the file states it
    /// Standard error of the shear stress [Pa], from the scatter between the preshears of the
    /// locus; empty for a single one.
    std::optional<double> shear_stress_error = {};
    std::optional<double> height = {};  ///< mean gap over the last tenth [m], if recorded
};

/// Standard errors of the results of a linear yield locus, from the scatter of its points about the
/// line and that of its preshears; those of results that the locus lacks are 0.
struct LocusErrors {
    double cohesion = 0;                ///< [Pa]
    double slope_angle = 0;             ///< [rad]
    double tensile_strength = 0;        ///< [Pa]
    double unconfined_strength = 0;     ///< [Pa]
    double major_principal_stress = 0;  ///< [Pa]
    double effective_angle = 0;         ///< [rad]
    double flowability = 0;             ///< [1]
};

/// Linear yield locus: straight line of shear stress against normal stress at failure, with the
/// strengths and flow properties that follow from it (`linear_yield_locus`). Whatever needs a
/// preshear is empty without one.
struct LinearYieldLocus {
    double cohesion = 0;     ///< the intercept, or 0 if that is negative [Pa]
    double intercept = 0;    ///< fitted shear stress at zero normal stress [Pa]
    double slope_angle = 0;  ///< [rad]
    /// -cohesion/slope [Pa], the normal stress at zero shear stress; 0 without cohesion, otherwise
    /// -infinity for a slope <= 0.
    double tensile_strength = 0;
    double unconfined_strength = 0;                ///< unconfined yield strength [Pa]
    std::optional<double> preshear_centre;         ///< centre C of its Mohr circle [Pa]
    std::optional<double> major_principal_stress;  ///< of the preshear [Pa]
    std::optional<double> effective_angle;         ///< of internal friction [rad]
    /// Major principal stress over unconfined strength [1]; infinite if the strength is 0.
    std::optional<double> flowability;
    std::string flow_class;  ///< class of flowability, such as "cohesive"
    /// Empty for fewer than four points: with one degree of freedom, the scatter is not known.
    std::optional<LocusErrors> errors;
};

/// Returns the straight line through points of failure [Pa] by ordinary least squares. Its slope
/// angle phi and cohesion c give strengths and flow properties:
///     unconfined strength = 2 c cos(phi)/(1 - sin(phi))
///     (s - C)^2 + t^2 = (C sin(phi) + c cos(phi))^2 = r^2
/// The second equation gives the centre C (smaller root) and the radius r of the Mohr circle that
/// passes through the preshear (normal stress s, shear stress t) and touches the line. If the
/// preshear is above the line, the circle touches the line at s instead. The major principal stress
/// is C + r, and sin(effective angle) = r/C. The class of flowability is "not flowing" below 1,
/// "very cohesive" below 2, "cohesive" below 4, "easy-flowing" below 10, and else "free-flowing".
///
/// The variance of intercept and slope is that of ordinary least squares, with the residual
/// variance over n - 2; other errors follow by first-order propagation with their covariance and
/// with the error of the shear stress of the preshear, where that is known.
/// @throws std::invalid_argument if there are fewer than two different normal stresses
/// Source: Jenike, Bulletin 123, University of Utah (1964); Schulze, Powders and Bulk Solids
/// (2008).
LinearYieldLocus linear_yield_locus(const std::vector<double>& normal_stress,
                                    const std::vector<double>& shear_stress,
                                    const std::optional<PreshearPoint>& preshear);

/// Points of failure of one test after preshears of equal normal stress. The lines through them are
/// empty if all points have equal normal stress.
struct YieldLocus {
    std::string test;  ///< name in the file
    /// Before the first point, if recorded; the mean over all points for a table of points, and if
    /// they are prorated.
    std::optional<PreshearPoint> preshear;
    bool prorated = false;  ///< whether the shear stresses of the points are times `prorating`
    std::vector<FailurePoint> points;
    std::optional<LinearYieldLocus> line;      ///< through the largest shear stresses
    std::optional<LinearYieldLocus> smoothed;  ///< through the smoothed peaks
};

/// Returns the state at the end of a preshear whose series has both stresses.
PreshearPoint preshear_point(const IntervalSeries& series);

/// Returns the point of failure of an interval. The smoothed shear stress is the largest mean over
/// a window of 1/30 of the rows, but at least five rows.
/// @throws std::bad_optional_access if the interval has no row with both stresses
FailurePoint failure_point(const Block& block, const IntervalSeries& series);

/// Returns the yield loci of a file. Points of failure share a locus if the normal stresses of
/// their preshears agree within 5 %. Intervals without stresses are left out.
/// @param series,roles in the order of the file's blocks
/// @param prorate whether to multiply the shear stresses of each locus by its points' `prorating`
/// Source of prorating: ASTM D6128 and D6773; Schulze, Powders and Bulk Solids (2008).
std::vector<YieldLocus> yield_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const std::vector<IntervalRole>& roles, bool prorate = false);

}  // namespace pendular
