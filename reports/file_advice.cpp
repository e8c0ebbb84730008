#include "reports/file_advice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/folded_name.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/named_columns.h"
#include "data/files/header_cell.h"
#include "data/files/sheet_path.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/test_kinds.h"
#include "workflow/file_views.h"

namespace pendular {

bool shows_readings(const FileView& view) {
    return view.file.layout == "plain" && !view.file.table_of_points &&
           is_table_of_readings(view.file.blocks.front());
}

bool lacks(const FileView& view, std::string_view name) {
    return std::ranges::find(view.missing, name) != view.missing.end();
}

namespace {

/// How study.toml names a file in [[readings]]: a sheet by a key of its own.
std::string file_in_study(const std::filesystem::path& path) {
    if (const auto part = as_sheet(path))
        return fmt::format("file = \"{}\" and sheet = \"{}\"", part->book.filename().string(),
                           part->sheet);
    return fmt::format("file = \"{}\"", path.filename().string());
}

/// Advice on a column that is not used although it may be what is missing.
std::string candidate_sentence(const BlockColumn& column, const FileView& view) {
    const std::string meanings = possible_meanings(column, view);
    if (names_factor_of_numbers(column.name))
        return fmt::format(
            "Column '{} [{}]' is not used, since its name has a factor, by which the numbers may "
            "have been multiplied or divided; write them in the unit of the column, without a "
            "factor.",
            column.name, column.unit);
    if (unit_fits(column.unit, column.quantity))
        // Units of the other layouts stand in a row of their own.
        return fmt::format(
            "Column '{} [{}]' is not used; if it is {}, state it in [[recording]], or for one "
            "file by --columns: {}",
            column.name, column.unit, meanings,
            line_to_name(column.quantity, column.name, column.unit));
    std::string text = fmt::format("Column '{} [{}]' is not used: {}", column.name, column.unit,
                                   why_unit_is_wrong(column.unit, column.quantity));
    if (!text.ends_with('?')) text += '.';
    if (const std::string weight = weight_meant(column.unit);
        !weight.empty() && unit_fits(weight, column.quantity))
        text += fmt::format(" If it is {}, state it so: {}.", meanings,
                            line_to_name(column.quantity, column.name, weight));
    // A unit that is no unit may be one in another language.
    if (!is_unit(column.unit))
        text += fmt::format(
            " If it is {}, state it with its unit, in [[recording]], or for one file by "
            "--columns: {}.",
            meanings, line_to_name(column.quantity, column.name, usual_unit(column.quantity)));
    return text;
}

/// Advice on columns of results, of which no study is made; empty if there are none.
std::string results_sentence(const FileView& view) {
    std::vector<std::string> names;
    for (const BlockColumn& column : view.file.blocks.front().columns)
        if (column.quantity.empty() && names_result_of_locus(column)) names.push_back(column.name);
    if (names.empty()) return "";
    return fmt::format(
        "Its columns '{}' are results of yield loci, of which no study is made: export the points "
        "of failure, with their normal and shear stresses.",
        fmt::join(names, "', '"));
}

/// Advice on a file whose load differs from row to row; empty for others.
std::string rows_sentence(const FileView& view) {
    if (view.series.size() != 1 || !loads_differ_by_row(view.series.front())) return "";
    const IntervalSeries& series = view.series.front();
    if (series.shear_stress.empty() || series.normal_stress.empty()) return "";
    if (lacks(view, "time") && lacks(view, "gap") && lacks(view, "speed of the lid")) return "";
    if (lacks(view, "time"))
        return "If each row is the mean of steady shear, name the file in [[readings]] of "
               "study.toml, with columns of the normal stress, the shear stress, the solid "
               "fraction "
               "or bulk density, and the shear rate or inertial number.";
    return "If each row is one test, leave out the column of times, or call it otherwise: the file "
           "is then a table of points of failure.";
}

/// Advice where no interval has all columns of steady shear.
std::string advice_on_missing(const FileView& view) {
    if (!view.loci.empty()) return "Its points of failure need only the stresses.";
    if (std::string results = results_sentence(view); !results.empty()) return results;
    std::string rows = rows_sentence(view);
    if (!rows.empty()) return rows;
    // Where columns may be what is missing, they are there.
    return view.candidates.size() >= view.missing.size() ? "" : "Export these columns too.";
}

/// Advice on a file with the angle of the lid in place of its speed; empty for others.
std::string angle_sentence(const FileView& view) {
    if (!lacks(view, "speed of the lid") || lacks(view, "time")) return "";
    static constexpr std::array<std::string_view, 5> words = {"angle", "winkel", "angulo", "ángulo",
                                                              "angolo"};
    for (const BlockColumn& column : view.file.blocks.front().columns) {
        const std::string name = lower_case(column.name);
        const bool angle = std::ranges::any_of(
            words, [&](std::string_view word) { return name.find(word) != std::string::npos; });
        if (angle && column.quantity.empty() && !column.unit.empty() && is_unit(column.unit) &&
            Unit(column.unit).same_dimension(Unit("rad")))
            return fmt::format(
                "No speed is computed from the column '{}': add a column 'Angular velocity "
                "[rad/s]' "
                "with the change of the angle over that of the time.",
                column.name);
    }
    return "";
}

/// Adds a sentence to others, of which the last may end with a line to paste.
void add_sentence(std::string& text, const std::string& sentence) {
    if (!text.ends_with('.') && !text.ends_with('?')) text += '.';
    text += ' ' + sentence;
}

}  // namespace

std::string missing_sentence(const FileView& view) {
    if (shows_readings(view))
        return fmt::format(
            "The file has all that a table of readings needs: write {} below [[readings]] in "
            "study.toml.",
            file_in_study(view.file.file));
    const bool other_tests = std::ranges::all_of(
        view.roles, [](const IntervalRole& each) { return each.role == "other"; });
    if (other_tests && !lacks(view, "torque or shear stress") &&
        !lacks(view, "normal force or normal stress"))
        return "No interval is steady shear or shear to failure: a study reads nothing of this "
               "file.";
    if (view.missing.empty() || view.file.layout == "yield-locus-report" || !view.walls.empty())
        return "";
    std::string text = fmt::format(
        "The file has no {}: steady shear with a solid fraction cannot be read from it.",
        fmt::join(view.missing, ", no "));
    if (const std::string advice = advice_on_missing(view); !advice.empty())
        add_sentence(text, advice);
    if (const std::string angle = angle_sentence(view); !angle.empty()) add_sentence(text, angle);
    constexpr std::size_t most = 4;  // of many columns in pascals, none is more likely than another
    for (const BlockColumn& column :
         std::span(view.candidates).first(std::min(most, view.candidates.size())))
        if (column.quantity != "interval")  // not missing
            add_sentence(text, candidate_sentence(column, view));
    if (view.candidates.size() > most)
        add_sentence(
            text, fmt::format("{} further columns are not used.", view.candidates.size() - most));
    return text;
}

namespace {

/// Whether a column is that of another after a correction: its name has a word for one more.
bool corrects(const BlockColumn& column, const BlockColumn& raw) {
    constexpr std::array<std::string_view, 14> words = {
        "corr",    "tared", "zeroed",    "net",  "compens",  "adjust",    "korr",
        "tariert", "netto", "bereinigt", "tare", "corregid", "compensat", "kompens"};
    const std::string all = lower_case(column.name), name = lower_case(raw.name);
    if (all == name || !all.starts_with(name) || column.unit != raw.unit) return false;
    const std::string_view rest = trimmed(std::string_view(all).substr(name.size()));
    return std::ranges::any_of(words, [&](std::string_view word) {
        return rest.substr(std::min(rest.find_first_not_of("([-_ "), rest.size()))
            .starts_with(word);
    });
}

}  // namespace

std::vector<std::string> corrected_sentences(const FileView& view) {
    std::vector<std::string> sentences;
    if (!is_own_table(view.file.layout)) return sentences;
    const std::vector<BlockColumn>& columns = view.file.blocks.front().columns;
    for (const BlockColumn& column : columns) {
        if (!column.quantity.empty() || column.unit.empty()) continue;
        const auto raw = std::ranges::find_if(columns, [&](const BlockColumn& each) {
            return !each.quantity.empty() && !each.of_errors && corrects(column, each);
        });
        if (raw == columns.end()) continue;
        sentences.push_back(fmt::format(
            "Column '{0} [{1}]' is not used, and '{2} [{1}]' is; for the corrected values, write "
            "columns = {{ {3} = \"{0} [{1}]\" }} below [[recording]], or for one file by "
            "--columns",
            column.name, column.unit, raw->name, raw->quantity));
    }
    return sentences;
}

}  // namespace pendular
