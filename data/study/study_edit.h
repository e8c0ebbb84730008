#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pendular {

/// Returns the text of study.toml with an effect added at the end of the list `effects`
/// in [model]; [model] and the list are added if missing. All other bytes, comments and the style
/// of line ends are preserved. `file` names the file in error messages.
/// @throws InputError if the text is not TOML, if the effect is in the list already, or if the
///         layout of the list cannot be edited safely; the message says what to write by hand
std::string with_effect(const std::string& text, const std::string& file, std::string_view name);

/// Returns the text of study.toml with an effect removed from the list `effects` in [model]. All
/// other bytes and comments are preserved. `file` names the file in error messages.
/// @throws InputError if the text is not TOML, if the effect is not in the list, or if the layout
///         of the list cannot be edited safely
std::string without_effect(const std::string& text, const std::string& file, std::string_view name);

/// Replaces the text of a study's file study.toml by `text`, as a whole or not at all.
/// @throws std::runtime_error if the file cannot be written, naming the file and the system's
///         reason
void replace_study(const std::filesystem::path& file, const std::string& text);

}  // namespace pendular
