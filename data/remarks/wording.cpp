#include "data/remarks/wording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/recordings/plausibility.h"
#include "data/recordings/recording.h"
#include "data/recordings/robust.h"
#include "data/recordings/step_series.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Words for the column that was measured, where the instrument computed another from it.
const char* measured_for(const std::string& computed) {
    return computed == "shear_stress"    ? "torque"
           : computed == "normal_stress" ? "normal force"
                                         : "angular velocity";
}

// Values that are probably wrong.

/// Words for a quantity of a reading that has a range of possible values; `numerator` and
/// `denominator` are the measured quantities with which it increases and decreases.
struct ValueWords {
    const char *quantity, *why_not_less, *why_not_more, *check, *numerator, *denominator;
};

constexpr std::array value_words = {
    ValueWords{"solid_fraction", "too low for grains in contact in steady shear",
               "the densest packing of equal spheres",
               "the zero and the unit of the gap height, the total bead mass and the density",
               "total bead mass", "gap"},
    ValueWords{"stress_ratio", "half of the stress ratio of frictionless grains",
               "more than dry grains of any shape have",
               "the torque, the normal force, their units and the radii of the cell", "torque",
               "normal force"},
    ValueWords{"inertial_number", "", "above which grains collide rather than touch: no dense flow",
               "the angular velocity or shear rate (turns or radians, per second or minute), the "
               "bead diameter and the normal force",
               "speed", ""},
    ValueWords{"reduced_pressure", "below which grains form lumps and no state was simulated", "",
               "the normal force, the bead diameter and the surface tension", "normal force",
               "surface tension"}};

/// Text with the power of ten that leads to a usual value: " (a bead mass 10 times smaller or a gap
/// 10 times larger would give 0.6)"; empty if no power of ten does.
std::string power_of_ten(const Remark& doubt, const ValueWords& words) {
    const int power = power_to_usual(doubt.quantity, doubt.size);
    if (power == 0) return "";
    const auto change = [&](const char* what, bool larger) {
        return fmt::format("a {} {:.0f} times {}", what, std::pow(10, std::abs(power)),
                           larger ? "larger" : "smaller");
    };
    const std::string_view denominator = words.denominator;
    return fmt::format(" ({}{} would give {:.2g})", change(words.numerator, power > 0),
                       denominator.empty() ? "" : " or " + change(words.denominator, power < 0),
                       doubt.size * std::pow(10, power));
}

/// Words for an impossible value after the value itself: "above 0.74, the densest packing of equal
/// spheres; check the gap".
std::string limit_and_check(const Remark& doubt) {
    if (doubt.quantity == "liquid_content") {
        const std::string warning = pendular_range_warning(doubt.size).value_or("");
        const bool percent = doubt.size >= 0.1 && beyond_pendular_range(doubt.size / 100) == 0;
        return fmt::format("{}; check liquid_content, the volume of liquid over that of beads{}",
                           warning.substr(warning.find(" is ") + 4),
                           percent ? fmt::format(": {:g} would be right in percent, so write {:g} "
                                                 "or \"{:g} %\"",
                                                 doubt.size, doubt.size / 100, doubt.size)
                                   : "");
    }
    const ValueWords& words =
        *std::ranges::find(value_words, std::string_view(doubt.quantity), &ValueWords::quantity);
    const bool below = doubt.size < doubt.limit;
    const bool wet =
        doubt.quantity == "stress_ratio" && doubt.limit > greatest_stress_ratio(INFINITY);
    return fmt::format("{} {:.3g}, {}; check {}{}", below ? "below" : "above", doubt.limit,
                       below ? words.why_not_less
                       : wet ? "1.5 (1 + 1/P*), more than wet grains can have at this P*"
                             : words.why_not_more,
                       words.check, power_of_ten(doubt, words));
}

std::string impossible_text(const Remark& doubt) {
    return fmt::format("the {} {:.3g} is {}", words_for_quantity(doubt.quantity), doubt.size,
                       limit_and_check(doubt));
}

