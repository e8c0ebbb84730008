#include "sim/dem/checkpoint.h"

#include <fmt/format.h>

#include <array>
#include <boost/crc.hpp>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "data/files/file_access.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"

namespace pendular::dem {
namespace {

/// Size that no checkpoint reaches [bytes]: a grain takes about 1200.
constexpr std::uintmax_t largest = 20'000'000'000;
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

/// First two lines of a checkpoint file: its format, and its checksum with its length; empty where
/// a line is longer than such lines are.
std::pair<std::string, std::string> first_lines(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 200> first{}, second{};
    stream.getline(first.data(), first.size());
    stream.getline(second.data(), second.size());
    return {first.data(), second.data()};
}

/// Number of bytes that the line with the checksum states; 0 where it states none.
std::uintmax_t sealed_size(const std::string& sealed) {
    const auto at = sealed.find(" of ");
    std::uintmax_t size = 0;
    if (at != std::string::npos)
        std::from_chars(sealed.data() + at + 4, sealed.data() + sealed.size(), size);
    return size;
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

}  // namespace

Checkpoint::Checkpoint(const std::filesystem::path& file, std::chrono::duration<double> every)
    : file_(std::filesystem::weakly_canonical(std::filesystem::absolute(file))),
      lock_(fmt::format("{}.lock", file_.string())),
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
        throw InputError(fmt::format("checkpoint {}: {}", file_.string(), why));
    };
    bool taken = false;
    try {
        taken = lock_.take();
    } catch (const std::runtime_error& error) {
        give_up(error.what());
    }
    if (!taken) {
        give_up(
            fmt::format("{} is using it; wait for it to end or name another file", lock_.holder()));
    }
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
    const auto [first, sealed] = first_lines(file_);
    if (!first.starts_with(signature)) {
        refuse("is no checkpoint of pendular");
    }
    if (first != fmt::format("{}{}", signature, format)) {
        refuse(fmt::format("was written by another version of pendular, in format {}, not {}",
                           first.substr(signature.size()), format));
    }
    const std::uintmax_t before = first.size() + sealed.size() + 2;
    const std::uintmax_t size = std::filesystem::file_size(file_);
    if (size < before || size - before != sealed_size(sealed) || size > largest) {
        refuse("is truncated or corrupt");
    }
    const std::string content = read_bytes(file_, size).substr(before);
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
