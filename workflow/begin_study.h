#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Views of a file of measurements, or of the chosen sheets of a workbook.
struct SheetViews {
    std::vector<FileView> views;
    std::vector<std::string> not_read;  ///< sentences on sheets that are not read
};

/// Reads a file of measurements, or the sheets of a workbook that `format` chooses.
/// @throws InputError if nothing can be read, or a sheet that `format` chooses cannot
SheetViews views_of_file(const std::filesystem::path& path, const FileFormat& format);

/// Reads files of measurements, one after the other, as `views_of_file`.
SheetViews views_of_files(const std::vector<std::filesystem::path>& paths,
                          const FileFormat& format);

/// Reads files of a folder as `views_of_files` does; those with which no study can begin are left
/// out, and `not_read` says why. A single file is read even so.
/// @throws InputError if no study can begin with any of them
SheetViews views_to_begin_with(const std::vector<std::filesystem::path>& paths,
                               const FileFormat& format);

/// Returns the files of a new study made from files of measurements, or from the sheets of
/// workbooks, as a map from the name of each file to its text. Each file or sheet is an entry of
/// its own, and its tables have its number ("failure_2.csv").
/// - study.toml, in which "GUESS" marks guessed values, such as the density of the grains;
/// - a copy of each file of measurements that contains steady shear;
/// - steady.csv with the states at the end of the preshears, if there are any;
/// - failure.csv with the points of failure, if there are any.
/// In steady.csv and failure.csv, an unknown solid fraction is stated as 0.60 +- 0.1 [1].
/// @throws InputError if the file contains neither steady shear nor points of failure, if the name
///         of the file contains a character that study.toml cannot contain or is the name of
///         another file of the study, or if neither number, name nor test tells an interval from
///         all intervals with other roles, such as "preshear"
std::map<std::string, std::string> begin_study(const std::vector<FileView>& views,
                                               const FileFormat& format);

/// Whether a study can begin with a file: it has points of failure, or steady shear with all that a
/// recording needs.
bool begins_study(const FileView& view);

/// Whether anything of a file is used: a study can begin with it, or it has ends of preshears or a
/// wall yield locus.
bool is_used(const FileView& view);

/// Returns the data points of all intervals of a file of measurements as one CSV table in SI units.
/// The first row contains the names of the columns, the second their units: test, number and role
/// of the interval, line of the file, and every quantity that an interval contains. Cells without a
/// value are empty. Of several sheets, the test begins with the name of the sheet. Origin and
/// pandas (header=[0, 1]) can read the table.
std::string tidy_table(const std::vector<FileView>& views);

}  // namespace pendular
