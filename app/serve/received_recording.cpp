#include "app/serve/received_recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fcntl.h>
#include <stdio.h>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include "data/files/file_access.h"
#include "data/files/text_file.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/recordings/file_view.h"
#include "data/study/study.h"
#include "reports/file_advice.h"
#include "workflow/study_input.h"

namespace pendular::app {

namespace {

namespace fs = std::filesystem;

/// Longest name of a file [bytes]: with the 22 bytes that `write_whole` appends for its temporary
/// file, the name stays below the 255 bytes that Linux permits.
constexpr std::size_t longest_name = 200;

/// Place of a recording in a study, and how it is read there.
struct Place {
    fs::path file;
    FileFormat format;
};

/// Whether a path has no part that is a pattern.
bool is_literal(const fs::path& path) {
    return path.string().find_first_of("*?[\\") == std::string::npos;
}

/// Place at which one of the patterns of [[recording]] would read a file of this name; empty where
/// none would. The place is in an existing folder of the study.
std::optional<Place> place_of(const std::string& name, const fs::path& folder,
                              const std::vector<FilePattern>& patterns) {
    for (const FilePattern& each : patterns) {
        const fs::path within = fs::path(each.pattern).parent_path();
        if (each.kind != Source::Kind::recording || within.is_absolute() || !is_literal(within))
            continue;
        const fs::path file = folder / within / name;
        std::error_code error;
        if (fs::is_directory(folder / within, error) && is_within(file.parent_path(), folder) &&
            matches(file, folder, each.pattern))
            return Place{file, each.format};
    }
    return std::nullopt;
}

Answer no_pattern(const std::string& name, const std::vector<FilePattern>& patterns) {
    std::vector<std::string> shown;
    for (const FilePattern& each : patterns)
        if (each.kind == Source::Kind::recording) shown.push_back('"' + each.pattern + '"');
    if (shown.empty())
        return {422, fmt::format("{} was not stored: study.toml has no [[recording]]; add one with "
                                 "a 'file' that matches the name",
                                 name)};
    return {422, fmt::format("{} was not stored: no [[recording]] of study.toml would read it, "
                             "since 'file' is {}; rename the file, or widen the pattern",
                             name, fmt::join(shown, ", "))};
}

/// Text without the folder in which a file was checked, so that it names the file alone.
std::string without(std::string text, const fs::path& folder) {
    const std::string part = (folder / "").string();
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;)
        text.erase(at, part.size());
    return text;
}

/// Reason why a recording cannot be read; empty where it can.
std::string fault_of_content(const fs::path& file, const Place& place) {
    try {
        const FileView view = view_of_file(file, place.format, cell_beside(place.file));
        if (view.by_unit.empty()) return missing_sentence(view);
        const auto& [quantity_name, column] = *view.by_unit.begin();
        return fmt::format(
            "Its column '{}' is read only where [[recording]] of study.toml names "
            "it, as in columns = {{ {} = \"{}\" }}.",
            column, quantity_name, column);
    } catch (const InputError& error) {
        return without(error.what(), file.parent_path());
    }
}

/// Moves a file to a path that no file has. Returns false where one has it.
/// @throws std::runtime_error where the file cannot be moved
bool move_to_new(const fs::path& from, const fs::path& to) {
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
    if (errno == EEXIST) return false;
    if (errno == EINVAL || errno == ENOSYS) {  // file systems of memory cards, for example
        if (fs::exists(fs::symlink_status(to))) return false;
        if (std::rename(from.c_str(), to.c_str()) == 0) return true;
    }
    throw std::runtime_error(
        fmt::format("{} cannot be written: {}", to.string(), std::strerror(errno)));
}

/// Answer where a file of this name is in the study already.
Answer compared_with_present(const std::string& name, const fs::path& file,
                             const std::string& bytes) {
    std::error_code error;
    const bool same = fs::is_regular_file(file, error) &&
                      fs::file_size(file, error) == bytes.size() &&
                      read_bytes(file, largest_received) == bytes;
    if (same) return {200, fmt::format("{} is in the study already, with the same content.", name)};
    return {409, fmt::format("{} was not stored: the study has another file of this name; rename "
                             "the new one.",
                             name)};
}

}  // namespace

std::string fault_of_name(const std::string& name) {
    if (name.empty()) return "it is empty";
    if (name.size() > longest_name) return fmt::format("it has more than {} bytes", longest_name);
    if (name.find_first_of("/\\") != std::string::npos) return "it names a folder";
    if (name.front() == '.' || name.front() == '-') return "it begins with a dot or a hyphen";
    if (name.find_first_of("\n\t") != std::string::npos || printable(name) != name)
        return "it has characters that cannot be shown";
    return "";
}

Answer store_recording(const fs::path& study, const std::string& name, const std::string& bytes) {
    if (const std::string fault = fault_of_name(name); !fault.empty())
        return {400, fmt::format("The recording was not stored: a file must not have the name "
                                 "\"{}\", since {}.",
                                 printable(name.substr(0, longest_name)), fault)};
    const fs::path folder = study_folder(study);
    const auto patterns = read_patterns(study);
    const auto place = place_of(name, folder, patterns);
    if (!place) return no_pattern(name, patterns);
    if (fs::exists(fs::symlink_status(place->file)))
        return compared_with_present(name, place->file, bytes);
    const PassingFolder passing(folder);
    write_whole(passing.path() / name, bytes);
    if (const std::string fault = fault_of_content(passing.path() / name, *place); !fault.empty())
        return {422, fmt::format("{} was not stored: {}", name, fault)};
    if (!move_to_new(passing.path() / name, place->file))
        return compared_with_present(name, place->file, bytes);
    return {201, fmt::format("{} is stored in the study.", name)};
}

}  // namespace pendular::app
