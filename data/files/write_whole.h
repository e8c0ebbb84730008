#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace pendular {

/// Moment at which a file counts as written: the operating system has the data, or they are on the
/// disk and survive a loss of power.
enum class Kept { by_system, on_disk };

/// Writes a file completely or not at all, by renaming a temporary file in the same folder. Missing
/// folders are created. An existing file keeps its access permissions and, if the system allows it,
/// its owner. Devices and pipes are written directly.
/// @throws InputError if the path is a symbolic link to a file outside of the folder of the link
/// @throws std::runtime_error with the system's reason if the file cannot be written, on a full
///         disk for example
void write_whole(const std::filesystem::path& path, const std::string& content,
                 Kept kept = Kept::on_disk);

/// Writes the files of a folder. All files are first written to a temporary folder, so that an
/// error while writing leaves an existing folder unchanged. Further files of an existing folder are
/// kept.
/// @param content_of_file text of each file, by name
/// @throws std::runtime_error with the system's reason if a file cannot be written
void write_whole_folder(const std::filesystem::path& folder,
                        const std::map<std::string, std::string>& content_of_file);

/// Temporary folder, for files that are soon moved to another folder or read. The destructor
/// removes it with its content.
class PassingFolder {
  public:
    /// Creates a new, empty folder in the folder `within`.
    /// @throws std::runtime_error if the folder cannot be created
    explicit PassingFolder(const std::filesystem::path& within);
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    ~PassingFolder();
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Checks that writing to a path does not overwrite a file elsewhere.
/// @throws InputError if the path is a symbolic link to a file outside of the folder of the link
void refuse_link_outside(const std::filesystem::path& path);

}  // namespace pendular
