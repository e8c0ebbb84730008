#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns the files of a new study made from files of measurements, or from the sheets of
/// workbooks, as a map from the name of each file to its text. Each file or sheet is an entry of
/// its own, and its tables have its number ("failure_2.csv").
/// - study.toml, in which "GUESS" marks guessed values, such as the density of the grains;
/// - a copy of each file of measurements that contains steady shear;
/// - steady.csv with the states at the end of the preshears, if there are any;
/// - failure.csv with the points of failure, if there are any; of a table with several groups of
///   points, a table of each group ("failure_Sand_A.csv"), of which the study reads the first and
///   the entries of the others are comments.
/// In steady.csv and failure.csv, an unknown solid fraction is stated as 0.60 +- 0.1 [1].
/// @throws InputError if the file contains neither steady shear nor points of failure, if the name
///         of the file contains a character that study.toml cannot contain or is the name of
///         another file of the study, or if neither number, name nor test tells an interval from
///         all intervals with other roles, such as "preshear"
std::map<std::string, std::string> begin_study(const std::vector<FileView>& views,
                                               const FileFormat& format);

}  // namespace pendular