/// Sentence on the readings with impossible values of one quantity.
std::string impossible_sentence(const Remark& doubt) {
    std::string where = to_string(Position{doubt.file(), doubt.first_line(), 0});
    if (doubt.lines.size() > 1)
        where += fmt::format(" ({} readings in {} file{})", doubt.lines.size(), doubt.files.size(),
                             doubt.files.size() > 1 ? "s" : "");
    const std::string least = fmt::format("{:.3g}", doubt.size),
                      greatest = fmt::format("{:.3g}", doubt.size_to);
    return fmt::format("{}: the {} {} is {}.", where, words_for_quantity(doubt.quantity),
                       least == greatest ? least : least + " to " + greatest,
                       limit_and_check(doubt.because.front()));
}

/// Likely cause of a constant factor between a stated and a computed column.
std::string cause_of(const Remark& doubt) {
    constexpr double factor_tolerance = 0.02;
    const auto is = [&](double other) {
        return std::abs(doubt.size / other - 1) < factor_tolerance;
    };
    if (doubt.quantity == "shear_stress" && (is(2) || is(0.5)))
        return "the printed torque formula gives twice the derived one: see torque_formula in "
               "[cell]";
    const double power = std::round(std::log10(doubt.size));
    if (power != 0 && is(std::pow(10, power)))
        return fmt::format(
            "a factor of 10^{:.0f}: check the units of both columns{}", power,
            doubt.quantity == "shear_stress"
                ? "; if only some torques lost a mark, repair = true in [[recording]] takes them "
                  "from the shear stress"
                : "");
    if (doubt.quantity == "shear_rate" && (is(2 * M_PI) || is(0.5 / M_PI)))
        return "a factor of 2 pi: turns per second read as radians per second or the reverse";
    return "check inner_radius and outer_radius in [cell]: the instrument used others, or another "
           "formula";
}

std::string factor_text(const Remark& doubt) {
    return fmt::format(
        "the column of the {} is {:.4g} times what the {} gives with the study's cell (median of "
        "{} rows, {:.0f} % of them agree); {}",
        words_for_quantity(doubt.quantity), doubt.size, measured_for(doubt.quantity), doubt.of,
        100 - 100.0 * static_cast<double>(doubt.count) / static_cast<double>(doubt.of),
        cause_of(doubt));
}

std::string contradicting_rows_text(const Remark& doubt) {
    const std::string stated = words_for_quantity(doubt.quantity),
                      measured = measured_for(doubt.quantity);
    return fmt::format(
        "{}: {} and {} contradict each other in {} of {} rows, first in line {}, where the {} is "
        "{:.3g} times what the {} gives; elsewhere they agree (median ratio {:.4g}). Check whether "
        "cells of one of the columns are corrupt.",
        doubt.file(), stated, measured, doubt.count, doubt.of, doubt.first_line(), stated,
        doubt.size, measured, doubt.limit);
}

std::string constant_text(const Remark& doubt) {
    const bool torque = doubt.kind == Kind::constant_torque;
    return fmt::format(
        "the {} in every row, as no measurement would be; check {}",
        torque ? fmt::format("torque is {:.4g} N m", doubt.size)
               : fmt::format("gap is {:.4g} mm", 1e3 * doubt.size),
        torque ? "whether the torque was recorded, or a set point or an empty channel instead"
               : "whether the gap was measured or is a set point, whose error is unknown");
}

/// Names of files: "a.csv", "a.csv and b.csv", "a.csv, b.csv and 5 more".
std::string names_of(const std::vector<std::string>& files) {
    const std::string first = file_name_of(files.front());
    if (files.size() == 1) return first;
    const std::string second = file_name_of(files[1]);
    return files.size() == 2 ? first + " and " + second
                             : fmt::format("{}, {} and {} more", first, second, files.size() - 2);
}

std::string speed_unit_text(const Remark& doubt) {
    return fmt::format(
        "The angular velocities of {} differ by a factor of {:.3g}, the factor between {}, from "
        "those of {} at the same steps; check the unit in the headers.",
        names_of(doubt.files), doubt.size,
        doubt.size > 2 * std::numbers::pi + 1 ? "1/min (rpm) and rad/s" : "turn/s and rad/s",
        names_of(doubt.names));
}

