#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// Folder of a study, from the path of the folder or of its study.toml.
std::filesystem::path study_folder(const std::filesystem::path& study);

/// Places to which a command writes.
struct OutputPlaces {
    std::filesystem::path folder;  ///< folder for results, option --out
    /// Files in `folder` that are written, and folders in it in which any file may be written.
    std::vector<std::filesystem::path> files;
    std::optional<std::string> json;  ///< file of the option --json; "-": standard output
};

/// Checks, before long work, that output replaces none of the files that a study was read from
/// (study.toml, its recordings, and links to these files), and that no `file` pattern of the study
/// would read an output as a measurement.
/// @throws InputError where it does, naming the output, the input or pattern, and what to do
void protect_inputs(const Study& study, const OutputPlaces& outputs);

/// Reads a study and its recordings, after checking that output does not overwrite them.
/// @param file study.toml, or the folder that contains it
/// @throws InputError where a file of the study or an effect that it lists is wrong, and whatever
///         `protect_inputs` throws
StudyInput read_input(const std::filesystem::path& file, const OutputPlaces& outputs);

}  // namespace pendular
