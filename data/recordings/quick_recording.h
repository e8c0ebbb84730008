#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "data/files/formats/file_format.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Largest size of a file that `quick_recording` reads [bytes]. Chosen: the memory is bounded by
/// `most_kept_rows`, the time by this.
constexpr std::uintmax_t largest_quick_recording = std::uintmax_t(1) << 34;
/// Number of rows from which on `quick_recording` averages rows, so that the memory is bounded.
constexpr std::size_t most_kept_rows = 1 << 20;

/// Reads a plain recording row by row, in a fraction of the time and memory of `read_recording`: a
/// UTF-8 table with one header, whose other cells are all numbers with a decimal point. More than
/// `most_rows` rows are averaged (`RecordingRows`). Empty for every other file, for files larger
/// than `largest_quick_recording`, and for settings that only `read_recording` understands. Cells
/// without a number are read here only in files that `read_recording` refuses for their size.
/// @throws InputError if the file cannot be read and, in a file larger than `largest_table`, at
///         file:line:column as `read_recording`
std::optional<Recording> quick_recording(const std::filesystem::path& path,
                                         const FileFormat& format,
                                         std::size_t most_rows = most_kept_rows);

}  // namespace pendular