std::string far_files_text(const Remark& doubt) {
    const bool one = doubt.names.size() == 1;
    return fmt::format(
        "In {}, {} {} at all conditions, by {:.3g} %, while steps within a file agree; check the "
        "units, the zeros and calibrations of the sensors, the total bead mass and the filling. "
        "Until then, the fit takes larger errors for {}.",
        words_for_quantity(doubt.quantity), fmt::join(doubt.names, ", "),
        one ? "differs from its replicates" : "differ from one another", 100 * doubt.relative,
        one ? "this file" : "these files");
}

std::string doubt_text(const Remark& doubt) {
    switch (doubt.kind) {
        case Kind::repaired_torques:
            return fmt::format(
                "{}: in {} of {} rows the torque differs from the shear stress by a power of ten; "
                "repaired from the shear stress, as repair = true asks for: lines {}.",
                doubt.file(), doubt.count, doubt.of,
                text_of_lines(doubt.because.front().lines, 20));
        case Kind::restated_copy:
            return fmt::format(
                "{}: these are the measurements of {}, but the study states another "
                "liquid_content or bead mass for them; remove the wrong one.",
                doubt.file(), doubt.names[0]);
        case Kind::wrong_factor:
            return fmt::format("{}: {}.", doubt.file(), factor_text(doubt));
        case Kind::contradicting_rows:
            return contradicting_rows_text(doubt);
        case Kind::constant_torque:
        case Kind::constant_gap:
            return fmt::format("{}: {}.", doubt.file(), constant_text(doubt));
        case Kind::impossible_filling:
            return fmt::format("{}: {}.", doubt.file(), impossible_text(doubt));
        case Kind::impossible_value:
            return impossible_sentence(doubt);
        case Kind::saturated_column:
            return sentences(doubt.because).front();
        case Kind::other_speed_unit:
            return speed_unit_text(doubt);
        case Kind::far_files:
            return far_files_text(doubt);
        default:
            return fmt::format(
                "The replicates {} differ in {} far beyond the scatter of the others; look for a "
                "disturbance in these steps. The fit takes larger errors for these readings.",
                fmt::join(doubt.names, " and "), words_for_quantity(doubt.quantity));
    }
}

// Rows, steps and readings that are left out.

std::string limit_text(const Remark& rows) {
    return rows.quantity == "torque"
               ? fmt::format("torque stands at its largest value, {:.4g} mN m", 1e3 * rows.limit)
               : fmt::format("normal force stands at its largest value, {:.4g} N", rows.limit);
}

const char* likely_cause(Kind kind) {
    switch (kind) {
        case Kind::unloading:
            return "unloading";
        case Kind::loading:
            return "loading";
        case Kind::consolidation:
            return "consolidation, since the gap shrinks";
        case Kind::shear_to_failure:
            return "shear to failure, since the torque peaks and drops";
        case Kind::stopped_shear:
            return "shear that was stopped while the torque rose";
        default:
            return "preshear, since the torque levels off";
    }
}

std::string strain_text(const char* what, const Remark& step) {
    return fmt::format(
        "{} covers a strain of {:.2g}, steady shear takes {:g} (least_strain in [import]); it "
        "looks like {}, unless the angular velocity is in another unit",
        what, step.size, step.limit, likely_cause(step.because.front().kind));
}

