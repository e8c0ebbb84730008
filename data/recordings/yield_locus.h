#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/interval_roles.h"

namespace pendular {

/// Point of failure of one interval that was sheared to failure.
struct FailurePoint {
    int interval = 0;                   ///< number of the interval in the file
    int line = 0;                       ///< line of the sample with the largest shear stress
    double normal_stress = 0;           ///< normal stress of this sample [Pa]
    double shear_stress = 0;            ///< largest shear stress of a sample [Pa]
    double smoothed_normal_stress = 0;  ///< mean normal stress around the smoothed peak [Pa]
    double smoothed_shear_stress = 0;   ///< largest shear stress after smoothing [Pa]
    /// Rows, from 0, that the smoothed peak averages: [smoothed_begin, smoothed_end).
    std::size_t smoothed_begin = 0, smoothed_end = 0;
    /// Whether the largest shear stress is in the last 5 % of the rows, so that failure may not
    /// have been reached.
    bool at_end = false;
    std::optional<double> height;  ///< gap at the sample [m], if recorded
};

/// State of steady shear before the intervals that are sheared to failure.
struct PreshearPoint {
    double normal_stress = 0;  ///< mean over the last tenth of the preshear's rows [Pa]
    double shear_stress = 0;   ///< mean over the last tenth of the preshear's rows [Pa]
    /// Standard deviation of the shear stress over these rows [Pa].
    double shear_stress_deviation = 0;
    std::size_t begin = 0;  ///< first of these rows, from 0
    /// Whether the shear stress has reached a plateau: its mean over these rows differs by at most
    /// 2 % from that over as many rows before them.
    bool plateau = true;
    std::optional<double> bulk_density = {};  ///< stated by the file, with liquid [kg/m^3]
};

/// Straight line through points of failure, with what follows from it.
struct LinearYieldLocus {
    double cohesion = 0;             ///< intercept [Pa]; 0 where it is negative
    double intercept = 0;            ///< intercept of the fitted line [Pa]
    double slope_angle = 0;          ///< angle of the fitted line [rad]
    double tensile_strength = 0;     ///< -cohesion/slope [Pa]; -infinity for a slope <= 0
    double unconfined_strength = 0;  ///< unconfined yield strength [Pa]
    /// Centre of the Mohr circle of the preshear on the axis of normal stress [Pa]; empty without a
    /// preshear.
    std::optional<double> preshear_centre;
    /// Major principal stress of the preshear [Pa]; empty without a preshear.
    std::optional<double> major_principal_stress;
    std::optional<double> effective_angle;  ///< effective angle of internal friction [rad]
    std::optional<double> flowability;      ///< major principal stress over unconfined strength [1]
    std::string flow_class;                 ///< class of flowability; empty without a preshear
};

/// Fits a line to points (normal stress, shear stress) [Pa] by ordinary least squares.
///     unconfined strength = 2 c cos(phi)/(1 - sin(phi))
/// The Mohr circle of the preshear (normal stress s, shear stress t) is tangent to the line: its
/// centre C is the smaller root of (s - C)^2 + t^2 = (C sin(phi) + c cos(phi))^2, its radius is
/// r = C sin(phi) + c cos(phi), the major principal stress C + r, and sin(effective angle) = r/C.
/// If the preshear is above the line, the circle touches the line at the normal stress s instead.
/// A negative intercept means cohesion 0. Classes of flowability: below 1 not flowing, 2 very
/// cohesive, 4 cohesive, 10 easy-flowing, else free-flowing.
/// @throws std::invalid_argument if there are fewer than two different normal stresses
/// Source: Jenike, Bulletin 123, University of Utah (1964); Schulze, Powders and Bulk Solids
/// (2008).
LinearYieldLocus linear_yield_locus(const std::vector<double>& normal_stress,
                                    const std::vector<double>& shear_stress,
                                    const std::optional<PreshearPoint>& preshear);

/// Points of failure that share a preshear, with the lines through them.
struct YieldLocus {
    std::string test;                       ///< test of the file that the points belong to
    std::optional<PreshearPoint> preshear;  ///< preshear of the first point, if it was recorded
    std::vector<FailurePoint> points;
    std::optional<LinearYieldLocus> line;      ///< through the samples of largest shear stress
    std::optional<LinearYieldLocus> smoothed;  ///< through the smoothed peaks
};

/// State at the end of a preshear, which has shear and normal stress.
PreshearPoint preshear_point(const IntervalSeries& series);

/// Point of failure of an interval with shear and normal stress. The smoothed peak is that of the
/// mean over a window of 1/30 of the rows, at least five.
/// @throws std::invalid_argument if the interval has no row with both stresses
FailurePoint failure_point(const Block& block, const IntervalSeries& series);

/// Yield loci of a file: intervals with role failure, grouped by test and by the normal stress of
/// the preshear before them (within 5 %). Intervals without stresses are left out.
std::vector<YieldLocus> yield_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const std::vector<IntervalRole>& roles);

}  // namespace pendular
