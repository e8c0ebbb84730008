#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "data/recordings/measurements.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Study with its measurements.
struct StudyInput {
    ResolvedStudy study;
    Measurements measurements;
    std::string text = {};  ///< text of study.toml as it was read
};

/// @throws InputError for what is wrong in its files, its effects included
StudyInput read_input(const std::filesystem::path& file);

/// Folder of a study that is named by the folder or by its study.toml.
std::filesystem::path study_folder(const std::filesystem::path& study);

/// Places that a command writes to.
struct OutputPlaces {
    std::filesystem::path folder;              ///< for results, as --out names it
    std::vector<std::filesystem::path> files;  ///< in it: files, or folders all of whose files may
                                               ///< be written
    std::optional<std::string> json;           ///< what --json names, "-" for standard output
};

/// Refuses to write onto what a study was read from, study.toml and the files it names, links to
/// them included, and files that one of its patterns would read as a measurement.
/// @throws InputError naming both, and what to do
void protect_inputs(const Study& study, const OutputPlaces& outputs);

/// The study whose results go to these places, with its inputs protected from them.
/// @throws InputError for what is wrong in its files, its effects included, and as `protect_inputs`
StudyInput read_input(const std::filesystem::path& file, const OutputPlaces& outputs);

}  // namespace pendular
