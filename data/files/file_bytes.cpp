#include "data/files/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "data/input_error.h"

namespace pendular {
namespace {

namespace fs = std::filesystem;

/// File that is open for reading, closed at the end of the object's life.
class OpenFile {
  public:
    /// @throws InputError if the file cannot be opened
    explicit OpenFile(const fs::path& path) : path_(path) {
        // Without O_NONBLOCK, opening a pipe waits for somebody to write to it.
        descriptor_ = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        if (descriptor_ < 0) refuse(std::strerror(errno));
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { close(descriptor_); }

    /// Size of the file [bytes].
    /// @throws InputError if the file is not a regular file on a disk
    std::uintmax_t size() const {
        struct stat status = {};
        struct statfs system = {};
        if (fstat(descriptor_, &status) != 0 || fstatfs(descriptor_, &system) != 0)
            refuse(std::strerror(errno));
        if (S_ISDIR(status.st_mode))
            throw InputError({path_.string()}, "is a folder where a file is needed");
        const bool of_kernel = system.f_type == PROC_SUPER_MAGIC || system.f_type == SYSFS_MAGIC;
        if (!S_ISREG(status.st_mode) || of_kernel)
            throw InputError({path_.string()},
                             "is not a regular file but a pipe, a device or a file of the system; "
                             "copy its content to a regular file and name that file");
        return static_cast<std::uintmax_t>(status.st_size);
    }

    /// Reads up to `count` bytes to `into` and returns their number.
    std::size_t read_into(char* into, std::size_t count) const {
        std::size_t done = 0;
        while (done < count) {
            const ssize_t got = ::read(descriptor_, into + done, count - done);
            if (got < 0 && errno != EINTR) refuse(std::strerror(errno));
            if (got == 0) break;
            if (got > 0) done += static_cast<std::size_t>(got);
        }
        return done;
    }

  private:
    [[noreturn]] void refuse(const char* reason) const {
        throw InputError({path_.string()}, fmt::format("cannot be read: {}", reason));
    }

    const fs::path& path_;
    int descriptor_ = -1;
};

std::string size_text(std::uintmax_t bytes) {
    const auto size = static_cast<double>(bytes);
    return size < 1e9 ? fmt::format("{:.0f} MB", size / 1e6) : fmt::format("{:.1f} GB", size / 1e9);
}

}  // namespace

std::string read_bytes(const fs::path& path, std::uintmax_t largest) {
    const OpenFile file(path);
    const std::uintmax_t size = file.size();
    if (size > largest)
        throw InputError({path.string()},
                         fmt::format("has {}, more than the limit of {}; split it into several "
                                     "files or leave out what is not needed",
                                     size_text(size), size_text(largest)));
    std::string bytes(static_cast<std::size_t>(size), '\0');
    bytes.resize(file.read_into(bytes.data(), bytes.size()));
    return bytes;
}

bool read_in_parts(const fs::path& path, std::uintmax_t largest,
                   const std::function<bool(std::string_view)>& read) {
    const OpenFile file(path);
    const std::uintmax_t size = file.size();
    if (size > largest) return false;
    // Chosen: so large that calls of the system cost nothing beside the parsing. Small recordings
    // get a buffer of their size instead.
    constexpr std::uintmax_t largest_part = 4 << 20;
    std::string part(static_cast<std::size_t>(std::min(size + 1, largest_part)), '\0');
    while (const std::size_t got = file.read_into(part.data(), part.size()))
        if (!read({part.data(), got})) return false;
    return true;
}

bool is_within(const fs::path& file, const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(file, error);
    if (error) return false;
    const fs::path base = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    return !error &&
           std::mismatch(base.begin(), base.end(), whole.begin(), whole.end()).first == base.end();
}

bool links_outside(const fs::path& path) {
    std::error_code error;
    return fs::is_symlink(path, error) &&
           (!fs::exists(path, error) || !is_within(path, path.parent_path()));
}

}  // namespace pendular
