#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pendular {

/// Returns the text of study.toml with an effect added at the end of the list `effects` in [model].
/// A missing table or list is added. All other text, comments and line ends are preserved: the
/// edit is made in the bytes of the text and checked by parsing the result.
/// @param file path of study.toml, for error messages
/// @throws InputError if the text is not TOML, if the list already contains the effect, or, with
///         what to write by hand, if the layout of the list cannot be edited safely
std::string with_effect(const std::string& text, const std::string& file, std::string_view name);

/// Returns the text of study.toml with an effect removed from the list, in the way of
/// `with_effect`.
/// @throws InputError if the text is not TOML, if the effect is not in the list, or if the layout
///         of the list cannot be edited safely
std::string without_effect(const std::string& text, const std::string& file, std::string_view name);

/// Returns a text as a string of TOML, in quotes and with escapes.
std::string toml_string(const std::string& text);

/// Replaces the content of study.toml, completely or not at all.
/// @throws InputError if the path is a symbolic link out of its folder
/// @throws std::runtime_error if the file cannot be written
void replace_study(const std::filesystem::path& file, const std::string& text);

}  // namespace pendular
