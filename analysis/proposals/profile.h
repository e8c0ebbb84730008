#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Quantity of the readings along which an unknown change of the model may vary, such as the normal
/// stress.
struct ReadingCoordinate {
    std::string variable;  ///< name of the quantity in formulas, as in "normal_stress"
    std::string unit;      ///< SI unit of the quantity
    Eigen::VectorXd at;    ///< value at each reading [unit]
};

/// Returns the quantities of the readings along which a change may vary: normal stress, inertial
/// number or angular velocity, liquid content and time, as far as they vary by more than a tenth.
/// @param of_instrument whether the change acts on the instrument, whose formulas contain the
///        angular velocity; other formulas contain the inertial number
/// @throws std::bad_optional_access if `of_instrument` and the study has no cell
std::vector<ReadingCoordinate> coordinates_of(const std::vector<Reading>& readings,
                                              const Study& study, bool of_instrument);

/// Way in which the size of a change depends on a coordinate x of the readings, such as time. c is
/// a constant; x_max and x_min are the largest and the smallest x of the readings (for powers and
/// the logarithm, of the readings with x > 0).
enum class Dependence {
    none,        ///< 1, equal at all readings
    power,       ///< (x/x_max)^c, or (x/x_min)^c if c is negative
    logarithm,   ///< ln(x/x_min)/ln(x_max/x_min)
    above,       ///< 1 if x > c, else 0
    below,       ///< 1 if x < c, else 0
    beyond,      ///< (x - c)/(x_max - c) if x > c, else 0
    short_of,    ///< (c - x)/(c - x_min) if x < c, else 0
    decay,       ///< exp(-x/c)
    oscillation  ///< sin(2 pi x/c + phase)
};

/// Size of a change at each reading [1], at most 1, as a function of one coordinate of the
/// readings, such as time.
struct Profile {
    Dependence dependence = Dependence::none;
    std::string variable;  ///< name of the coordinate in formulas; empty for `none`
    std::string unit;      ///< SI unit of the coordinate
    /// Constant c of the formula of `dependence` (see `Dependence`) [unit of the coordinate; 1 for
    /// a power].
    double constant = 0;
    /// Phase of the oscillation [rad]; used only if the dependence is an oscillation.
    double phase = 0;
    /// Value of the coordinate at which the size is 1 [unit of the coordinate]; 0 if the formula of
    /// `dependence` contains no such value.
    double full_at = 0;
    /// Value of the coordinate at each reading [unit of the coordinate].
    Eigen::VectorXd along;
    Eigen::VectorXd at;  ///< size of the change at each reading [1]
    /// Penalty to be added to chi2 because this profile was chosen among n profiles of its kind
    /// [1]: 2 ln n.
    double price = 0;

    /// Returns the size of the change as a formula of the coordinate, as study.toml can contain it,
    /// such as "exp(-time/600)".
    std::string formula() const;
};

/// Returns the profile of a change that is equal at all readings.
/// @param readings number of readings
Profile same_everywhere(std::size_t readings);

/// Returns the profiles (ways in which the size of a change depends on a coordinate of the
/// readings) that are tried along one coordinate. They are powers, a logarithm, and steps and kinks
/// between the values of the coordinate. Along time, a linear change, decays and, if
/// `oscillations`, oscillations replace powers and logarithm.
std::vector<Profile> profiles_along(const ReadingCoordinate& coordinate, bool oscillations);

/// Returns oscillations near the oscillation `profile`, with period and phase varied in small
/// steps; empty if `profile` is not an oscillation.
std::vector<Profile> finer_profiles(const Profile& profile, const ReadingCoordinate& coordinate);

}  // namespace pendular
