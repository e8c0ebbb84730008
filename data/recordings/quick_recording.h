#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "data/files/formats/file_format.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Largest size of a recording that is read row by row [bytes].
constexpr std::uintmax_t largest_quick_recording = std::uintmax_t(1) << 34;
/// Number of rows from which on the rows of a recording are averaged, so that memory does not grow
/// with the file (`AveragedRows`).
constexpr std::size_t most_kept_rows = 1 << 20;

/// Reads a plain recording row by row, without keeping its text: the result is that of
/// `read_recording`, in a fraction of the time and memory, but that rows of files with more than
/// `most_rows` rows are averages. Read so are tables in UTF-8 with one header, in which every cell
/// is a number with a decimal point. Empty for all other files, which `read_recording` reads or
/// refuses: files of instruments, other encodings and decimal marks, quotes, comments, empty cells,
/// columns of set points, and rows that are wrong.
/// @throws InputError if the file cannot be read
std::optional<Recording> quick_recording(const std::filesystem::path& path,
                                         const FileFormat& format,
                                         std::size_t most_rows = most_kept_rows);

}  // namespace pendular
