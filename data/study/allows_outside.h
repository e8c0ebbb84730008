#pragma once

#include <filesystem>

namespace pendular {

/// Whether a study may use files outside of its folder: allow_outside of study.toml, by default
/// false.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError if study.toml cannot be read, or has an error of syntax or of its top level
bool allows_outside(const std::filesystem::path& study);

}  // namespace pendular
