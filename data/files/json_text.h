#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace pendular {

/// Version of all JSON formats that the program writes. The version increases only if programs that
/// read the earlier version would misread the new version. The schemas are in docs/reference.
constexpr int json_format = 1;

/// Returns the text of a file that contains a JSON object. The first key of the text, "format",
/// states the version of the formats (`json_format`). A number that is not finite is written as
/// null. Bytes that are not UTF-8 are written as U+FFFD.
/// @param indent number of blanks per level of nesting
std::string json_text(const nlohmann::ordered_json& object, int indent = 2);

/// Checks that a JSON file has the version of the formats that the program reads, `json_format`.
/// Files without a key "format" are accepted.
/// @param file path of the file, for the message
/// @param advice end of the message, which says what to do
/// @throws InputError if the version of the formats in the file differs from `json_format`
void check_json_format(const nlohmann::ordered_json& object, const std::filesystem::path& file,
                       std::string_view advice);

}  // namespace pendular
