#include "data/files/file_access.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fnmatch.h>
#include <glob.h>
#include <linux/magic.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

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

std::string as_pattern(const std::string& path) {
    std::string result;
    for (const char c : path) {
        if (std::string_view("*?[]\\").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

namespace {

std::string whole_pattern(const std::filesystem::path& folder, const std::string& pattern) {
    const bool absolute = std::filesystem::path(pattern).is_absolute();
    return absolute ? pattern : as_pattern(folder.string()) + "/" + pattern;
}

/// Largest number of folders that a pattern may open: the search of one that matches very many
/// may not end.
constexpr int most_folders = 10'000;
thread_local int folders_left = 0;  ///< folders that the present search may still open

/// Opens a folder for the search of glob(3); fails once the search has opened too many.
void* open_folder(const char* name) {
    if (folders_left-- > 0) return opendir(name);
    errno = EMFILE;
    return nullptr;
}

/// Files, folders and links that match a pattern.
/// @throws std::invalid_argument for a pattern that opens too many folders
std::vector<std::filesystem::path> search(const std::string& pattern) {
    glob_t matches = {};
    matches.gl_opendir = open_folder;
    matches.gl_readdir = [](void* folder) { return readdir(static_cast<DIR*>(folder)); };
    matches.gl_closedir = [](void* folder) { closedir(static_cast<DIR*>(folder)); };
    matches.gl_stat = stat;
    matches.gl_lstat = lstat;
    folders_left = most_folders;
    const bool found = glob(pattern.c_str(), GLOB_ALTDIRFUNC, nullptr, &matches) == 0;
    std::vector<std::filesystem::path> result;
    if (found) result.assign(matches.gl_pathv, matches.gl_pathv + matches.gl_pathc);
    globfree(&matches);
    if (folders_left < 0)
        throw std::invalid_argument("the pattern matches too many folders; name them");
    return result;
}

/// Parts of a path in turn: a number, such as 10 or 0.03, or another character.
std::vector<std::pair<double, char>> parts_of(const std::string& path) {
    std::vector<std::pair<double, char>> parts;
    const char* const end = path.data() + path.size();
    for (const char* at = path.data(); at != end;) {
        if (std::isdigit(static_cast<unsigned char>(*at)) == 0) {
            parts.emplace_back(INFINITY, *at++);  // after all numbers
            continue;
        }
        double number = 0;
        at = std::from_chars(at, end, number, std::chars_format::fixed).ptr;
        parts.emplace_back(number, '\0');
    }
    return parts;
}

/// Whether a path comes before another: "run_2.csv" before "run_10.csv", as they were measured.
bool comes_before(const std::filesystem::path& one, const std::filesystem::path& other) {
    const auto a = parts_of(one.string()), b = parts_of(other.string());
    return a != b ? a < b : one < other;
}

}  // namespace

std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern) {
    const std::string whole = whole_pattern(folder, pattern);
    std::vector<std::filesystem::path> result;
    std::error_code error;  // set for a link to itself, for example
    for (const std::filesystem::path& path : search(whole))
        if (std::filesystem::is_regular_file(path, error))
            result.push_back(path.lexically_normal());
    std::ranges::sort(result, comes_before);
    return result;
}

bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern) {
    const std::filesystem::path whole =
        whole_pattern(std::filesystem::weakly_canonical(folder), pattern);
    return fnmatch(whole.lexically_normal().c_str(),
                   std::filesystem::weakly_canonical(file).c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
}

namespace {

bool same_file(int descriptor, const std::filesystem::path& path) {
    struct stat open = {}, named = {};
    return fstat(descriptor, &open) == 0 && stat(path.c_str(), &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/// Command line of a process; empty where the system does not show it.
std::string command_of(const std::string& process) {
    std::ifstream file("/proc/" + process + "/cmdline", std::ios::binary);
    std::ostringstream words;
    words << file.rdbuf();
    std::string text = words.str();
    while (text.ends_with('\0'))
        text.pop_back();
    std::ranges::replace(text, '\0', ' ');
    return text;
}

}  // namespace

FileLock::~FileLock() {
    if (descriptor_ < 0) return;
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    close(descriptor_);
}

bool FileLock::take() {
    do {
        if (descriptor_ >= 0) close(descriptor_);
        descriptor_ =
            open(file_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (descriptor_ < 0)
            throw std::runtime_error(
                fmt::format("{} cannot be written: {}", file_.string(), std::strerror(errno)));
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
            const int reason = errno;
            close(std::exchange(descriptor_, -1));
            if (reason == EWOULDBLOCK) return false;
            throw std::runtime_error(
                fmt::format("{} cannot be locked: {}", file_.string(), std::strerror(reason)));
        }
        // A process that had the lock before may have removed the file in the meantime.
    } while (!same_file(descriptor_, file_));
    return true;
}

std::string FileLock::holder() const {
    struct stat status = {};
    if (stat(file_.c_str(), &status) != 0) return "another process";
    // A line of /proc/locks: "1: FLOCK  ADVISORY  WRITE 4711 fe:01:1234 0 EOF".
    std::ifstream locks("/proc/locks");
    const std::string inode = fmt::format(":{}", status.st_ino),
                      device =
                          fmt::format("{:02x}:{:02x}", major(status.st_dev), minor(status.st_dev));
    std::string likely;  // on some file systems, the kernel names another device than stat
    for (std::string line; std::getline(locks, line);) {
        std::istringstream words(line);
        std::string number, kind, advisory, access, process, file;
        words >> number >> kind >> advisory >> access >> process >> file;
        if (kind != "FLOCK" || !file.ends_with(inode)) continue;
        const bool certain = file == device + inode;
        if (certain || likely.empty()) likely = process;
        if (certain) break;
    }
    if (likely.empty()) return "another process";
    const std::string command = command_of(likely);
    return fmt::format("process {}{}", likely, command.empty() ? "" : " (" + command + ")");
}

}  // namespace pendular
