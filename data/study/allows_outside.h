#pragma once

#include <filesystem>

namespace pendular {

/// Whether a study may use files outside of its folder: value of the key allow_outside of
/// study.toml, or false if the key is missing.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError at file:line:column if study.toml cannot be read, has a syntax error or an
///         unknown key of the top level, or if the value of allow_outside is neither true nor false
bool allows_outside(const std::filesystem::path& study);

}  // namespace pendular
