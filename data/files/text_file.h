#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/file_bytes.h"

namespace pendular {

/// Lines of a text file in UTF-8, without line ends (LF, CRLF or CR) and byte-order mark, decoded
/// as by `decode_file`.
/// @throws InputError if the file cannot be read, has more than `largest` bytes, or is not a
/// text file (a spreadsheet for example)
std::vector<std::string> read_lines(const std::filesystem::path& path,
                                    std::uintmax_t largest = largest_table);

/// Returns the whole text of a file, converted to UTF-8 as `decode_file` does; byte-order mark and
/// line ends stay as they are.
/// @throws InputError if the file cannot be read, has more than `largest` bytes, or is not a
/// text file (a spreadsheet for example)
std::string read_text(const std::filesystem::path& path, std::uintmax_t largest = largest_table);

/// Text of a file in UTF-8 with the encoding that the file has.
struct DecodedText {
    std::string text;      ///< in UTF-8, with byte-order mark and line ends
    std::string encoding;  ///< "UTF-8", "UTF-16LE", "UTF-16BE", "Shift_JIS" or "windows-1252"
};

/// Decodes a text file. The encoding is `encoding` if this is not empty; else that of the
/// byte-order mark; else UTF-16 if the first character has a zero byte; else UTF-8 if all bytes are
/// valid; else Shift-JIS if the charset detection of ICU is more confident of it than of any
/// other; else Windows-1252.
/// @throws InputError if the file cannot be read, has more than `largest` bytes, is not a text, or
/// is not in `encoding`
DecodedText decode_file(const std::filesystem::path& path, const std::string& encoding = "",
                        std::uintmax_t largest = largest_table);

/// Decodes bytes of a text file as `decode_file` does.
/// @throws InputError if the bytes are not a text, or are not in `encoding`
DecodedText decode_bytes(const std::string& bytes, const std::filesystem::path& path,
                         const std::string& encoding = "");

/// Lines of a text without line ends (LF, CRLF or CR, also mixed) and byte-order mark. The lines
/// refer to the text.
std::vector<std::string_view> split_lines(std::string_view text);

}  // namespace pendular