std::string step_text(const Remark& step) {
    switch (step.kind) {
        case Kind::few_rows:
            return fmt::format("has {} rows, {} are needed", step.count, shortest_step);
        case Kind::speed_ramp:
            return fmt::format(
                "the speed of the lid changes {} within the step, from {:.3g} to {:.3g} rad/s: no "
                "steady shear; export steps of constant speed",
                SpeedRamp{step.size, step.size_to}.change(), step.size, step.size_to);
        case Kind::back_and_forth:
            return "the lid turns back and forth: no steady shear";
        case Kind::at_rest:
            return "the lid does not turn: rest or consolidation";
        case Kind::short_strain:
            return strain_text("it", step);
        case Kind::short_steady_strain:
            return strain_text("its steady part", step);
        case Kind::never_steady:
            return fmt::format("never steady: {} at the end of the step",
                               step.quantity == "height"   ? "the gap still changes"
                               : step.quantity == "torque" ? "the torque still changes"
                                                           : "torque and gap still change");
        case Kind::few_steady_rows:
            return fmt::format("{} rows are steady, {} are needed", step.count, shortest_step);
        case Kind::tension:
            return fmt::format(
                "the mean normal force is {:.3g} N, no compression; compression must be positive: "
                "reverse the sign of the column of the normal force if compression was recorded as "
                "negative",
                step.size);
        case Kind::no_torque:
            return "the mean torque is zero within twice its standard error";
        case Kind::transient:
            return fmt::format("transient of {:.3g} s, until torque and gap are steady", step.size);
        default:
            return "part of a turn of the lid, whose wobble would bias the mean";
    }
}

std::string impossible_reading_text(const Remark& reading) {
    std::vector<std::string> reasons;
    for (const Remark& each : reading.because)
        reasons.push_back(impossible_text(each));
    return fmt::format("set aside: {}", fmt::join(reasons, "; "));
}

std::string rows_text(const Remark& rows) {
    switch (rows.kind) {
        case Kind::after_interval:
            return "after the end of an interval";
        case Kind::without_point_number:
            return "without a point number";
        case Kind::cut_short:
            return "cut short: it has fewer cells than the row before";
        case Kind::without_segment:
            return "without segment and point, as 2|15";
        case Kind::marked_invalid:
            return "marked as invalid by the instrument";
        case Kind::without_values:
            return "without values";
        case Kind::no_value:
            return fmt::format("{}: no value of {}", rows.names[0], rows.quantity);
        case Kind::stated_role:
            return fmt::format("{}: {}, as stated", rows.names[0], rows.names[1]);
        case Kind::lacks_column:
            return rows.names[0] + ": lacks a column that steady shear needs";
        case Kind::copied_rows:
            return fmt::format("repeats {}, lines {} to {}; the same measurement counts once",
                               rows.files[1], rows.lines[1].first, rows.lines[1].last);
        case Kind::contradicting_row:
            return "set aside: the columns of a row contradict each other";
        case Kind::saturated_row:
            return "saturated: the " + limit_text(rows);
        case Kind::spike:
            return "spike: torque, force or gap is far off the rows around it";
        case Kind::repeated_reading:
            return fmt::format(
                "repeats {}; the same measurement counts once",
                to_string(Position{rows.files[rows.lines[1].file], rows.lines[1].first, 0}));
        case Kind::reading_of_wrong_column: {
            const Remark& doubt = rows.because.front();
            return "set aside: " +
                   (doubt.kind == Kind::wrong_factor ? factor_text(doubt) : constant_text(doubt));
        }
        case Kind::contradicted_reading:
            return fmt::format(
                "set aside: step {}: its columns contradict each other in {} of {} "
                "rows",
                rows.step, rows.count, rows.of);
        case Kind::saturated_reading:
            return fmt::format("set aside: step {}: saturated: in {} of {} rows the {}", rows.step,
                               rows.count, rows.of, limit_text(rows));
        case Kind::impossible_reading:
            return impossible_reading_text(rows);
        default:
            return step_text(rows);
    }
}

/// Reason with the number of the step, for rows of a step.
std::string rows_text_with_step(const Remark& rows) {
    const std::string reason = rows_text(rows);
    return on_step(rows.kind) ? fmt::format("step {}: {}", rows.step, reason) : reason;
}

// Notes.

std::string of_steps(const Remark& note, const std::string& what) {
    return fmt::format("{}: step {}: {}", note.file(), fmt::join(note.names, ", "), what);
}

