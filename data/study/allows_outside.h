#pragma once

#include <filesystem>

namespace pendular {

/// Whether a study permits files outside of its folder (`allow_outside`).
/// @param study folder of the study, or its study.toml
/// @throws InputError at file:line:column for a syntax error, an unknown key of the top level, and
///         a value that is not true or false
bool allows_outside(const std::filesystem::path& study);

}  // namespace pendular
