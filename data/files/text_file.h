#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pendular {

/// Lines of a text file in UTF-8, without line ends (LF, CRLF or CR) and byte-order mark. Files in
/// UTF-16 are converted; files that are neither UTF-16 nor valid UTF-8 are read as Windows-1252.
/// @throws InputError if the file cannot be read or is not a text, but a spreadsheet for example
std::vector<std::string> read_lines(const std::filesystem::path& path);

/// Whole text of a file in UTF-8, with byte-order mark and line ends. Text in UTF-16 is converted;
/// text that is neither UTF-16 nor valid UTF-8 is read as Windows-1252.
/// @throws InputError if the file cannot be read or is not a text, but a spreadsheet for example
std::string read_text(const std::filesystem::path& path);

/// When a file counts as written: once the operating system has it, or once it is on the disk and
/// survives a loss of power.
enum class Kept { by_system, on_disk };

/// Writes a file as a whole or not at all: a temporary file beside it is written and then renamed;
/// only devices and pipes are written directly. Missing folders of the path are created.
/// @throws std::runtime_error if the file cannot be written, on a full disk for example, naming the
///         file and the system's reason
void write_whole(const std::filesystem::path& path, const std::string& content,
                 Kept kept = Kept::by_system);

/// Writes a folder of files as a whole or not at all: a temporary folder beside it is written and
/// then renamed. If the folder exists, the files are written to a temporary folder inside it and
/// moved up once all are written.
/// @param content_of_file text of each file, by file name
/// @throws std::runtime_error if a file cannot be written, naming the file or folder and the
///         system's reason
void write_whole_folder(const std::filesystem::path& folder,
                        const std::map<std::string, std::string>& content_of_file);

}  // namespace pendular
