#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace pendular {

/// Version of all JSON that the program writes; it changes only where a reader of earlier files
/// would misunderstand newer ones. docs/reference has a schema of each kind.
constexpr int json_format = 1;

/// An object as the text of a file, `"format"` before its keys. A number that is not finite becomes
/// null, which the schemas allow where that can be.
std::string json_text(const nlohmann::ordered_json& object, int indent = 2);

/// Refuses a file of a format that this version does not understand. Files without a format predate
/// formats and pass.
/// @throws InputError naming the file and what to do, which is `advice`
void check_json_format(const nlohmann::ordered_json& object, const std::filesystem::path& file,
                       std::string_view advice);

}  // namespace pendular
