#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/options.h"
#include "reports/figure.h"

namespace pendular::app {

/// Options of `pendular import FILE`: how the file is to be read, and where a study is to begin.
struct ImportFileOptions {
    std::string layout, encoding, sheet, decimal;
    std::string columns;  ///< header cells `name [unit]`, separated by semicolons
    std::string study;    ///< folder of the study to begin; empty: none
    std::string tidy;     ///< CSV file for all rows in SI units; empty: none
    std::string figures;  ///< folder for figures, of a file or of a study; empty: none

    /// Declares the options for the command line.
    void declare(Options& options);
    /// @throws InputError if one of the options was given for a study, whose study.toml has them
    void refuse_for_studies(const Options& options) const;
};

/// Draws figures and names them on the console.
void draw_all(const std::vector<Figure>& figures, const std::filesystem::path& folder,
              Console& console);

/// Whether a path names a file of measurements rather than a study: a file that is no study.toml.
bool is_bare_file(const std::filesystem::path& path);

/// Prints what the program understands of a file of measurements, and begins a study with it if the
/// user asked for one. Returns the exit code.
/// @throws InputError if the file cannot be read, or the folder has a study already
int import_file(const std::filesystem::path& path, const ImportFileOptions& options,
                Console& console);

}  // namespace pendular::app
