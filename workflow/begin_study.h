#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns the files of a new study that is made from one file of measurements: their texts by file
/// name. The files are study.toml, a copy of the file of measurements if it contains steady shear,
/// steady.csv with the states of preshear of a shear test, and failure.csv with its points of
/// failure. Values that the file of measurements does not state, such as the density of the grains,
/// are guessed; study.toml marks them with "GUESS" in a comment.
///
/// In steady.csv, each row is the mean over the last tenth of the rows of a preshear interval. In
/// failure.csv, each row is a smoothed peak of the shear stress; its standard deviation is the
/// difference between the largest sample and the smoothed peak. Standard deviations of shear stress
/// are at least 1 %. The tables state inertial number 0 and a solid fraction of 0.60 +- 0.1, which
/// carries no information. If the file of measurements states bulk densities, steady.csv contains
/// these in place of solid fractions, with the mass of the liquid subtracted and with a standard
/// deviation of 1 %.
/// @param view the file of measurements, as read
/// @param format how the user stated the file to be read, such as its decimal sign
/// @throws InputError where the file contains neither steady shear nor points of failure, where
///         study.toml cannot state its name, where its name is that of another file of the study,
///         and where neither number nor name nor test tells apart two of its intervals with
///         different roles
std::map<std::string, std::string> begin_study(const FileView& view, const FileFormat& format);

}  // namespace pendular
