#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pendular {

/// Returns the text of study.toml with an effect added at the end of the list `effects` in the
/// table [model]. A missing table or list is added. All other text, comments and line ends are
/// preserved.
/// @param file path of study.toml, for error messages
/// @param name name of the effect
/// @throws InputError if the text is not TOML, if the list already contains the effect, or if the
///         layout of the list cannot be edited safely. In the last case, the message says what to
///         write by hand.
std::string with_effect(const std::string& text, const std::string& file, std::string_view name);

/// Returns the text of study.toml with an effect removed from the list `effects` in the table
/// [model]. All other text and comments are preserved.
/// @param file path of study.toml, for error messages
/// @param name name of the effect
/// @throws InputError if the text is not TOML, if the effect is not in the list, or if the layout
///         of the list cannot be edited safely
std::string without_effect(const std::string& text, const std::string& file, std::string_view name);

/// Returns a text as a string of TOML, in quotes, with escapes for the characters that need them.
std::string toml_string(const std::string& text);

/// Replaces the content of a study's file study.toml by a new text, completely or not at all.
/// @param file path of study.toml
/// @throws InputError if the path is a symbolic link out of its folder
/// @throws std::runtime_error if the file cannot be written. The message names the file and the
///         system's reason.
void replace_study(const std::filesystem::path& file, const std::string& text);

}  // namespace pendular