std::string merging_text(const Remark& note) {
    return fmt::format(
        "{} {} a liquid content above 0.063, up to {:.3g}{}: the bridges between three touching "
        "beads merge from there on, and the model of separate bridges is no longer exact",
        note.count, note.count == 1 ? "reading has" : "readings have", note.size,
        note.relative > 0
            ? fmt::format(" (liquid fills {:.2g} % of the pores)", 100 * note.relative)
            : "");
}

std::string few_beads_text(const Remark& note) {
    std::vector<std::string> sides;
    for (const Remark& side : note.because)
        sides.push_back(fmt::format("the {} of the sample, {:.3g} mm, is {:.2g} bead diameters",
                                    side.quantity, 1e3 * side.size, side.relative));
    return fmt::format(
        "{}: below ten, the walls order the beads, and the model, a flow without walls, may not "
        "hold",
        fmt::join(sides, "; "));
}

std::string weight_text(const Remark& note) {
    const std::string from = fmt::format("{:.4g}", note.limit),
                      to = fmt::format("{:.4g}", note.size_to);
    return fmt::format(
        "The model neglects the weight of the beads, which raises the normal stress at the base by "
        "up to {:.0f} Pa. The increase exceeds 10 % of the applied normal stress in {} of {} "
        "readings, those at {} Pa. 'pendular diagnose' tests the effect grain-weight.",
        note.size, note.count, note.of, from == to ? from : from + " to " + to);
}

std::string lost_recordings_text(const Remark& note) {
    std::vector<std::string> lost;
    for (const Remark& each : note.because)
        lost.push_back(
            fmt::format("{} ({})", file_name_of(each.file()), rows_text_with_step(each)));
    const std::size_t more = note.count - lost.size();
    return fmt::format("No step gave a reading in {}{}.", fmt::join(lost, ", "),
                       more > 0 ? fmt::format(" and in {} more recordings", more) : "");
}

std::string note_on_file(const Remark& note) {
    switch (note.kind) {
        case Kind::averaged_rows:
            return fmt::format(
                "{} has more than {} rows: each {} consecutive rows count as one, with their mean. "
                "Spikes and saturation within such a group are not seen.",
                file_name_of(note.file()), note.of, note.count);
        case Kind::rate_at_other_radius:
            return fmt::format("{}: {}; the rate at the mean radius is used", note.file(),
                               factor_text(note));
        case Kind::copied_file:
            return fmt::format(
                "{} and {} hold the same measurement, {} of {} rows: it counts once, as {}",
                note.files[0], note.files[1], note.count, note.of, note.files[0]);
        case Kind::steps_with_spikes:
            return of_steps(note,
                            "single rows jump far off their neighbours and back; they were left "
                            "out (listed in excluded.csv). Look for a disturbance, or a wrong "
                            "column");
        case Kind::flipped_torques:
            return of_steps(note, "the torque was negative; its sign was flipped");
        case Kind::interpolated_steps:
            return of_steps(note,
                            "samples are unevenly spaced in time; interpolated to even spacing");
        case Kind::coarse_steps:
            return of_steps(
                note, fmt::format("torque or gap hardly changes from row to row: their standard "
                                  "errors are set to their resolution, {:.3g} mN m and {:.3g} mm",
                                  1e3 * note.size, 1e3 * note.size_to));
        case Kind::unused_columns:
            return fmt::format("{}: columns not used: '{}'", note.file(),
                               fmt::join(note.names, "', '"));
        case Kind::copied_readings:
            return note.files.size() == 1
                       ? fmt::format(
                             "{}: readings that repeat an earlier one in all digits: {}; "
                             "each counts once",
                             note.file(), note.count)
                       : fmt::format(
                             "{} and {} hold the same readings, {} of them: they count "
                             "once, as {}",
                             note.files[0], note.files[1], note.count, note.files[0]);
        case Kind::pattern_without_file:
            return fmt::format(
                "No file matches \"{}\" (line {} of study.toml): nothing is read "
                "for this entry.",
                note.names[0], note.first_line());
        case Kind::recordings_without_reading:
            return lost_recordings_text(note);
        case Kind::ends_early:
            return fmt::format(
                "{} ends after step {}, {} goes on to step {} from the same beginning. If the "
                "measurement was not stopped there, the file was cut off: export it again.",
                file_name_of(note.files[0]), note.step, file_name_of(note.files[1]), note.count);
        default:
            return fmt::format(
                "{} gives no reading at step {} ({}), but {} does. If the recording ends too "
                "early, the file was cut off: export it again.",
                file_name_of(note.files[0]), note.step, reason_of(note.because.front()),
                file_name_of(note.files[1]));
    }
}

