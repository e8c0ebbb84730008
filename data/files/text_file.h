#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pendular {

/// The lines of a text file as UTF-8, without line ends (LF, CRLF or CR) and byte-order mark. Files
/// in UTF-16 are decoded; what is neither that nor valid UTF-8 is read as Windows-1252.
/// @throws InputError if the file cannot be read or is no text (a spreadsheet, say)
std::vector<std::string> read_lines(const std::filesystem::path& path);

/// The whole text as UTF-8, byte-order mark and line ends included.
/// @throws InputError as read_lines does
std::string read_text(const std::filesystem::path& path);

/// Whether a written file must have reached the disk, so that it survives a loss of power.
enum class Kept { by_system, on_disk };

/// Writes a file so that it is there whole or not at all: to a temporary file beside it, then
/// renamed. Folders on the way are made.
/// @throws std::runtime_error naming the file and the system's reason, a full disk for example
void write_whole(const std::filesystem::path& path, const std::string& content,
                 Kept kept = Kept::by_system);

/// Writes a folder of files so that it is there whole or not at all: to a temporary folder beside
/// it, then renamed, or, where the folder is there already, to one inside it, then moved up.
/// @throws std::runtime_error naming the file or folder and the system's reason
void write_whole_folder(const std::filesystem::path& folder,
                        const std::map<std::string, std::string>& content_of_file);

}  // namespace pendular
