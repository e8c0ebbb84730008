#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Quantity, such as the normal stress, on which a difference of unknown cause between readings and
/// model may depend, with the value of the quantity at each reading.
struct ReadingCoordinate {
    std::string variable;  ///< name of the quantity in formulas, as in "normal_stress"
    std::string unit;      ///< SI unit of the quantity
    Eigen::VectorXd at;    ///< value of the quantity at each reading [unit]
};

/// Returns the quantities of the readings along which a change of unknown cause may vary: normal
/// stress, inertial number or angular velocity, liquid content, and time. A quantity is returned
/// only if its largest value exceeds its smallest value by more than a tenth.
/// @param of_instrument whether the change acts on the instrument; if true, the list may contain
///        the angular velocity, otherwise the inertial number
/// @throws std::bad_optional_access if `of_instrument` is true and the study has no cell
std::vector<ReadingCoordinate> coordinates_of(const std::vector<Reading>& readings,
                                              const Study& study, bool of_instrument);

/// Dependence of the size of a change on a coordinate x of the readings, such as the time. c is a
/// constant. x_max and x_min are the largest and the smallest x of the readings (for powers and the
/// logarithm, of the readings with x > 0).
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

/// Profile of a change of unknown cause: relative size of the change at each reading [1], at most
/// 1, as a function of one coordinate of the readings, such as the time.
struct Profile {
    Dependence dependence = Dependence::none;
    /// Name of the coordinate in formulas. Empty if `dependence` is `none`.
    std::string variable;
    std::string unit;  ///< SI unit of the coordinate
    /// Constant c of the formula of `dependence` (see `Dependence`) [unit of the coordinate]. For a
    /// power, c is the exponent [1]. For the logarithm, c is x_min.
    double constant = 0;
    /// Phase of the oscillation [rad]. Unused if `dependence` is not `oscillation`.
    double phase = 0;
    /// Value of the coordinate (such as the normal stress) at which the profile has the size 1
    /// [unit of the coordinate]. 0 if the formula of `dependence` contains no such value.
    double full_at = 0;
    /// Value of the coordinate at each reading [unit of the coordinate].
    Eigen::VectorXd along;
    Eigen::VectorXd at;  ///< size of the change at each reading [1]
    /// Penalty [1] to be added to chi2, since the profile was chosen among n profiles of its kind:
    /// 2 ln n.
    double penalty = 0;

    /// Returns the size of the change as a formula of the coordinate, in the syntax of study.toml,
    /// such as "exp(-time/600)".
    std::string formula() const;
};

/// Returns the profile of a change that is equal at all readings.
/// @param readings number of readings
Profile same_everywhere(std::size_t readings);

/// Returns the profiles (dependences of the size of a change on a coordinate of the readings) to
/// try along one coordinate, such as the normal stress. The profiles are powers, a logarithm, and
/// steps and kinks between the values of the coordinate. Along the time, a linear change, decays
/// and, if `oscillations` is true, oscillations replace the powers and the logarithm.
std::vector<Profile> profiles_along(const ReadingCoordinate& coordinate, bool oscillations);

/// Returns oscillations close to the oscillation `profile`, with period and phase varied in small
/// steps. Empty if `profile` is not an oscillation.
std::vector<Profile> finer_profiles(const Profile& profile, const ReadingCoordinate& coordinate);

}  // namespace pendular
