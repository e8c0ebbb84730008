#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/files/file_bytes.h"

namespace pendular {

/// Lines of a text file in UTF-8, without line ends (LF, CRLF or CR) and byte-order mark. Files in
/// UTF-16 are converted; files that are neither UTF-16 nor valid UTF-8 are read as Windows-1252.
/// @throws InputError if the file cannot be read, has more than `largest` bytes, or is not a text,
/// but a spreadsheet for example
std::vector<std::string> read_lines(const std::filesystem::path& path,
                                    std::uintmax_t largest = largest_table);

/// Whole text of a file in UTF-8, with byte-order mark and line ends. Text in UTF-16 is converted;
/// text that is neither UTF-16 nor valid UTF-8 is read as Windows-1252.
/// @throws InputError if the file cannot be read, has more than `largest` bytes, or is not a text,
/// but a spreadsheet for example
std::string read_text(const std::filesystem::path& path, std::uintmax_t largest = largest_table);

}  // namespace pendular
