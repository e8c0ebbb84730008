#pragma once

#include <filesystem>

#include "data/study.h"

namespace pendular::app {

/// A study with everything measured in it.
struct StudyInput {
    Study study;
    Measurements measurements;
};
/// @throws InputError for what is wrong in its files, its effects included
StudyInput read_input(const std::filesystem::path& study);

}  // namespace pendular::app
