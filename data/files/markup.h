#pragma once

#include <filesystem>
#include <string_view>

namespace pendular {

/// Refuses a text that is XML, JSON or HTML, whatever the name of its file: TRIOS writes the first
/// two, and old programs HTML into files called .xls.
/// @throws InputError that says what the text is and how to export a table
void refuse_markup(const std::filesystem::path& path, std::string_view text);

}  // namespace pendular
