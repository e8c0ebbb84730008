#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/options.h"
#include "reports/figure.h"

namespace pendular::app {

/// Options of `pendular import FILE`, which state how the file is to be read and what to write.
struct ImportFileOptions {
    std::string layout, encoding, sheet, decimal;
    /// Names and units of the file's columns as the user states them: header cells `name [unit]`,
    /// separated by semicolons.
    std::string columns;
    /// Folder of the new study that is made from the file; empty: no study is made.
    std::string study;
    /// CSV file to which all rows of the file are written in SI units; empty: no file is written.
    std::string tidy;
    /// Folder for the figures of the file or study; empty: no figures are drawn.
    std::string figures;

    /// Adds the options to the command line of `pendular import`.
    void declare(Options& options);
    /// Checks that the user gave none of the options for a single file when importing a study.
    /// @throws InputError where such an option was given; the message says that study.toml must
    ///         state the setting instead
    void refuse_for_studies(const Options& options) const;
};

/// Draws figures to a folder and prints their names on the console.
void draw_all(const std::vector<Figure>& figures, const std::filesystem::path& folder,
              Console& console);

/// Whether a path names a single file of measurements rather than a study: an existing file whose
/// extension is not .toml.
bool is_bare_file(const std::filesystem::path& path);

/// Runs `pendular import FILE`: prints layout, columns, intervals and checks of a file of
/// measurements, and makes a new study from it if the user asked for one. Returns the exit code.
/// @throws InputError where the file cannot be read, and where the folder for the new study
///         contains a study already
int import_file(const std::filesystem::path& path, const ImportFileOptions& options,
                Console& console);

}  // namespace pendular::app
