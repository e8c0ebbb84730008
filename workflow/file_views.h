#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"

// Files of measurements as they are, before they belong to a study.
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

/// Reads files that a user names to begin a study, as `views_of_files` does. Notes among them,
/// texts without a line of numbers, are left out, as a pattern of the shell may name them too.
/// @throws InputError if a file that is no note cannot be read, or if all are notes
SheetViews views_of_named_files(const std::vector<std::filesystem::path>& paths,
                                const FileFormat& format);

/// Whether a study can begin with a file: it has points of failure, or steady shear with all that a
/// recording needs.
bool begins_study(const FileView& view);

/// Whether anything of a file is used: a study can begin with it, or it has ends of preshears or a
/// wall yield locus.
bool is_used(const FileView& view);

/// Whether the normal force of a file is negative in nearly all rows, so that no row becomes a
/// reading.
bool is_recorded_in_tension(const FileView& view);

/// Whether a file has intervals of steady shear under compression with all that a recording needs.
bool has_steady_recording(const FileView& view);

/// Returns what a column that is not used may be, in words: "the torque, or the shear stress".
std::string possible_meanings(const BlockColumn& column, const FileView& view);

/// @throws InputError that says what a file lacks to begin a study with
[[noreturn]] void refuse_to_begin(const FileView& view);

}  // namespace pendular
