#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace pendular {

/// Version of all JSON formats that the program writes. It changes only when programs that read the
/// earlier version would misread the new version. docs/reference has the schemas.
constexpr int json_format = 1;

/// JSON text of an object for a file, with the key "format" before the object's keys. A number that
/// is not finite is written as null, bytes that are not UTF-8 as U+FFFD.
std::string json_text(const nlohmann::ordered_json& object, int indent = 2);

/// Checks that this version of the program can read a JSON file. Files without a key "format" are
/// accepted.
/// @throws InputError if the file's format is not `json_format`, naming the file and ending with
///         `advice`, which says what to do
void check_json_format(const nlohmann::ordered_json& object, const std::filesystem::path& file,
                       std::string_view advice);

}  // namespace pendular
