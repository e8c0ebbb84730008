#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/file_access.h"

namespace pendular {

/// Returns the lines of a text file in UTF-8, without line ends (LF, CRLF or CR) and byte-order
/// mark. The encoding is recognised as in `decode_file`, and the errors are the same.
/// @param largest largest size of the file [bytes]
std::vector<std::string> read_lines(const std::filesystem::path& path,
                                    std::uintmax_t largest = largest_table);

/// Returns the whole text of a file in UTF-8, with byte-order mark and line ends. The encoding is
/// recognised as in `decode_file`, and the errors are the same.
/// @param largest largest size of the file [bytes]
std::string read_text(const std::filesystem::path& path, std::uintmax_t largest = largest_table);

/// Text of a file, converted to UTF-8.
struct DecodedText {
    std::string text;  ///< with byte-order mark and line ends
    /// Encoding in which the file was written: "UTF-8", "UTF-16LE", "UTF-16BE", "Shift_JIS",
    /// "windows-1252" or the encoding that was requested.
    std::string encoding;
};

/// Reads a text file and converts it to UTF-8. If `encoding` is empty, a byte-order mark states it.
/// Without one, the encoding is the first that applies: UTF-16 (exactly one of the first two bytes
/// is zero), UTF-8 (all bytes are valid UTF-8), Shift-JIS (first rank in the charset detection of
/// ICU), Windows-1252.
/// @param largest largest size of the file [bytes]
/// @throws InputError if the file cannot be read, is larger than `largest`, is not a text (a
///         spreadsheet for example), or is not in `encoding`
DecodedText decode_file(const std::filesystem::path& path, const std::string& encoding = "",
                        std::uintmax_t largest = largest_table);

/// Converts the bytes of a text file to UTF-8, by the rules of `decode_file`.
/// @param path path of the file, for error messages
/// @throws InputError if the bytes are not a text, or are not in `encoding`
DecodedText decode_bytes(const std::string& bytes, const std::filesystem::path& path,
                         const std::string& encoding = "");

/// Returns the lines of a text without line ends (LF, CRLF or CR, also mixed) and byte-order mark,
/// as views of the text, which must outlive them.
std::vector<std::string_view> split_lines(std::string_view text);

/// Returns a text from a file in a form that is safe to show on a terminal: control characters
/// other than LF and tab, characters that change the direction of writing, and bytes that are not
/// UTF-8 are replaced by visible codes such as "\x1b".
std::string printable(std::string_view text);

}  // namespace pendular
