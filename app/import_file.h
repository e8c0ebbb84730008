#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/options.h"
#include "reports/figure.h"

namespace pendular::app {

/// Options of `pendular import FILE`, which state how the file is to be read and which files are to
/// be written. An empty path: nothing is written.
struct ImportFileOptions {
    std::string layout, encoding, sheet, decimal;
    /// Names and units of the file's columns: header cells `name [unit]`, separated by semicolons,
    /// or an array as in study.toml.
    std::string columns;
    std::string study;              ///< folder of the new study that is made from the file
    std::string tidy;               ///< CSV file for all rows of the file in SI units
    std::string loci;               ///< CSV file for the results of all yield loci
    std::string figures;            ///< folder for the figures of the file or study
    bool prorate = false;           ///< whether points of failure are prorated
    bool wall = false;              ///< whether the file holds shear along a wall
    std::vector<std::string> more;  ///< further files, read as the first

    /// Adds the options to the command line of `pendular import`.
    void declare(Options& options);
    /// Checks, for the import of a study, that the user gave no option for a single file, such as
    /// --layout. The option --figures is allowed.
    /// @throws InputError if one was given; the message says that study.toml must state the setting
    void refuse_for_studies(const Options& options) const;
};

/// Whether a path names a single file of measurements rather than a study: an existing file whose
/// extension is not .toml.
bool is_bare_file(const std::filesystem::path& path);

/// Whether a path names a folder that is no study: one without study.toml.
bool is_folder_of_files(const std::filesystem::path& path);

/// Runs `pendular import FILE...`, or with all files of a folder where `path` is one, and returns
/// the exit code, that of wrong input if nothing of the files is used. Prints the layout, the
/// columns, the intervals and the faults of each file, and makes the new study that the user
/// requested, for which those of several files that cannot begin one are left out.
/// @throws InputError if the file cannot be read, if --layout or --decimal has an unknown value, if
///         the folder for the new study already contains a file of the new study, or if the file of
///         --tidy or --loci cannot be written or contains anything other than an earlier table
int import_file(const std::filesystem::path& path, const ImportFileOptions& options,
                Console& console);

}  // namespace pendular::app
