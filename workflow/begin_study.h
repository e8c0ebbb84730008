#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns the files of a new study that is made from one file of measurements, as a map from the
/// name of each file to its text. The files are study.toml, a copy of the file of measurements if
/// it contains steady shear, steady.csv with the states at the end of the preshears of a shear
/// test, and failure.csv with the points of failure. Values that the file of measurements does not
/// state, such as the density of the grains, are guessed. study.toml marks guessed values with
/// "GUESS" in a comment.
///
/// In steady.csv, each row is the mean over the last tenth of the data points of a preshear. If any
/// preshear reached a plateau, preshears without a plateau are left out. In failure.csv, each row
/// is a smoothed peak of the shear stress. The standard deviation of the shear stress is the
/// difference between the largest measured shear stress and the smoothed peak. Standard deviations
/// of the shear stress are at least 1 %. The tables state the inertial number 0 and a solid
/// fraction of 0.60 +- 0.1, which carries no information. If the file of measurements states bulk
/// densities, steady.csv contains bulk densities in place of solid fractions, with the mass of the
/// liquid subtracted and with a standard deviation of 1 %.
/// @param view file of measurements, as read
/// @param format user's settings for reading the file, such as the decimal sign
/// @throws InputError if the file contains neither steady shear nor points of failure, if the name
///         of the file contains a character that study.toml cannot contain, if the file has the
///         name of another file of the study, such as steady.csv, or if neither its number nor its
///         name nor its test distinguishes an interval from the intervals with other roles
std::map<std::string, std::string> begin_study(const FileView& view, const FileFormat& format);

}  // namespace pendular
