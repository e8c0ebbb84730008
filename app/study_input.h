#pragma once

#include <filesystem>
#include <vector>

#include "app/options.h"
#include "data/study.h"

namespace pendular::app {

/// A study with everything measured in it.
struct StudyInput {
    Study study;
    Measurements measurements;
};

/// @throws InputError for what is wrong in its files, its effects included
StudyInput read_input(const std::filesystem::path& study);

/// Refuses to write onto what a study was read from: study.toml and the files it names, links to
/// them included. `outputs` are what a command writes, relative to its folder for results: files,
/// or folders all of whose files may be written; what --json names is checked as well.
/// @throws InputError naming both, and what to do
void protect_inputs(const Study& study, const CommonOptions& options,
                    const std::vector<std::filesystem::path>& outputs);

/// The study of a command that writes these `outputs`, with its inputs protected from them.
/// @throws InputError for what is wrong in its files, its effects included, and as `protect_inputs`
StudyInput read_input(const CommonOptions& options,
                      const std::vector<std::filesystem::path>& outputs);

}  // namespace pendular::app
