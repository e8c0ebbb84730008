#include "data/files/write_whole.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "data/files/file_access.h"
#include "data/input_error.h"

namespace pendular {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::string& reason) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), reason));
}

/// File that is open for writing. `finish` must be called at the end of the work; else errors that
/// the system reports late are lost.
class NewFile {
  public:
    /// @param flags how to open the file, besides for writing (open(2))
    /// @throws std::runtime_error if the file cannot be opened
    NewFile(fs::path path, int flags) : path_(std::move(path)) {
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
        if (descriptor_ < 0) cannot_write(path_, std::strerror(errno));
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }

    void write(const std::string& content) const {
        for (std::size_t done = 0; done < content.size();) {
            const ssize_t count =
                ::write(descriptor_, content.data() + done, content.size() - done);
            if (count < 0 && errno != EINTR) cannot_write(path_, std::strerror(errno));
            if (count > 0) done += static_cast<std::size_t>(count);
        }
    }
    /// Gives the file the mode and, where the system allows it, the owner of another file.
    void take_over(const struct stat& other) const {
        // Not every file system allows a change of owner. The mode is set last, since a change of
        // owner clears some of its bits.
        [[maybe_unused]] const int owned = fchown(descriptor_, other.st_uid, other.st_gid);
        fchmod(descriptor_, other.st_mode & 07777);
    }
    void finish(Kept kept) {
        const bool flushed = kept == Kept::by_system || fsync(descriptor_) == 0;
        const int reason = errno;
        if (close(std::exchange(descriptor_, -1)) != 0) cannot_write(path_, std::strerror(errno));
        if (!flushed) cannot_write(path_, std::strerror(reason));
    }

  private:
    fs::path path_;
    int descriptor_ = -1;
};

/// Waits until the list of entries of a folder is on the disk. Errors of file systems that cannot
/// do so are ignored.
void flush_folder(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

/// Unpredictable path for a temporary file beside `target`.
fs::path temporary_beside(const fs::path& target) {
    static std::random_device random;
    return fs::path(fmt::format("{}.{:08x}{:08x}.part", target.string(), random(), random()));
}

/// Writes a temporary file that is to replace `target`, with the mode and owner of an existing
/// `target`.
void write_temporary(const fs::path& temporary, const fs::path& target, const std::string& content,
                     Kept kept) {
    NewFile file(temporary, O_CREAT | O_EXCL | O_NOFOLLOW);
    struct stat there = {};
    if (stat(target.c_str(), &there) == 0) file.take_over(there);
    file.write(content);
    file.finish(kept);
}

}  // namespace

void refuse_link_outside(const fs::path& path) {
    std::error_code error;
    if (!links_outside(path)) return;
    throw InputError({path.string()},
                     fmt::format("is a link to {}, which is not in its folder, and this command "
                                 "would write there; nothing was written: remove the link, or name "
                                 "another folder with --out",
                                 fs::read_symlink(path, error).string()));
}

void write_whole(const fs::path& path, const std::string& content, Kept kept) {
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) cannot_write(path, error.message());
    const fs::file_type type = fs::status(path, error).type();
    if (type == fs::file_type::fifo || type == fs::file_type::character ||
        type == fs::file_type::block || type == fs::file_type::socket) {
        NewFile device(path, 0);  // devices and pipes cannot be replaced
        device.write(content);
        return device.finish(Kept::by_system);
    }
    refuse_link_outside(path);
    // The file that a symbolic link points to is replaced, not the link.
    const fs::path target = fs::weakly_canonical(path);
    const fs::path temporary = temporary_beside(target);
    try {
        write_temporary(temporary, target, content, kept);
        fs::rename(temporary, target, error);
        if (error) cannot_write(path, error.message());
    } catch (...) {
        fs::remove(temporary, error);
        throw;
    }
    if (kept == Kept::on_disk) flush_folder(target.parent_path());
}

namespace {

fs::path new_temporary_folder(const fs::path& folder) {
    std::string name = (folder / ".pendular-XXXXXX").string();
    if (!mkdtemp(name.data())) cannot_write(folder, std::strerror(errno));
    return name;
}

}  // namespace

PassingFolder::PassingFolder(const fs::path& within) : path_(new_temporary_folder(within)) {}

PassingFolder::~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

namespace {

/// Moves all files of a folder to another, existing folder, and removes the first folder. The
/// existing folder is kept, since it may be the working directory of a process.
void move_files(const fs::path& from, const fs::path& to) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(from))
        files.push_back(entry.path());
    for (const auto& file : files)
        fs::rename(file, to / file.filename());
    fs::remove(from);
}

}  // namespace

void write_whole_folder(const fs::path& folder,
                        const std::map<std::string, std::string>& content_of_file) {
    const fs::path target = folder.has_filename() ? folder : folder.parent_path();
    fs::path temporary;
    try {
        const bool there = fs::exists(target);
        temporary = there ? new_temporary_folder(target) : temporary_beside(target);
        fs::create_directories(temporary);
        for (const auto& [name, content] : content_of_file)
            write_temporary(temporary / name, target / name, content, Kept::on_disk);
        there ? move_files(temporary, target) : fs::rename(temporary, target);
        flush_folder(target);
    } catch (const fs::filesystem_error& error) {
        std::error_code ignored;
        fs::remove_all(temporary, ignored);
        cannot_write(target, error.code().message());
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(temporary, ignored);
        throw;
    }
}

}  // namespace pendular