std::string note_on_readings(const Remark& note) {
    switch (note.kind) {
        case Kind::unlike_files:
            return fmt::format(
                "In {}, {} differ by {:.2g} % at all conditions, while steps within a file scatter "
                "by {:.2g} %. This difference is large for fillings: check the liquid content, "
                "units and bead mass of each file. It counts as the error of a filling.",
                words_for_quantity(note.quantity), fmt::join(note.names, ", "), 100 * note.relative,
                100 * note.relative_error);
        case Kind::errors_below_rounding:
            return fmt::format(
                "The standard errors given for {} of {} readings are smaller than the rounding of "
                "their values; the error of rounding was added. Write more digits, or check the "
                "errors' units.",
                note.count, note.of);
        case Kind::few_replicates:
            return fmt::format(
                "The scatter between replicates is known from {} only: standard errors are widened "
                "{:.1f} times, so that an interval of two standard errors covers 95 %. More "
                "replicates make them smaller.",
                note.size == 1 ? "one pair" : fmt::format("{:.0f} differences", note.size),
                note.relative);
        case Kind::assumed_errors:
            return fmt::format(
                "{} of {} readings have no replicates, or no error at all: 2 % of the value is "
                "assumed. Repeat the measurement with another filling, or state the scatter of the "
                "instrument in [scatter] of the study.",
                note.count, note.of);
        case Kind::merging_bridges:
            return merging_text(note);
        case Kind::few_beads:
            return few_beads_text(note);
        case Kind::points_of_failure:
            return fmt::format(
                "{} of {} readings are points of failure: peaks of the shear stress of a "
                "consolidated bed, not steady shear. The model describes steady shear; the effect "
                "peak-strength is the factor between the two.",
                note.count, note.of);
        case Kind::outside_files:
            return fmt::format(
                "{} of the files that were read are outside of the study's folder, "
                "as its 'allow_outside' permits",
                note.count);
        default:
            return weight_text(note);
    }
}

/// Why a step gave no reading, without what is particular to one step, and advice.
struct Cause {
    std::string what, advice;
};

/// Cause for messages on many steps: `what` is a clause such as "the normal force is negative", to
/// be followed by "in all 30 steps"; empty for a remark that is not on a whole step.
Cause cause_without_reading(const Remark& step) {
    switch (step.kind) {
        case Kind::few_rows:
            return {fmt::format("less than {} rows were recorded", shortest_step), ""};
        case Kind::speed_ramp:
            return {"the speed of the lid changes",
                    "no steady shear: export steps of constant speed"};
        case Kind::back_and_forth:
            return {"the lid turns back and forth", "export steps of constant speed"};
        case Kind::at_rest:
            return {"the lid does not turn",
                    "check the column of the angular velocity, and its unit"};
        case Kind::short_strain:
        case Kind::short_steady_strain:
            return {"the strain is too small for steady shear",
                    fmt::format("steady shear takes a strain of {:g} (least_strain in [import]): "
                                "check the unit of the angular velocity, or record longer",
                                step.limit)};
        case Kind::never_steady:
            return {"torque or gap still change at the end", "record longer"};
        case Kind::few_steady_rows:
            return {fmt::format("less than {} rows are steady", shortest_step), "record longer"};
        case Kind::tension:
            return {"the normal force is negative",
                    "compression must be positive: reverse the sign of the column of the normal "
                    "force in the recordings"};
        case Kind::no_torque:
            return {"the torque is zero within its error",
                    "check that the torque was recorded, and its unit"};
        default:
            return {};
    }
}

