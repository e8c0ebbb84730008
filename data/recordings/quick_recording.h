#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "data/files/formats/file_format.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Largest size of a file that `quick_recording` reads [bytes].
constexpr std::uintmax_t largest_quick_recording = std::uintmax_t(1) << 34;
/// Number of rows at which `quick_recording` begins to average rows, so that the memory is bounded.
constexpr std::size_t most_kept_rows = 1 << 20;

/// Reads a simple recording row by row, without keeping the text of the file. The recording equals
/// the result of `read_recording`, but takes a fraction of the time and memory to read. Rows of
/// files with more than `most_rows` rows are averaged (`AveragedRows`). A file is simple if it is a
/// UTF-8 table with one header, and if all other cells are numbers with a decimal point. The result
/// is empty for every other file, such as an export of an instrument or a file with decimal commas,
/// quotes, comments, empty cells or invalid rows. The result is also empty if the file is larger
/// than `largest_quick_recording`, or if `format` states columns, roles or other settings that only
/// `read_recording` understands.
/// @throws InputError if the file cannot be read
std::optional<Recording> quick_recording(const std::filesystem::path& path,
                                         const FileFormat& format,
                                         std::size_t most_rows = most_kept_rows);

}  // namespace pendular
