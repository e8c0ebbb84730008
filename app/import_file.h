#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/options.h"
#include "reports/figure.h"

namespace pendular::app {

/// Options of `pendular import FILE`, which state how the file is to be read and which files are to
/// be written.
struct ImportFileOptions {
    std::string layout, encoding, sheet, decimal;
    /// Names and units of the file's columns as the user states them: header cells `name [unit]`,
    /// separated by semicolons, or an array as in study.toml.
    std::string columns;
    /// Folder of the new study that is made from the file. If the text is empty, no study is made.
    std::string study;
    /// CSV file to which all rows of the file are written in SI units. If the text is empty, no CSV
    /// file is written.
    std::string tidy;
    /// Folder for the figures of the file or study. If the text is empty, no figures are drawn.
    std::string figures;

    /// Adds the options to the command line of `pendular import`.
    void declare(Options& options);
    /// Checks, for the import of a study, that the user gave no option that applies to a single
    /// file only, such as --layout. The option --figures is allowed.
    /// @throws InputError if an option for a single file was given; the message says that
    ///         study.toml must state the setting instead
    void refuse_for_studies(const Options& options) const;
};

/// Draws figures to files in a folder, and prints the names of the figures on the console.
void draw_all(const std::vector<Figure>& figures, const std::filesystem::path& folder,
              Console& console);

/// Whether a path names a single file of measurements rather than a study: an existing file whose
/// extension is not .toml.
bool is_bare_file(const std::filesystem::path& path);

/// Runs `pendular import FILE` and returns the exit code. Prints the layout, the columns, the
/// intervals (steps of constant set points) and the faults of a file of measurements. If the user
/// requested a new study, makes the study from the file.
/// @throws InputError if the file cannot be read, if --layout or --decimal has an unknown value, if
///         the folder for the new study already contains a file of the new study, or if the file of
///         --tidy cannot be written or contains anything other than an earlier table of --tidy
int import_file(const std::filesystem::path& path, const ImportFileOptions& options,
                Console& console);

}  // namespace pendular::app
