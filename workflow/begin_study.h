#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// Files of a study to begin with, by file name: study.toml and, for a yield locus, tables of its
/// states of preshear (steady.csv) and of its points of failure (failure.csv). Values that the file
/// does not state, such as the density of the grains, are guessed and marked with "GUESS" in a
/// comment.
///
/// A recording of steady shear is among the files, so that the study contains its data. A state of
/// preshear is the mean over the last tenth of the rows of an interval with role preshear. A point
/// of failure is the smoothed peak; its standard deviation is the difference between the largest
/// sample and the smoothed peak. All standard deviations are at least 1 %. Both tables are readings
/// at inertial number 0 with a solid fraction of 0.60 +- 0.1, which carries no information.
/// @param format how the user stated the file to be read
/// @throws InputError if the file shows neither steady shear nor points of failure, or has a name
///         that a study cannot hold
std::map<std::string, std::string> begin_study(const FileView& view, const FileFormat& format);

}  // namespace pendular
