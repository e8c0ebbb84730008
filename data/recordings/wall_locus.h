#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/interval_roles.h"

namespace pendular {

/// Stresses at which grains slide along a wall.
struct WallPoint {
    int line = 0;              ///< of the file, from 1
    double normal_stress = 0;  ///< [Pa]
    double shear_stress = 0;   ///< [Pa]
};

/// Standard errors of a wall yield locus, from the scatter of its points about its lines.
struct WallErrors {
    double coefficient = 0;  ///< [1]
    double adhesion = 0;     ///< [Pa]
    double slope = 0;        ///< [1]
};

/// Line of a wall yield locus that states the friction of the wall.
struct WallLine {
    double intercept = 0;    ///< shear stress at zero normal stress [Pa]
    double slope = 0;        ///< friction coefficient of the wall [1]
    double slope_error = 0;  ///< standard error [1]; 0 if not known
};

/// Wall yield locus: shear stress against normal stress of grains that slide along a wall.
struct WallLocus {
    std::string test;  ///< name in the file
    std::vector<WallPoint> points;
    /// Friction coefficient of the wall: slope of the line through the origin [1]. Its angle is the
    /// angle of wall friction.
    double coefficient = 0;
    double adhesion = 0;  ///< shear stress at zero normal stress of the line that fits best [Pa]
    double slope = 0;     ///< of that line [1]
    /// Empty for fewer than four points: with one degree of freedom, the scatter is not known.
    std::optional<WallErrors> errors;

    /// Whether grains adhere to the wall: the line that fits best meets the axis above zero, by
    /// more than its error allows by chance (97.5 %, Student's t).
    bool adheres() const;
    /// Whether it meets the axis as clearly below zero, as no grains do.
    bool below_origin() const;
    /// Returns the line that all outputs take: the best one if the grains adhere, else that through
    /// the origin.
    WallLine line() const;
};

/// Returns the wall yield loci of a file, one for each test with two different normal stresses: of
/// the intervals with the role "wall", each with the means over its last tenth.
///     coefficient = sum(s t)/sum(s^2)      s: normal stress, t: shear stress
/// Errors are those of ordinary least squares.
/// @param series,roles in the order of the file's blocks
/// Source: Schulze, Powders and Bulk Solids (2008); ASTM D6128.
std::vector<WallLocus> wall_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                 const std::vector<IntervalRole>& roles);

}  // namespace pendular
