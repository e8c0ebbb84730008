#include "data/study/files.h"

#include <fnmatch.h>
#include <glob.h>

#include <algorithm>

namespace pendular {
namespace {

/// Text with the special characters of patterns escaped, for a folder's name in a pattern.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (std::string_view("*?[]\\").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

std::string whole_pattern(const std::filesystem::path& folder, const std::string& pattern) {
    const bool absolute = std::filesystem::path(pattern).is_absolute();
    return absolute ? pattern : escaped(folder.string()) + "/" + pattern;
}

}  // namespace

std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern) {
    const std::string whole = whole_pattern(folder, pattern);
    std::vector<std::filesystem::path> result;
    glob_t matches = {};
    if (glob(whole.c_str(), 0, nullptr, &matches) == 0) {
        for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
            const std::filesystem::path path(matches.gl_pathv[i]);
            if (std::filesystem::is_regular_file(path)) result.push_back(path.lexically_normal());
        }
    }
    globfree(&matches);
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