/// Number of rows of recordings that a doubt set aside, whether or not they made readings.
std::size_t doubted(const Measurements& measurements) {
    std::set<std::pair<std::string, int>> rows;
    for (const Remark& doubt : measurements.with(Remark::Outcome::set_aside))
        for (const Lines& lines : doubt.lines)
            rows.emplace(doubt.files[lines.file], lines.first);
    return rows.size();
}

}  // namespace

std::string reason_of(const Remark& remark) {
    return rows_text(remark);
}

std::string text_of(const Remark& remark) {
    if (remark.kind < Kind::repaired_torques) return fault_text(remark);
    if (remark.kind < Kind::after_interval) return doubt_text(remark);
    if (remark.kind < Kind::averaged_rows) return rows_text_with_step(remark);
    return remark.kind < Kind::unlike_files ? note_on_file(remark) : note_on_readings(remark);
}

std::optional<std::string> pendular_range_warning(double content) {
    const int beyond = beyond_pendular_range(content);
    if (beyond == 0) return std::nullopt;
    return beyond > 0
               ? fmt::format(
                     "liquid content {:g} is above the pendular range, which ends at about {:g}: "
                     "bridges of touching beads merge there, and the model of separate bridges "
                     "no longer holds",
                     content, wettest_pendular)
               : fmt::format(
                     "liquid content {:g} is below the pendular range, which begins at about {:g}: "
                     "the liquid may stay between the asperities of the bead surfaces instead of "
                     "forming bridges",
                     content, driest_pendular);
}

std::size_t readings_set_aside(const Measurements& measurements) {
    const auto excluded = std::ranges::count_if(
        measurements.remarks, [](const Remark& remark) { return on_reading(remark.kind); });
    return std::max(static_cast<std::size_t>(excluded), doubted(measurements));
}

bool mostly_set_aside(const Measurements& measurements) {
    return readings_set_aside(measurements) > measurements.readings.size() ||
           (measurements.readings.empty() && !measurements.with(Remark::Outcome::left_out).empty());
}

std::optional<std::string> common_reason(const Measurements& measurements) {
    if (!mostly_set_aside(measurements)) return std::nullopt;
    struct Steps {
        std::size_t count = 0;
        const Remark* first = nullptr;
    };
    std::map<std::string, Steps> causes;
    std::size_t steps = 0;
    for (const Remark& each : measurements.remarks) {
        const Cause cause = cause_without_reading(each);
        if (cause.what.empty()) continue;
        ++steps;
        Steps& alike = causes[cause.what];
        if (alike.count++ == 0) alike.first = &each;
    }
    if (steps == 0) return std::nullopt;
    const Steps& most = std::ranges::max_element(causes, {}, [](const auto& cause) {
                            return cause.second.count;
                        })->second;
    if (doubted(measurements) >= most.count) return std::nullopt;  // the doubts say why
    if (steps == 1) return with_capital(text_of(*most.first)) + ".";
    const char* const which =
        measurements.readings.empty() ? "steps" : "steps that gave no reading";
    const std::string where = most.count == steps
                                  ? fmt::format("all {} {}", steps, which)
                                  : fmt::format("{} of {} {}", most.count, steps, which);
    const auto [what, advice] = cause_without_reading(*most.first);
    return fmt::format("{} in {}{}{}.", with_capital(what), where, advice.empty() ? "" : "; ",
                       advice);
}

std::string why_no_reading(const Measurements& measurements) {
    if (const auto doubts = measurements.with(Remark::Outcome::set_aside); !doubts.empty())
        return "Readings were set aside; the reason for the first: " + text_of(doubts.front());
    if (const auto reason = common_reason(measurements)) return *reason;
    const auto left_out = measurements.with(Remark::Outcome::left_out);
    return left_out.empty()
               ? "Give recordings or readings."
               : "All rows were left out; the reason for the first: " + text_of(left_out.front()) +
                     ".";
}

}  // namespace pendular
