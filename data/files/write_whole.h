#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace pendular {

/// Moment from which a file counts as written: when the operating system has the data, or when the
/// data are on the disk and survive a loss of power.
enum class Kept { by_system, on_disk };

/// Writes a file as a whole or not at all: a temporary file beside it is written, flushed to the
/// disk and renamed. An existing file keeps its mode and, where the system allows it, its owner.
/// Devices and pipes are written directly. Missing folders of the path are created.
/// @throws InputError if the path is a link to a place outside of its folder, which would be
///         overwritten
/// @throws std::runtime_error if the file cannot be written, on a full disk for example, naming the
///         file and the system's reason
void write_whole(const std::filesystem::path& path, const std::string& content,
                 Kept kept = Kept::on_disk);

/// Writes a folder of files as a whole or not at all: a temporary folder beside it is written and
/// then renamed. If the folder exists, the files are written to a temporary folder inside it and
/// moved up once all are written.
/// @param content_of_file text of each file, by file name
/// @throws std::runtime_error if a file cannot be written, naming the file or folder and the
///         system's reason
void write_whole_folder(const std::filesystem::path& folder,
                        const std::map<std::string, std::string>& content_of_file);

/// New, empty folder for files that are moved or read before it is removed, with what is left in
/// it, at the end of the object's life.
class PassingFolder {
  public:
    /// @param within folder in which it is made
    /// @throws std::runtime_error if it cannot be made
    explicit PassingFolder(const std::filesystem::path& within);
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    ~PassingFolder();
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Refuses a path that is a symbolic link out of its folder, since writing to it would overwrite a
/// file elsewhere.
/// @throws InputError if the path is such a link
void refuse_link_out(const std::filesystem::path& path);

}  // namespace pendular
