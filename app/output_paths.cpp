#include "app/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "data/input_error.h"

namespace pendular::app {

void demand_table(const std::filesystem::path& file, const std::string& first) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error) ||
        std::filesystem::file_size(file, error) == 0) {
        return;
    }
    std::string begin(first.size(), '\0');
    std::ifstream(file, std::ios::binary).read(begin.data(), std::ssize(begin));
    if (begin != first) {
        throw InputError(fmt::format(
            "{} holds something other than such a table; nothing was written: name another file",
            file.string()));
    }
}

void demand_writable(const std::filesystem::path& path, const std::string& option, bool folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (path.empty()) {
        throw InputError(fmt::format("{} needs a name", option));
    }
    if (fs::exists(path, error) && fs::is_directory(path, error) != folder) {
        throw InputError(fmt::format("option {} needs {}, but '{}' is {}", option,
                                     folder ? "a folder" : "a file", path.string(),
                                     folder ? "a file" : "a folder"));
    }
    fs::path there = fs::absolute(path, error);
    while (!fs::exists(there, error) && there.has_relative_path()) {
        there = there.parent_path();
    }
    if (there != fs::absolute(path, error) && !fs::is_directory(there, error)) {
        throw InputError(fmt::format("{} {} cannot be written: {} is no folder", option,
                                     path.string(), there.string()));
    }
    if (access(there.c_str(), W_OK) != 0) {
        throw InputError(fmt::format("{} {} cannot be written: {}", option, path.string(),
                                     std::strerror(errno)));
    }
}

namespace {

/// First character of a file that is no blank; empty where the file is missing, empty or no regular
/// file.
std::optional<char> first_character(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    char first = 0;
    return stream >> first ? std::optional(first) : std::nullopt;
}

}  // namespace

void demand_json(const std::filesystem::path& file, const std::string& option) {
    const auto first = first_character(file);
    if (first && *first != '{' && *first != '[') {
        throw InputError(
            fmt::format("{} {}: that file holds something other than JSON; nothing was written: "
                        "name another file",
                        option, file.string()));
    }
}

}  // namespace pendular::app
