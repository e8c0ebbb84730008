#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/measurements.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Study with its measurements, as read from files.
struct StudyInput {
    ResolvedStudy study;
    Measurements measurements;
    std::string text = {};  ///< text of study.toml as it was read
};

/// Reads a study and its recordings.
/// @param file study.toml, or the folder that contains it
/// @throws InputError where a file of the study or an effect that it lists is wrong
StudyInput read_input(const std::filesystem::path& file);

/// Path of the folder of a study, given the path of that folder or of the study.toml in it.
std::filesystem::path study_folder(const std::filesystem::path& study);

/// Files and folders to which a command writes.
struct OutputPlaces {
    /// Folder to which the command writes its results.
    std::filesystem::path folder;
    /// Paths in `folder` that the command writes to: files, and folders in which it creates files
    /// whose names are not known beforehand.
    std::vector<std::filesystem::path> files;
    /// File that option --json names; "-": standard output; empty: no JSON.
    std::optional<std::string> json;
};

/// Checks, before a long computation, that output replaces none of the files that a study was read
/// from (study.toml, its recordings, and links to these files), that no link leads an output out of
/// the results folder, and that no `file` pattern of the study would read an output as a
/// measurement.
/// @throws InputError where an output would replace an input, leave the folder or match a pattern;
///         the message says what to do
void protect_inputs(const Study& study, const OutputPlaces& outputs);

/// Reads a study and its recordings, after checking that the files which a command will write
/// (`outputs`) do not replace them.
/// @param file study.toml, or the folder that contains it
/// @throws InputError if a file of the study or the definition of a listed effect is invalid, or if
///         an output would replace a file of the study or match the pattern of its recordings
StudyInput read_input(const std::filesystem::path& file, const OutputPlaces& outputs);

/// Returns the shear cell that study.toml in the folder of `file` describes. Empty where study.toml
/// does not exist, cannot be read or describes no cell.
std::optional<AnnularCell> cell_beside(const std::filesystem::path& file);

}  // namespace pendular
