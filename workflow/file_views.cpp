#include "workflow/file_views.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "data/files/column_names.h"
#include "data/files/formats/named_columns.h"
#include "data/files/formats/sheets.h"
#include "data/files/header_cell.h"
#include "data/input_error.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/recordings/test_kinds.h"
#include "data/remarks/wording.h"
#include "workflow/study_input.h"

namespace pendular {
namespace {

/// States the bulk density of preshears whose gap was recorded, for the grains of a study.
void add_bulk_densities(FileView& view, const AnnularCell& cell, double grain_density) {
    for (YieldLocus& locus : view.loci)
        if (locus.preshear && locus.preshear->height && !locus.preshear->bulk_density &&
            cell.bead_volume > 0)
            locus.preshear->bulk_density =
                grain_density * solid_fraction(*locus.preshear->height, cell);
}

/// Columns that may be what a file lacks, each with the line to write, as the end of a sentence.
std::string columns_to_name(const FileView& view) {
    std::string text;
    for (const BlockColumn& column : view.candidates) {
        if (column.quantity == "interval") continue;  // not missing
        const bool fits = is_unit(column.unit) && unit_fits(column.unit, column.quantity);
        text += fmt::format("; if '{} [{}]' is {}, write {}", column.name, column.unit,
                            possible_meanings(column, view),
                            line_to_name(column.quantity, column.name,
                                         fits ? column.unit : usual_unit(column.quantity)));
    }
    return text;
}

}  // namespace

std::string possible_meanings(const BlockColumn& column, const FileView& view) {
    std::vector<std::string> meanings;
    for (const std::string_view each : possible_quantities(column, view))
        meanings.push_back(fmt::format("the {}", quantity(each).meaning));
    constexpr std::size_t most = 2;
    if (meanings.empty() || meanings.size() > most) return "one of these";
    return fmt::format("{}", fmt::join(meanings, ", or "));
}

bool is_recorded_in_tension(const FileView& view) {
    return std::ranges::find(view.findings, Remark::Kind::no_compression, &Remark::kind) !=
           view.findings.end();
}

bool has_steady_recording(const FileView& view) {
    return view.missing.empty() && !is_recorded_in_tension(view) &&
           std::ranges::find(view.roles, std::string("steady"), &IntervalRole::role) !=
               view.roles.end();
}

void refuse_to_begin(const FileView& view) {
    if (is_recorded_in_tension(view))
        throw InputError({view.file.file},
                         "the normal force is negative in nearly all rows, so that no study can "
                         "begin with it; compression must be positive: reverse the sign of the "
                         "column in the file");
    if (view.file.layout == "plain" && !view.file.table_of_points &&
        is_table_of_readings(view.file.blocks.front()))
        throw InputError(
            {view.file.file},
            "is a table of readings, with which no study begins by itself: write a study.toml with "
            "[cell], [grains] and [[readings]], and name the file there");
    throw InputError(
        {view.file.file},
        fmt::format("shows neither steady shear nor points of failure, so that no study can "
                    "begin with it; it has no {}{}",
                    view.missing.empty() ? "interval of either"
                                         : fmt::format("{}", fmt::join(view.missing, ", ")),
                    columns_to_name(view)));
}

SheetViews views_of_file(const std::filesystem::path& path, const FileFormat& format) {
    const ChosenSheets sheets = chosen_sheets(path, format.sheet);
    const auto study = study_beside(path);
    const auto cell = study ? study->cell : std::nullopt;
    SheetViews result;
    for (const std::filesystem::path& each : sheets.read) {
        try {
            result.views.push_back(view_of_file(each, format, cell));
            if (cell) add_bulk_densities(result.views.back(), *cell, study->grains.density);
        } catch (const InputError& error) {
            if (sheets.read.size() == 1 || !format.sheet.empty()) throw;
            result.not_read.push_back(fmt::format("A sheet is not read: {}.", error.what()));
        }
    }
    if (result.views.empty()) view_of_file(sheets.read.front(), format, cell);  // throws
    if (!sheets.others.empty())
        result.not_read.push_back(unread_sheets_text(path.string(), sheets.others));
    return result;
}

SheetViews views_of_files(const std::vector<std::filesystem::path>& paths,
                          const FileFormat& format) {
    SheetViews all;
    for (const std::filesystem::path& path : paths) {
        SheetViews own = views_of_file(path, format);
        std::ranges::move(own.views, std::back_inserter(all.views));
        std::ranges::move(own.not_read, std::back_inserter(all.not_read));
    }
    return all;
}

namespace {

/// Whether most cells of a line are numbers, and two of them at least.
bool is_of_numbers(std::string line) {
    const auto blank_out = [&](std::string_view delimiters) {
        std::ranges::replace_if(
            line, [&](char c) { return delimiters.find(c) != std::string_view::npos; }, ' ');
    };
    blank_out("\t;|\r");
    // Between words, a comma is a decimal mark or one of a sentence.
    if (line.find(' ') == std::string::npos) blank_out(",");
    std::istringstream cells(line);
    std::size_t all = 0, numbers = 0;
    for (std::string cell; cells >> cell; ++all)
        numbers += is_number(cell);
    return numbers >= 2 && 2 * numbers > all;
}

/// Whether a file is a text without a line of numbers. One that cannot be opened is none.
bool is_note(const std::filesystem::path& path) {
    std::ifstream file(path);
    bool any_text = false;
    for (std::string line; std::getline(file, line);) {
        const bool is_text = line.find('\0') == std::string::npos;
        any_text |= !line.empty();
        if (!is_text || is_of_numbers(std::move(line))) return false;
    }
    return any_text;
}

}  // namespace

SheetViews views_of_named_files(const std::vector<std::filesystem::path>& paths,
                                const FileFormat& format) {
    std::vector<std::filesystem::path> measurements, notes;
    std::ranges::partition_copy(paths, std::back_inserter(notes), std::back_inserter(measurements),
                                is_note);
    if (measurements.empty()) return views_of_files(paths, format);
    SheetViews read = views_of_files(measurements, format);
    for (const std::filesystem::path& note : notes)
        read.not_read.push_back(
            fmt::format("{} has no line of numbers and is not read.", note.string()));
    return read;
}

bool is_used(const FileView& view) {
    const auto has_preshear = [&](std::size_t i) {
        return view.roles[i].role == "preshear" && !view.series[i].shear_stress.empty() &&
               !view.series[i].normal_stress.empty();
    };
    for (std::size_t i = 0; i < view.roles.size(); ++i)
        if (has_preshear(i)) return true;
    return begins_study(view) || !view.walls.empty();
}

bool begins_study(const FileView& view) {
    return !view.loci.empty() || has_steady_recording(view);
}

SheetViews views_to_begin_with(const std::vector<std::filesystem::path>& paths,
                               const FileFormat& format) {
    if (paths.size() == 1) return views_of_file(paths.front(), format);
    SheetViews result;
    for (const std::filesystem::path& path : paths) {
        try {
            SheetViews found = views_of_file(path, format);
            std::ranges::move(found.not_read, std::back_inserter(result.not_read));
            if (std::ranges::none_of(found.views, begins_study))
                refuse_to_begin(found.views.front());
            std::ranges::move(found.views, std::back_inserter(result.views));
        } catch (const InputError& error) {
            result.not_read.push_back(fmt::format("A file is not read: {}.", error.what()));
        }
    }
    // Of the reasons: more are alike, as a rule.
    const auto first =
        std::span(result.not_read).first(std::min<std::size_t>(3, result.not_read.size()));
    if (result.views.empty())
        throw InputError({paths.empty() ? "" : paths.front().parent_path().string()},
                         paths.empty()
                             ? "no file is given to begin a study with"
                             : fmt::format("no file can begin a study. {}", fmt::join(first, " ")));
    return result;
}

}  // namespace pendular
