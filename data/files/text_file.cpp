#include "data/files/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unicode/ucnv.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "data/input_error.h"

namespace pendular {
namespace {

std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream bytes;
    if (stream && stream.peek() != std::ifstream::traits_type::eof()) bytes << stream.rdbuf();
    const bool empty_file = stream.eof() && !stream.bad();
    if (!empty_file && !stream)
        throw InputError({path.string()}, fmt::format("cannot be read: {}", std::strerror(errno)));
    return bytes.str();
}

/// Name of the encoding of a text, from its byte-order mark or from the zero bytes of ASCII
/// characters in UTF-16; UTF-8 if neither is found.
const char* encoding_of(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) return "UTF-8";
    if (bytes.starts_with("\xFF\xFE")) return "UTF-16LE";
    if (bytes.starts_with("\xFE\xFF")) return "UTF-16BE";
    if (bytes.size() >= 2 && bytes[0] != 0 && bytes[1] == 0) return "UTF-16LE";
    if (bytes.size() >= 2 && bytes[0] == 0 && bytes[1] != 0) return "UTF-16BE";
    return "UTF-8";
}

/// Converts a text to UTF-8. Returns false if the bytes are not well-formed in `encoding`.
bool convert(std::string_view bytes, const char* encoding, std::string& utf8) {
    UErrorCode error = U_ZERO_ERROR;
    UConverter* const from = ucnv_open(encoding, &error);
    UConverter* const to = ucnv_open("UTF-8", &error);
    ucnv_setToUCallBack(from, UCNV_TO_U_CALLBACK_STOP, nullptr, nullptr, nullptr, &error);
    utf8.assign(3 * bytes.size() + 16, '\0');  // at most three times the length
    char* target = utf8.data();
    const char* source = bytes.data();
    ucnv_convertEx(to, from, &target, utf8.data() + utf8.size(), &source, source + bytes.size(),
                   nullptr, nullptr, nullptr, nullptr, true, true, &error);
    utf8.resize(static_cast<std::size_t>(target - utf8.data()));
    ucnv_close(from);
    ucnv_close(to);
    return U_SUCCESS(error);
}

std::string decoded(const std::string& bytes, const std::filesystem::path& path) {
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0"))
        throw InputError({path.string()},
                         "is a spreadsheet, not text; save it as CSV and name that file");
    std::string text;
    const bool well_formed =
        convert(bytes, encoding_of(bytes), text) || convert(bytes, "windows-1252", text);
    if (!well_formed || text.find('\0') != std::string::npos)
        throw InputError({path.string()}, "is not text; export it as CSV in UTF-8");
    return text;
}

[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), reason));
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path))
        throw InputError({path.string()}, "is a folder where a file is needed");
    return decoded(read_bytes(path), path);
}

std::vector<std::string> read_lines(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    std::vector<std::string> lines;
    for (std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        const bool both = text.compare(end, 2, "\r\n") == 0;
        begin = end + (both ? 2 : 1);
    }
    return lines;
}

namespace {

void write_into(const std::filesystem::path& path, const std::string& content) {
    std::ofstream stream(path, std::ios::binary);
    stream << content;
    stream.close();
    if (!stream) cannot_write(path, std::strerror(errno));
}

/// Waits until a file, or the list of entries of a folder, is on the disk.
/// @throws std::runtime_error if the system reports an error
void flush_to_disk(const std::filesystem::path& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
    const std::string reason = flushed ? "" : std::strerror(errno);
    if (descriptor >= 0) close(descriptor);
    if (!flushed) cannot_write(path, reason);
}

}  // namespace

void write_whole(const std::filesystem::path& path, const std::string& content, Kept kept) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    if (error) cannot_write(path, error.message());
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
        write_into(path, content);  // devices and pipes cannot be replaced
        return;
    }
    // The file that a symbolic link points to is replaced, not the link.
    const std::filesystem::path target = std::filesystem::weakly_canonical(path);
    const std::filesystem::path temporary = fmt::format("{}.{}.part", target.string(), getpid());
    try {
        write_into(temporary, content);
        if (kept == Kept::on_disk) flush_to_disk(temporary);
    } catch (...) {
        std::filesystem::remove(temporary, error);
        throw;
    }
    std::filesystem::rename(temporary, target, error);
    if (error) {
        const std::string reason = error.message();
        std::filesystem::remove(temporary, error);
        cannot_write(path, reason);
    }
    if (kept == Kept::on_disk) flush_to_disk(std::filesystem::absolute(target).parent_path());
}

namespace {

/// Moves all files of a folder to another, existing folder, and removes the first folder. The
/// existing folder is kept, since it may be the working directory of a process.
void move_files(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(from))
        files.push_back(entry.path());
    for (const auto& file : files)
        std::filesystem::rename(file, to / file.filename());
    std::filesystem::remove(from);
}

}  // namespace

void write_whole_folder(const std::filesystem::path& folder,
                        const std::map<std::string, std::string>& content_of_file) {
    namespace fs = std::filesystem;
    const fs::path target = folder.has_filename() ? folder : folder.parent_path();
    fs::path temporary;
    try {
        const bool there = fs::exists(target);
        temporary = there ? target / fmt::format(".{}.part", getpid())
                          : fs::path(fmt::format("{}.{}.part", target.string(), getpid()));
        fs::create_directories(temporary);
        for (const auto& [name, content] : content_of_file)
            write_into(temporary / name, content);
        there ? move_files(temporary, target) : fs::rename(temporary, target);
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
