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
/// In steady.csv, each row is the mean over the last tenth of the data points of a preshear. Only
/// preshears that reached a plateau are used if there are any. In failure.csv, each row is a
/// smoothed peak of the shear stress. The standard deviation of the shear stress is the difference
/// between the largest measured shear stress and the smoothed peak. Standard deviations of the
/// shear stress are at least 1 %. The tables state the inertial number 0 and a solid fraction of
/// 0.60 +- 0.1, which carries no information. If the file of measurements states bulk densities,
/// steady.csv contains bulk densities in place of solid fractions, with the mass of the liquid
/// subtracted and with a standard deviation of 1 %.
/// @param view file of measurements, as read
/// @param format user's statement of how the file is to be read, such as the decimal sign
/// @throws InputError where the file contains neither steady shear nor points of failure, where
///         study.toml cannot state the name of the file, where the file has the name of another
///         file of the study, and where neither number nor name nor test tells apart two intervals
///         with different roles
std::map<std::string, std::string> begin_study(const FileView& view, const FileFormat& format);

}  // namespace pendular
