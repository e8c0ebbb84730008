#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Quantity of the readings along which a change may vary, such as the normal stress.
struct ReadingCoordinate {
    std::string variable;  ///< name of the quantity as a variable of formulas, "normal_stress"
    std::string unit;      ///< SI unit of the quantity
    Eigen::VectorXd at;    ///< value at each reading [unit]
};

/// Quantities of the readings that vary by more than a tenth, as coordinates for formulas on the
/// instrument if `of_instrument`, else for formulas on the flow or on grains and liquid.
std::vector<ReadingCoordinate> coordinates_of(const std::vector<Reading>& readings,
                                              const Study& study, bool of_instrument);

/// Way in which a change depends on a coordinate x; c is a constant and x_max, x_min are the
/// largest and the smallest x of the readings (x > 0 only).
enum class Dependence {
    none,        ///< 1: the same at all readings
    power,       ///< (x/x_max)^c, or (x/x_min)^c where c is negative
    logarithm,   ///< ln(x/x_min)/ln(x_max/x_min)
    above,       ///< 1 where x > c, else 0
    below,       ///< 1 where x < c, else 0
    beyond,      ///< (x - c)/(x_max - c) where x > c, else 0
    short_of,    ///< (c - x)/(c - x_min) where x < c, else 0
    decay,       ///< exp(-x/c)
    oscillation  ///< sin(2 pi x/c + phase)
};

/// Dependence of a change on one coordinate of the readings, with size at most 1 at the readings.
struct Profile {
    Dependence dependence = Dependence::none;
    std::string variable;  ///< coordinate, as variable of formulas; empty for `none`
    std::string unit;      ///< SI unit of the coordinate
    double constant = 0;   ///< c of `Dependence` [unit, or 1 for a power]
    double phase = 0;      ///< phase of an oscillation [rad]
    /// Value of the coordinate at which the size is 1 [unit]; 0 where there is no such value.
    double full_at = 0;
    Eigen::VectorXd along;  ///< value of the coordinate at each reading [unit]
    Eigen::VectorXd at;     ///< size of the change at each reading [1]
    /// Price of the choice among n profiles of this kind: 2 ln n, to be added to chi2 [1].
    double price = 0;

    /// The profile as a formula of its coordinate, such as "(normal_stress/3000)^0.5".
    std::string formula() const;
};

/// Profile of a change that is the same at all `readings`.
Profile same_everywhere(std::size_t readings);

/// Profiles along a coordinate: powers, a logarithm, steps and kinks between its values and, in
/// time, decays and, if `oscillations`, oscillations.
std::vector<Profile> profiles_along(const ReadingCoordinate& coordinate, bool oscillations);

/// Oscillations near `profile`, with period and phase varied in small steps; empty where `profile`
/// is no oscillation.
std::vector<Profile> finer_profiles(const Profile& profile, const ReadingCoordinate& coordinate);

}  // namespace pendular
