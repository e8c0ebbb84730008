#include "sim/dem/checkpoint.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include "data/files/text_file.h"
#include "data/input_error.h"

namespace pendular::dem {
namespace {

constexpr std::string_view signature = "pendular checkpoint, format ";

std::uint64_t checksum(std::string_view bytes) {
    // CRC-64 with the polynomial of ECMA-182.
    boost::crc_optimal<64, 0x42f0e1eba9ea3693, ~0ull, ~0ull, true, true> crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return crc.checksum();
}

std::string seal(std::string_view content) {
    return fmt::format("checksum {:016x} of {} bytes", checksum(content), content.size());
}

/// Value of the line "name = value" for this name; empty where there is no such line.
std::string value_of(const std::string& name, std::istringstream lines) {
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(name + " = ")) {
            return line.substr(name.size() + 3);
        }
    }
    return "";
}

/// First parameter in which a run differs from the run of a checkpoint file, with the value in the
/// file and that of the run: "friction 0.2, not 0.3".
std::string difference(const std::string& run, const std::string& saved) {
    std::istringstream lines(run);
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(0, line.find(" = "));
        const std::string here = value_of(name, std::istringstream(line)),
                          there = value_of(name, std::istringstream(saved));
        if (here != there) {
            return fmt::format("{} {}, not {}", name, there, here);
        }
    }
    return "other parameters";
}

bool same_file(int descriptor, const std::filesystem::path& path) {
    struct stat open = {}, named = {};
    return fstat(descriptor, &open) == 0 && stat(path.c_str(), &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace

Checkpoint::Checkpoint(const std::filesystem::path& file, std::chrono::duration<double> every)
    : file_(std::filesystem::weakly_canonical(std::filesystem::absolute(file))),
      lock_file_(fmt::format("{}.lock", file_.string())),
      every_(every) {
    std::error_code error;
    if (std::filesystem::exists(file_, error) && !std::filesystem::is_regular_file(file_, error)) {
        throw InputError(fmt::format("{} is no file; name another checkpoint", file_.string()));
    }
    std::filesystem::create_directories(file_.parent_path(), error);
    lock();
}

void Checkpoint::lock() {
    const auto give_up = [&](const std::string& why) {
        close(lock_);
        throw InputError(fmt::format("checkpoint {}: {}", file_.string(), why));
    };
    do {
        if (lock_ >= 0) {
            close(lock_);
        }
        lock_ = open(lock_file_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
        if (lock_ < 0) {
            give_up(fmt::format("its folder cannot be written: {}", std::strerror(errno)));
        }
        if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
            give_up(errno == EWOULDBLOCK
                        ? std::string("another process is using it; wait for it to end or name "
                                      "another file")
                        : fmt::format("cannot be locked: {}", std::strerror(errno)));
        }
        // A process that held the lock before may have deleted the lock file in the meantime.
    } while (!same_file(lock_, lock_file_));
}

Checkpoint::~Checkpoint() {
    std::error_code ignored;
    std::filesystem::remove(lock_file_, ignored);
    close(lock_);
}

std::optional<std::string> Checkpoint::read(const std::string& run) const {
    if (!exists()) {
        return std::nullopt;
    }
    const auto refuse = [&](const std::string& why) {
        throw InputError(
            fmt::format("checkpoint {} {}; remove it to start anew, or name another file",
                        file_.string(), why));
    };
    std::ifstream stream(file_, std::ios::binary);
    std::string first, sealed;
    std::getline(stream, first);
    std::getline(stream, sealed);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (!first.starts_with(signature)) {
        refuse("is no checkpoint of pendular");
    }
    if (first != fmt::format("{}{}", signature, format)) {
        refuse(fmt::format("was written by another version of pendular, in format {}, not {}",
                           first.substr(signature.size()), format));
    }
    const auto text_end = content.find("\n\n");
    if (sealed != seal(content) || text_end == std::string::npos) {
        refuse("is truncated or corrupt");
    }
    const std::string saved = content.substr(0, text_end + 1);
    if (saved != run) {
        refuse("is of another run: " + difference(run, saved));
    }
    return content.substr(text_end + 2);
}

void Checkpoint::write(const std::string& run, const std::string& state) {
    const std::string content = run + "\n" + state;
    try {
        write_whole(file_, fmt::format("{}{}\n{}\n", signature, format, seal(content)) + content,
                    Kept::on_disk);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}; {}", error.what(),
                                             exists() ? "the former checkpoint is still there"
                                                      : "there is no checkpoint of this run"));
    }
    written_ = std::chrono::steady_clock::now();
}

void Checkpoint::remove() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace pendular::dem
