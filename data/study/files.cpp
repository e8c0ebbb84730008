#include "data/study/files.h"

#include <dirent.h>
#include <fnmatch.h>
#include <glob.h>

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>

namespace pendular {
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

}  // namespace

std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern) {
    const std::string whole = whole_pattern(folder, pattern);
    std::vector<std::filesystem::path> result;
    std::error_code error;  // set for a link to itself, for example
    for (const std::filesystem::path& path : search(whole))
        if (std::filesystem::is_regular_file(path, error))
            result.push_back(path.lexically_normal());
    std::sort(result.begin(), result.end());
    return result;
}

bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern) {
    const std::filesystem::path whole =
        whole_pattern(std::filesystem::weakly_canonical(folder), pattern);
    return fnmatch(whole.lexically_normal().c_str(),
                   std::filesystem::weakly_canonical(file).c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
}

}  // namespace pendular
