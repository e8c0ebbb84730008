#include "data/remarks/wording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/statistics.h"
#include "data/quantities/units.h"

namespace pendular {

std::string file_name_of(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

std::string with_capital(std::string text) {
    if (!text.empty())
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

std::string words_for_quantity(std::string quantity) {
    if (quantity == "height") return "gap";
    std::ranges::replace(quantity, '_', ' ');
    return quantity;
}

namespace {

using Kind = Remark::Kind;

// Faults inside recordings.

/// Faults that one sentence describes.
using Group = std::vector<const Remark*>;

bool alike(const Remark& a, const Remark& b) {
    const bool wobble = a.kind == Kind::wobble;
    return a.kind == b.kind && a.quantity == b.quantity && (!wobble || a.period == b.period);
}

std::vector<Group> groups_of(const std::vector<Remark>& faults, bool all) {
    std::vector<Group> groups;
    for (const Remark& each : faults) {
        const auto same = std::ranges::find_if(
            groups, [&](const Group& group) { return alike(*group.front(), each); });
        all || same == groups.end() ? groups.push_back({&each}) : same->push_back(&each);
    }
    std::ranges::stable_sort(groups, {}, [](const Group& group) { return group.front()->kind; });
    return groups;
}

std::string with_unit(const std::string& quantity, double value) {
    const bool force = quantity == "normal_force" || quantity == "lever_force";
    const bool stress = quantity == "shear_stress";
    const char* const unit = force ? "N" : stress ? "Pa" : quantity == "height" ? "mm" : "mN m";
    const double shown = force || stress ? value : 1e3 * value;
    return std::abs(shown) < 100 ? fmt::format("{:.2g} {}", shown, unit)
                                 : fmt::format("{:.0f} {}", shown, unit);
}

template <typename Member>
double usual(const Group& group, Member member) {
    std::vector<double> values;
    for (const Remark* each : group)
        values.push_back(each->*member);
    return median(std::move(values));
}

/// Text with the steps of a group: "step 3 of dry_1.csv" or "12 steps of 3 files, first step 1 of
/// dry_1.csv".
std::string places(const Group& group) {
    const Remark& first = *group.front();
    std::size_t steps = 0;
    std::set<std::string> files;
    for (const Remark* each : group) {
        steps += each->count;
        files.insert(each->files.begin(), each->files.end());
    }
    const std::string file = file_name_of(first.files.front());
    const std::string place = first.step > 0 ? fmt::format("step {} of {}", first.step, file)
                                             : fmt::format("in {}", file);
    if (steps == 1) return place;
    if (files.size() == 1) return fmt::format("{} steps of {}", steps, file);
    return fmt::format("{} steps of {} files, first {}", steps, files.size(), place);
}

std::string p_text(const Group& group) {
    double p = 1;
    for (const Remark* each : group)
        p = std::min(p, each->p);
    return p < 1e-3 ? "p < 0.001" : fmt::format("p = {:.1g}", p);
}

/// Size with its unit and in per cent: "0.03 mm (0.5 %)".
std::string size_text(const Group& group) {
    return fmt::format("{} ({:.2g} %)",
                       with_unit(group.front()->quantity, usual(group, &Remark::size)),
                       100 * usual(group, &Remark::relative));
}

std::string saturation_text(const Group& group) {
    const Remark& first = *group.front();
    // Of a file that is not read as a study, the rows of an interval are meant.
    const std::string place = first.step > 0 ? places(group) : file_name_of(first.files.front());
    return fmt::format(
        "Saturation: the {} stands at its largest value, {}, in {:.0f} % of the rows of {}. {}",
        words_for_quantity(first.quantity), with_unit(first.quantity, first.size),
        100 * usual(group, &Remark::relative), place,
        first.corrected ? "A reading with more than 1 % of such rows is not used."
                        : "The true values are larger.");
}

std::string level_text(const Group& group) {
    const Remark& first = *group.front();
    const double percent = 100 * std::abs(first.relative);
    const std::string change =
        first.offset ? fmt::format("{} (about {:.2g} %)",
                                   with_unit(first.quantity, std::abs(first.size)), percent)
                     : fmt::format("{:.3g} +- {:.1g} %", percent, 100 * first.relative_error);
    return fmt::format(
        "A step between recordings: from {} on, the {} at comparable conditions is {} {} than "
        "before ({} recordings, {}). Was the lid remounted, or the instrument changed?",
        file_name_of(first.files.front()), words_for_quantity(first.quantity), change,
        first.relative > 0 ? "larger" : "smaller", first.count, p_text(group));
}

std::string wobble_text(const Group& group) {
    const Remark& first = *group.front();
    const bool corrected = std::ranges::any_of(group, &Remark::corrected);
    return fmt::format("Wobble: the {} varies by +-{} {} per turn of the lid in {} ({}).{}",
                       words_for_quantity(first.quantity), size_text(group),
                       first.period == 1 ? "once" : "twice", places(group), p_text(group),
                       corrected ? " Readings that it affects are averaged over whole turns." : "");
}

std::string stick_slip_text(const Group& group) {
    return fmt::format("Stick-slip: the torque drops suddenly by {} every {:.2g} s in {} ({}).",
                       size_text(group), usual(group, &Remark::period), places(group),
                       p_text(group));
}

std::string drift_text(const Group& group) {
    const Remark& first = *group.front();
    return fmt::format(
        "Drift: the {} {} by {:.2g} +- {:.1g} % within a step, after its transient, on average "
        "over {} ({}). Look for wear, or for a loss of liquid or beads{}.",
        words_for_quantity(first.quantity), first.relative > 0 ? "rises" : "falls",
        100 * std::abs(first.relative), 100 * first.relative_error, places(group), p_text(group),
        first.quantity == "height" && first.relative < 0
            ? ", or for a part of the bed that is not sheared and compacts"
            : "");
}

std::string run_in_text(const Group& group) {
    return fmt::format(
        "Run-in: at the end of the step the {} is still {} from its level in {} ({}). Shear "
        "longer.",
        words_for_quantity(group.front()->quantity), size_text(group), places(group),
        p_text(group));
}

std::string sentence(const Group& group) {
    switch (group.front()->kind) {
        case Kind::saturation:
            return saturation_text(group);
        case Kind::level_change:
            return level_text(group);
        case Kind::wobble:
            return wobble_text(group);
        case Kind::stick_slip:
            return stick_slip_text(group);
        case Kind::drift:
            return drift_text(group);
        case Kind::unfinished_run_in:
            return run_in_text(group);
        default:
            throw std::logic_error("a fault inside recordings has no words");
    }
}

// Faults of files.

const char* stress_for(const std::string& measured) {
    return measured == "torque" ? "shear stress" : "normal stress";
}

std::string ratio_text(const Remark& fault) {
    constexpr double decimal_tolerance = 0.05;  // as in file_checks.cpp
    const bool decimal = power_of_ten(fault.size, decimal_tolerance).value_or(0) != 0;
    const std::string force = words_for_quantity(fault.quantity),
                      stress = stress_for(fault.quantity);
    return fmt::format(
        "{} and {} contradict each other in {} of {} rows: the {} is {} times what the {} gives{}.",
        force, stress, fault.count, fault.of, force, short_text(fault.size), stress,
        decimal ? ", as if a decimal or thousands mark was lost when the table was converted" : "");
}

std::string tests_text(const Remark& fault) {
    return fmt::format("the file holds {} tests, whose intervals are numbered anew: {}{}.",
                       fault.count, fmt::join(fault.names, "; "),
                       fault.count > fault.names.size() ? "; ..." : "");
}

std::string header_text(const Remark& fault) {
    const std::string &key = fault.names[0], &text = fault.names[1], &name = fault.names[2],
                      &unit = fault.names[3];
    return fmt::format(
        "the header states {} = {}, which is {} {} of {} {}; {} {} {} instead ({:+.1f} %).", key,
        text, std::string_view("io").find(name[0]) < 2 ? "an" : "a", name, short_text(fault.size),
        unit, fault.kind == Kind::header_cell ? "study.toml gives" : "the columns give",
        short_text(fault.limit), unit, 100 * fault.relative);
}

std::string set_point_text(const Remark& fault) {
    const std::string unit = fault.names[0].empty() ? "" : " " + fault.names[0];
    return fmt::format(
        "in {} of {} stretches of constant set point the {} does not follow its set point: by up "
        "to {:+.1f} %, {}{} where {}{} is set.",
        fault.count, fault.of, quantity(fault.quantity).meaning, 100 * fault.relative,
        short_text(fault.size), unit, short_text(fault.limit), unit);
}

std::string far_values_text(const Remark& fault) {
    const std::string unit = fault.names[1].empty() ? "" : " " + fault.names[1];
    return fmt::format(
        "the {} is {}{} in {}, far off the other rows.", words_for_quantity(fault.quantity),
        fault.names[0], unit,
        fault.count == 1 ? "one row" : fmt::format("the first of {} rows", fault.count));
}

/// Advice on values far off those of the other rows.
std::string far_values_advice(const Remark& fault) {
    if (fault.corrected)
        return "A study leaves such rows out; look for a disturbance, or a wrong column.";
    return fmt::format(
        "If it stands for no value, write missing = [\"{}\"] below [[recording]] in "
        "study.toml.",
        fault.names[0]);
}

std::string file_text(const Remark& fault) {
    switch (fault.kind) {
        case Kind::ratio_of_columns:
            return ratio_text(fault);
        case Kind::swapped_columns:
            return fmt::format(
                "the column of {} is proportional to the {}, the column of {} is not: the two "
                "columns are in each other's place.",
                fault.names[0], fault.names[1], fault.names[2]);
        case Kind::declared_rows:
            return fmt::format("interval {} declares {} points and has {}.", fault.names[0],
                               fault.of, fault.count);
        case Kind::time_goes_back:
            return "time goes back within an interval: two measurements may have been joined.";
        case Kind::no_compression:
            return fmt::format("the normal force or stress is negative in {} of {} rows.",
                               fault.count, fault.of);
        case Kind::repeated_rows:
            return fmt::format("{} rows repeat the row before them in all columns.", fault.count);
        case Kind::several_tests:
            return tests_text(fault);
        case Kind::missed_set_point:
            return set_point_text(fault);
        case Kind::header_constant:
        case Kind::header_cell:
            return header_text(fault);
        case Kind::missing_values:
            return fmt::format("{} of {} rows have no value of the {}.", fault.count, fault.of,
                               words_for_quantity(fault.quantity));
        case Kind::hidden_rows:
            return "the workbook hides these rows.";
        case Kind::filled_down:
            return fmt::format("'{}' has no value here.", fault.names[0]);
        case Kind::far_values:
            return far_values_text(fault);
        case Kind::impossible_points:
            return fmt::format(
                "{} of {} points have a stress of nines alone, which does not go with the others.",
                fault.count, fault.of);
        case Kind::returning_load:
            if (!fault.names.empty())
                return fmt::format(
                    "points at different values of the column '{}' have the same "
                    "normal stresses, and count as points of one test.",
                    fmt::join(fault.names, "' and '"));
            return fmt::format(
                "{} of {} points of failure stand at a normal stress that returns, each before one "
                "at a lower normal stress, as preshears do.",
                fault.count, fault.of);
        case Kind::falling_line:
            return fmt::format("the shear stress of the points{} falls as the normal stress rises.",
                               fault.names[0].empty() ? "" : " of " + fault.names[0]);
        case Kind::cycles_in_one_interval:
            return fmt::format(
                "the normal load returns {} time{} to its largest value after a lower one, as in "
                "preshear and shear to failure.",
                fault.count, fault.count == 1 ? "" : "s");
        default:
            throw std::logic_error("a fault of a file has no words");
    }
}

}  // namespace

std::string done_about(const Remark& fault) {
    switch (fault.kind) {
        case Kind::ratio_of_columns:
            return fmt::format(
                "Here the {} of these rows is used, not the {}; a study sets these rows aside, or "
                "with repair = true takes torques from shear stresses.",
                stress_for(fault.quantity), words_for_quantity(fault.quantity));
        case Kind::saturation:
            return "The true values may be larger.";
        case Kind::swapped_columns:
            return "Correct the header or state 'columns' in study.toml; nothing was changed.";
        case Kind::declared_rows:
            return fault.count < fault.of
                       ? "The rows are used; if the file was cut off, export it again."
                       : "All rows are used.";
        case Kind::time_goes_back:
            return "Split the interval there; as a recording, the file is refused.";
        case Kind::no_compression:
            return "Compression must be positive, or a study makes no readings of these rows: "
                   "reverse the sign of the column in the file.";
        case Kind::repeated_rows:
            return "They are kept; check the export.";
        case Kind::several_tests:
            return "Intervals of different tests are never joined.";
        case Kind::header_constant:
            return "The columns are used.";
        case Kind::header_cell:
            return "The cell of study.toml is used; correct [cell] if the header is right.";
        case Kind::missing_values:
            return 2 * fault.count > fault.of
                       ? "The column counts as recorded less often than the others."
                       : "A study leaves these rows out.";
        case Kind::hidden_rows:
            return "They are read; delete them if they are not to count.";
        case Kind::filled_down:
            return "The value above applies, as in merged cells.";
        case Kind::far_values:
            return far_values_advice(fault);
        case Kind::impossible_points:
            return "They are not used. If such a number stands for no value, leave its cell empty.";
        case Kind::returning_load:
            if (!fault.names.empty())
                return "If each value is a test of its own, name the column 'Test'; if the points "
                       "are repeats of one test, nothing is to be done.";
            return "They count as points of failure; if they are preshears, say so in a column "
                   "that has \"preshear\" in these rows and \"shear\" in the others.";
        case Kind::falling_line:
            return "No yield locus falls: check the rows, and which column has which stress.";
        case Kind::cycles_in_one_interval:
            return "Number these steps in a column 'Interval', and the yield locus is found.";
        case Kind::missed_set_point:
            return "The measured values are used, not the set points; check the control of the "
                   "instrument and the gap.";
        default:
            throw std::logic_error("a fault of a file says not what was done about it");
    }
}

std::string text_of_lines(const std::vector<Lines>& lines, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) {
        const auto& [first, last, file] = lines[i];
        text +=
            fmt::format("{}{}", text.empty() ? "" : ", ",
                        first == last ? std::to_string(first) : fmt::format("{}-{}", first, last));
    }
    if (lines.size() > most) text += fmt::format(" and {} more ranges", lines.size() - most);
    return text;
}

std::string with_lines(const Remark& fault, std::size_t most) {
    const std::string what = fault_text(fault), done = done_about(fault);
    if (fault.lines.empty()) return fmt::format("{} {}", with_capital(what), done);
    const bool one = fault.lines.size() == 1 && fault.first_line() == fault.last_line();
    return fmt::format("{} {}: {} {}", one ? "Line" : "Lines", text_of_lines(fault.lines, most),
                       what, done);
}

std::vector<std::string> sentences(const std::vector<Remark>& faults, bool all) {
    std::vector<std::string> result;
    for (const Group& group : groups_of(faults, all))
        result.push_back(sentence(group));
    return result;
}

std::string fault_text(const Remark& fault) {
    return inside_recording(fault.kind) ? sentences({fault}).front() : file_text(fault);
}

}  // namespace pendular
