#pragma once

#include <vector>

#include "data/recordings/time_series.h"

namespace pendular::closures {

/// Value of a quantity of dry flow at an inertial number.
struct InertialPoint {
    double inertial_number = 0;  ///< inertial number I [1], above 0
    double value = 0;            ///< value of the quantity, in its unit
    double standard_error = 0;   ///< standard error of `value`, above 0
};

/// Fitted law of a quantity y (stress ratio or solid fraction) of dry flow against the inertial
/// number I,
///     y = limit + amplitude I^exponent.
struct InertialLaw {
    Mean limit;       ///< quasi-static limit of y, in its unit
    Mean amplitude;   ///< in the unit of y
    Mean exponent;    ///< exponent of I [1]
    double chi2 = 0;  ///< sum of squared residuals over standard errors [1]
    int dof = 0;      ///< number of points minus 3
};

/// Fits the law to points of one friction by weighted least squares, all three parameters free. The
/// exponent depends on friction: it is about 0.4 without friction, where flow changes fastest as I
/// falls, and 0.8 to 1.2 from a friction of 0.05 on. The error of the limit includes that of the
/// exponent.
/// @throws std::invalid_argument where there are fewer than 4 points or 3 inertial numbers
/// Source: Peyneau and Roux, Phys. Rev. E 78 (2008) 011307, for grains without friction.
InertialLaw fit_inertial_law(const std::vector<InertialPoint>& points);

}  // namespace pendular::closures
