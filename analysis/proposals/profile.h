#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Quantity, such as the normal stress, along which a change of unknown cause may vary.
struct ReadingCoordinate {
    std::string variable;  ///< name of the quantity in formulas, as in "normal_stress"
    std::string unit;      ///< SI unit
    Eigen::VectorXd at;    ///< value at each reading [unit]
};

/// Returns the coordinates along which a change may vary: normal stress, inertial number or angular
/// velocity, liquid content and time, if the largest value exceeds the smallest by more than a
/// tenth.
/// @param of_instrument whether the angular velocity replaces the inertial number, for a change
///        that acts on the instrument
/// @throws std::bad_optional_access if `of_instrument` is true and the study has no cell
std::vector<ReadingCoordinate> coordinates_of(const std::vector<Reading>& readings,
                                              const Study& study, bool of_instrument);

/// Dependence of the size of a change on a coordinate x, with a constant c and the largest and
/// smallest x of the readings (for powers and the logarithm, of the readings with x > 0).
enum class Dependence {
    none,        ///< size 1 at all readings
    power,       ///< size (x/x_max)^c, or (x/x_min)^c if c is negative
    logarithm,   ///< size ln(x/x_min)/ln(x_max/x_min)
    above,       ///< size 1 if x > c, else 0
    below,       ///< size 1 if x < c, else 0
    beyond,      ///< size (x - c)/(x_max - c) if x > c, else 0
    short_of,    ///< size (c - x)/(c - x_min) if x < c, else 0
    decay,       ///< size exp(-x/c)
    oscillation  ///< size sin(2 pi x/c + phase)
};

/// Relative size of a change at each reading [1], at most 1, as a function of one coordinate.
struct Profile {
    Dependence dependence = Dependence::none;
    std::string variable;   ///< of the coordinate; empty if `dependence` is `none`
    std::string unit;       ///< of the coordinate
    double constant = 0;    ///< c [unit]; of a power, the exponent [1]; of the logarithm, x_min
    double phase = 0;       ///< of an oscillation [rad]
    double full_at = 0;     ///< x at which a power, the logarithm or a kink has the size 1 [unit]
    Eigen::VectorXd along;  ///< coordinate at each reading [unit]
    Eigen::VectorXd at;     ///< size at each reading [1]
    double penalty = 0;     ///< 2 ln n, added to chi2 [1]: one of n profiles of its kind was chosen

    /// Returns the size as a formula of study.toml, such as "exp(-time/600)".
    std::string formula() const;
};

/// Returns the profile of the size 1 at all readings.
Profile same_everywhere(std::size_t readings);

/// Returns the profiles to try along one coordinate: powers, a logarithm, and steps and kinks
/// between its values. Along the time, a linear change, decays and, if wanted, oscillations replace
/// the powers and the logarithm.
std::vector<Profile> profiles_along(const ReadingCoordinate& coordinate, bool oscillations);

/// Returns oscillations close to an oscillation, with period and phase varied in small steps; none
/// for other profiles.
std::vector<Profile> finer_profiles(const Profile& profile, const ReadingCoordinate& coordinate);

}  // namespace pendular
