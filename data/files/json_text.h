#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace pendular {

/// Version of all JSON formats that the program writes. It increases only if programs that read the
/// earlier version would misread the new one. The schemas are in docs/reference.
constexpr int json_format = 2;

/// Returns the text of a file with a JSON object. The first key, "format", states `json_format`. A
/// number that is not finite becomes null, and bytes that are not UTF-8 become U+FFFD.
/// @param indent blanks per level of nesting
std::string json_text(const nlohmann::ordered_json& object, int indent = 2);

/// Checks the version of a JSON file. Files without a key "format" are accepted.
/// @param advice end of the message, which says what to do
/// @throws InputError if the version is none from 1 to `json_format`
void check_json_format(const nlohmann::ordered_json& object, const std::filesystem::path& file,
                       std::string_view advice);

}  // namespace pendular
