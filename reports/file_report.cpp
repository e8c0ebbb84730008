#include "reports/file_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "data/files/column_names.h"
#include "data/files/formats/named_columns.h"
#include "data/files/header_cell.h"
#include "data/files/sheet_path.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/test_kinds.h"
#include "data/remarks/wording.h"
#include "reports/file_advice.h"
#include "reports/locus_report.h"
#include "reports/tables.h"
#include "workflow/file_views.h"

namespace pendular {
namespace {

std::size_t rows_of_file(const FileView& view) {
    std::size_t rows = 0;
    for (const IntervalSeries& series : view.series)
        rows += series.size();
    return rows;
}

const char* counted(std::size_t count, const char* one, const char* several) {
    return count == 1 ? one : several;
}

/// Number without a value as "-".
std::string known_text(double value) {
    return std::isfinite(value) ? short_text(value) : "-";
}

double greatest_size(const std::vector<double>& values) {
    double largest = std::nan("");
    for (const double value : values)
        if (std::isfinite(value) && !(std::abs(value) <= largest)) largest = std::abs(value);
    return largest;
}

const char* line_word(const std::vector<Lines>& lines) {
    return lines.size() == 1 && lines[0].first == lines[0].last ? "Line" : "Lines";
}

/// A column with the number of intervals that have it.
struct CountedColumn {
    const BlockColumn* column;
    std::size_t occurrence;  ///< of the column's name in an interval, from 0
    std::size_t intervals;
};

/// Columns of a file that differ in name, unit or use, or that an interval has twice.
std::vector<CountedColumn> distinct_columns(const BlockFile& file) {
    using Words = std::tuple<std::string_view, std::string_view, std::string_view, bool>;
    std::vector<CountedColumn> result;
    std::map<Words, std::vector<std::size_t>> known;  // places in the result, by occurrence
    for (const Block& block : file.blocks) {
        std::map<Words, std::size_t> before;
        for (const BlockColumn& column : block.columns) {
            if (column.name.empty()) continue;
            const Words words = {column.name, column.unit, column.quantity, column.of_errors};
            const std::size_t occurrence = before[words]++;
            std::vector<std::size_t>& places = known[words];
            if (occurrence == places.size()) {
                places.push_back(result.size());
                result.push_back({&column, occurrence, 0});
            }
            ++result[places[occurrence]].intervals;
        }
    }
    return result;
}

/// Whether the intervals of a file belong to several tests.
bool several_tests(const BlockFile& file) {
    return std::ranges::any_of(
        file.blocks, [&](const Block& block) { return block.test != file.blocks[0].test; });
}

/// Sentences on the rows that were left out, one for each reason.
std::vector<std::string> skipped_lines(const BlockFile& file, bool all) {
    std::vector<Remark> by_reason;
    for (const Remark& rows : file.skipped) {
        const auto known = std::ranges::find(by_reason, rows.kind, &Remark::kind);
        if (known == by_reason.end())
            by_reason.push_back(rows);
        else
            known->lines.push_back(rows.lines.front());
    }
    std::vector<std::string> lines;
    for (Remark& rows : by_reason) {
        std::ranges::sort(rows.lines, {}, &Lines::first);
        lines.push_back(fmt::format("  {} {}: {}. Left out.", line_word(rows.lines),
                                    text_of_lines(rows.lines, all ? rows.lines.size() : 8),
                                    text_of(rows)));
    }
    return lines;
}

}  // namespace

std::string file_sentence(const FileView& view) {
    const auto& all = layouts();
    const auto layout = std::ranges::find(all, view.file.layout, &Layout::name);
    const std::size_t intervals = view.file.blocks.size(), rows = rows_of_file(view);
    return fmt::format("{} is read as layout \"{}\" ({}): {} {}, {} {}.",
                       std::filesystem::path(view.file.file).filename().string(), view.file.layout,
                       layout->meaning, intervals, counted(intervals, "interval", "intervals"),
                       rows, counted(rows, "row", "rows"));
}

std::string encoding_sentence(const FileView& view) {
    const char delimiter = view.file.delimiter;
    const std::string separated = delimiter == '\t'  ? "tabs"
                                  : delimiter == ' ' ? "blanks"
                                                     : fmt::format("'{}'", delimiter);
    return fmt::format("Encoding {}, cells separated by {}, decimal mark '{}'.", view.file.encoding,
                       separated, view.file.numbers.decimal);
}

std::vector<std::string> columns_table(const FileView& view) {
    std::vector<std::string> lines = {
        fmt::format("  {:<40} {:<10} {}", "column", "unit", "read as")};
    for (const auto& [column, occurrence, intervals] : distinct_columns(view.file)) {
        const std::string part =
            intervals == view.file.blocks.size()
                ? ""
                : fmt::format(" (in {} of {} intervals)", intervals, view.file.blocks.size());
        const std::string read_as =
            column->quantity.empty()
                ? "not used"
                : fmt::format("{}{} [{}]", column->of_errors ? "error of " : "", column->quantity,
                              quantity(column->quantity).unit);
        lines.push_back(fmt::format("  {:<40} {:<10} {}{}", column->name,
                                    column->unit.empty() ? "-" : column->unit, read_as, part));
    }
    return lines;
}

std::vector<std::string> intervals_table(const FileView& view) {
    const bool forces = std::ranges::any_of(view.series, [](const IntervalSeries& series) {
        return series.normal_stress.empty() && !series.normal_force.empty();
    });
    const bool torques = std::ranges::any_of(view.series, [](const IntervalSeries& series) {
        return series.shear_stress.empty() && !series.torque.empty();
    });
    const bool levers = std::ranges::any_of(view.series, [](const IntervalSeries& series) {
        return series.shear_stress.empty() && series.torque.empty() && !series.lever_force.empty();
    });
    std::vector<std::string> lines = {
        fmt::format("  {:>8} {:<10} {:>6} {:>13} {:>18} {:>22}  {}", "interval", "role", "rows",
                    "lines", forces ? "normal force [N]" : "normal stress [Pa]",
                    torques  ? "largest torque [N m]"
                    : levers ? "largest lever force [N]"
                             : "largest stress [Pa]",
                    "why")};
    const bool several = several_tests(view.file);
    for (std::size_t i = 0; i < view.series.size(); ++i) {
        const Block& block = view.file.blocks[i];
        const IntervalSeries& series = view.series[i];
        std::string why = view.roles[i].reason;
        if (!block.name.empty()) why = fmt::format("{}: {}", block.name, why);
        if (several && !block.test.empty()) why = fmt::format("{}: {}", block.test, why);
        const std::string rows_lines =
            series.line.empty() ? "-"
                                : fmt::format("{}-{}", series.line.front(), series.line.back());
        lines.push_back(fmt::format("  {:>8} {:<10} {:>6} {:>13} {:>18} {:>22}  {}", block.number,
                                    view.roles[i].role, series.size(), rows_lines,
                                    known_text(median_of_known(series.normal())),
                                    known_text(greatest_size(series.shear())), why));
    }
    return lines;
}

std::vector<std::string> checks_lines(const FileView& view, bool all) {
    std::vector<std::string> lines;
    for (const Remark& finding : view.findings)
        lines.push_back("  " + with_lines(finding, all ? finding.lines.size() : 8));
    for (const std::string& line : skipped_lines(view.file, all))
        lines.push_back(line);
    if (lines.empty()) lines.emplace_back("  The checks found nothing wrong.");
    lines.insert(lines.begin(), "Checks of the file:");
    return lines;
}

namespace {

/// Heading and sentences on the findings inside the recordings; empty if there are none.
/// Saturations are left out without `all`, since warnings name them.
std::vector<std::string> findings_lines(std::vector<Remark> findings, bool all) {
    if (!all) {
        std::erase_if(findings,
                      [](const Remark& each) { return each.kind == Remark::Kind::saturation; });
    }
    std::vector<std::string> lines;
    for (const std::string& sentence : sentences(findings, all))
        lines.push_back("  " + sentence);
    if (!lines.empty()) lines.insert(lines.begin(), "The recordings themselves show:");
    return lines;
}

/// Heading and sentences on the files' headers and set points; empty for nothing.
std::vector<std::string> file_findings_lines(const std::vector<Remark>& findings, bool all) {
    std::vector<std::string> lines;
    for (const Remark& finding : findings)
        lines.push_back(fmt::format("  {}: {}",
                                    std::filesystem::path(finding.file()).filename().string(),
                                    with_lines(finding, all ? finding.lines.size() : 8)));
    if (!lines.empty()) lines.insert(lines.begin(), "Checks of the files show:");
    return lines;
}

}  // namespace

Output import_output(const Measurements& measurements, const std::filesystem::path& folder,
                     const std::string& study, bool all) {
    const std::string left_out = excluded_text(measurements);
    const std::string reason = common_reason(measurements).value_or("");
    Output output;
    output.answer(fmt::format("{} written to {}.{}{}{}",
                              measurements.readings.size() == 1
                                  ? "1 reading"
                                  : fmt::format("{} readings", measurements.readings.size()),
                              (folder / "readings.csv").string(),
                              left_out.empty()
                                  ? ""
                                  : fmt::format(" Excluded: {} (listed in {}).", left_out,
                                                (folder / "excluded.csv").string()),
                              reason.empty() ? "" : " ", reason));
    for (const Remark& doubt : measurements.doubts()) {
        output.line(fmt::format("Warning: {} {}", text_of(doubt),
                                doubt.outcome == Remark::Outcome::set_aside
                                    ? "The affected readings are excluded."
                                    : "The affected readings are kept."));
    }
    output.table(findings_lines(measurements.faults(true), all), 6);
    output.table(file_findings_lines(measurements.faults(false), all), 6);
    if (!measurements.readings.empty()) output.table(readings_table(measurements), 7);
    if (all) output.table(excluded_table(measurements), 0);
    output.table(scatter_table(measurements), 5);
    for (const Remark& note : measurements.notes()) {
        output.note(text_of(note));
    }
    if (measurements.readings.empty()) {
        output.note(
            fmt::format("No step of the recordings gave a reading. 'pendular import {} --all' "
                        "lists the excluded rows with the reasons.",
                        study));
    }
    return output;
}

namespace {

/// The most frequent reason for which intervals are another kind of test; of equally frequent ones
/// the first. Those without values give none where others give one.
std::string usual_reason(const FileView& view) {
    std::map<std::string, std::size_t> counts;
    std::string best;
    for (const IntervalRole& each : view.roles)
        if (each.role == "other" && !each.reason.starts_with("no values")) ++counts[each.reason];
    for (const IntervalRole& each : view.roles)
        if (counts.contains(each.reason) && (best.empty() || counts[each.reason] > counts[best]))
            best = each.reason;
    const auto none = std::ranges::find(view.roles, "other", &IntervalRole::role);
    return best.empty() && none != view.roles.end() ? none->reason : best;
}

/// Why nothing of a file is used.
std::string unused_reason(const FileView& view) {
    const bool sheared = std::ranges::any_of(view.roles, [](const IntervalRole& each) {
        return each.role == "steady" || each.role == "failure" || each.role == "preshear";
    });
    std::string reason = "it has neither steady shear nor points of failure";
    if (const std::string other = usual_reason(view); !other.empty()) reason = other;
    if (sheared && is_recorded_in_tension(view))
        reason =
            "the normal force is negative in nearly all rows, where compression must be positive: "
            "reverse the sign of the column in the file";
    if (sheared && !view.missing.empty())
        reason = fmt::format("it has no {}", fmt::join(view.missing, ", no "));
    if (sheared && lacks(view, "time") && lacks(view, "speed of the lid") && lacks(view, "gap"))
        reason +=
            ", and is no table of points of failure: that has normal and shear stresses, in at "
            "least three rows whose normal stresses differ";
    return reason;
}

}  // namespace

std::string unused_sentence(const std::vector<FileView>& views) {
    const auto useful = [](const FileView& view) { return is_used(view) || shows_readings(view); };
    if (std::ranges::any_of(views, useful)) return "";
    std::vector<std::pair<std::string, std::vector<std::string>>> files;  // by reason
    for (const FileView& view : views) {
        const std::string reason = unused_reason(view);
        auto known = std::ranges::find(files, reason, &decltype(files)::value_type::first);
        if (known == files.end()) known = files.insert(files.end(), {reason, {}});
        known->second.push_back(std::filesystem::path(view.file.file).filename().string());
    }
    std::vector<std::string> sentences;
    for (const auto& [reason, names] : files)
        sentences.push_back(
            fmt::format("Nothing of {} is used: {}.", fmt::join(names, ", "), reason));
    return fmt::format("{}", fmt::join(sentences, " "));
}

Output file_output(const FileView& view, bool all, bool is_answer) {
    Output output;
    if (is_answer)
        output.answer(file_sentence(view));
    else
        output.line(file_sentence(view));
    output.line(encoding_sentence(view));
    output.table(columns_table(view), 20);
    output.table(intervals_table(view), 10);
    output.table(checks_lines(view, all), 10);
    output.lines(yield_locus_lines(view));
    output.lines(wall_locus_lines(view));
    if (const std::string missing = missing_sentence(view); !missing.empty()) output.note(missing);
    for (const BlockColumn& column : view.candidates)
        if (column.quantity == "interval")
            output.note(fmt::format(
                "Column '{0}' changes exactly where the speed or the load does: if it numbers the "
                "intervals, name it by --columns or in [[recording]], columns = {{ interval = "
                "\"{0}\" }}",
                column.name));
    for (const std::string& sentence : corrected_sentences(view))
        output.note(sentence);
    for (const auto& [quantity_name, column] : view.by_unit) {
        const bool clock = !unit_fits(parse_header_cell(column).unit, quantity_name) ||
                           parse_header_cell(column).unit.empty();
        output.note(fmt::format(
            "Column '{}' is read as the {}, since {}; if it is something else, name the right one "
            "by --columns or in [[recording]], as in columns = {{ {} = \"{}\" }}",
            column, quantity(quantity_name).meaning,
            clock ? "it has clock times and no other has times"
                  : "by name and unit no other may be it",
            quantity_name, column));
    }
    return output;
}

std::string groups_sentence(const FileView& view, const std::vector<std::string>& groups,
                            const std::filesystem::path& toml) {
    constexpr std::size_t told = 5;
    std::vector<std::string> names;
    for (const std::string& group : groups)
        if (names.size() < told) names.push_back(group.empty() ? "rows without a name" : group);
    return fmt::format(
        "{} holds {} groups of points: {}{}. A study describes one material: {} reads the first "
        "group alone. Each group has a table of its own beside it; for those of the same grains, "
        "remove the '#' before their lines.",
        std::filesystem::path(view.file.file).filename().string(), groups.size(),
        fmt::join(names, "; "), groups.size() > told ? "; ..." : "", toml.string());
}

std::string guesses_sentence(std::size_t guesses, const std::filesystem::path& toml) {
    return fmt::format(
        "{} of the values in {} {}, marked GUESS, since the file does not state {}: replace {} "
        "before the study is calibrated.",
        guesses, toml.string(), guesses == 1 ? "is a guess" : "are guesses",
        guesses == 1 ? "it" : "them", guesses == 1 ? "it" : "them");
}

}  // namespace pendular
