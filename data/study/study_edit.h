#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pendular {

/// The text of a study file, `file` by name, with an effect at the end of the list `effects` in
/// [model]; table, key and list are added where they are missing. Everything outside the list stays
/// byte for byte, comments inside it stay too, and new lines end as the others do.
/// @throws InputError where the file is no TOML, the effect is listed already, or the list is laid
///         out in a way that only its author can change; it says what to write
std::string with_effect(const std::string& text, const std::string& file, std::string_view name);

/// Returns the text of study.toml without the effect in its list.
/// @throws InputError as `with_effect` does, and where the effect is not listed, naming those that
/// are
std::string without_effect(const std::string& text, const std::string& file, std::string_view name);

/// Puts a text in the place of a study file, whole or not at all. `read_text` gives the text.
/// @throws std::runtime_error naming the file and the system's reason
void replace_study(const std::filesystem::path& file, const std::string& text);

}  // namespace pendular
