#include "data/files/file_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pendular {
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
