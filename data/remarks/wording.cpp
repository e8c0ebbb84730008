#include "data/remarks/wording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

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

/// Number with two significant digits, or as many as tell it from a limit.
std::string apart_from(double number, double limit) {
    const std::string other = fmt::format("{:g}", limit);
    std::string text;
    for (int digits = 2; digits <= 6; ++digits)
        if (text = fmt::format("{:.{}g}", number, digits); text != other) break;
    return text;
}

std::string strain_text(const char* what, const Remark& step) {
    return fmt::format(
        "{} covers a strain of {}, steady shear takes {:g} (least_strain in [import]); it "
        "looks like {}, unless the angular velocity is in another unit",
        what, apart_from(step.size, step.limit), step.limit,
        likely_cause(step.because.front().kind));
}

std::string step_text(const Remark& step) {
    switch (step.kind) {
        case Kind::few_rows:
            return fmt::format("has {} rows, {} are needed", step.count, shortest_step);
        case Kind::speed_ramp:
            return fmt::format(
                "the speed of the lid changes {} within the step, from {:.3g} to {:.3g} rad/s, and "
                "none "
                "lasts {} rows: no steady shear; export steps of constant speed, of more rows",
                SpeedRamp{step.size, step.size_to}.change(), step.size, step.size_to,
                shortest_step);
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
        case Kind::part_of_turn:
            return "part of a turn of the lid, whose wobble would bias the mean";
        default:
            throw std::logic_error("a part of a step has no words");
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
            return "after the end of an interval, or no row of the table but a title, a mean or "
                   "the like";
        case Kind::without_point_number:
            return "without a point number";
        case Kind::cut_short:
            return "cut short: the file ends within it, or it has fewer cells than the row before";
        case Kind::without_segment:
            return "without segment and point, as 2|15";
        case Kind::marked_invalid:
            return "marked as invalid in the file";
        case Kind::without_values:
            return "without values";
        case Kind::no_value:
            return fmt::format("{}: no value of {}", rows.names[0], rows.quantity);
        case Kind::stated_role:
            return fmt::format("{}: {}, as stated", rows.names[0], rows.names[1]);
        case Kind::other_test:
            return fmt::format("{}: {}", rows.names[0], rows.names[1]);
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
            return "spike: torque, force, gap or speed is far off the rows around it";
        case Kind::repeated_reading:
            return fmt::format(
                "{} {}; the same measurement counts once",
                rows.relative > 0 ? "is a copy with noise of" : "repeats",
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

/// Factor by which repeated readings scatter more than their stated errors, above which their
/// conditions may differ. Chosen: fillings that repeat each other scatter two or three times as
/// much as one of them fluctuates.
constexpr double far_above_errors = 4;

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

/// Sentence on the friction from which side walls gather the shear, where none is stated.
std::string walls_that_gather_shear(double most_for_even_shear) {
    const std::string which =
        most_for_even_shear > 0
            ? fmt::format("walls of a friction above {:.2g} gather", most_for_even_shear)
            : std::string("the weight of the beads and walls of any friction gather");
    return which +
           " the shear in a layer under the lid, at one reading at least, which raises the torque: "
           "state wall_friction in [cell], and import computes the layer";
}

std::string few_beads_text(const Remark& note) {
    std::vector<std::string> sides;
    for (const Remark& side : note.because)
        sides.push_back(fmt::format("the {} of the sample, {:.3g} mm, is {:.2g} bead diameters",
                                    side.quantity, 1e3 * side.size, side.relative));
    std::vector<std::string> said;
    if (!sides.empty())
        said.push_back(fmt::format(
            "{}: below ten, the walls order the beads, and the model, a flow without walls, may "
            "not hold",
            fmt::join(sides, "; ")));
    if (note.relative > 0)
        said.push_back(fmt::format(
            "the side walls are {:.2g} bead diameters apart: beads beside a flat wall lie in "
            "layers that shear easily, so that the torque is about {:.1f} % smaller than in the "
            "model (half as much where sizes differ or beads resist rolling), and the fitted "
            "friction too small; the effect wall-layers describes this",
            note.size, 100 * note.relative));
    if (note.relative > 0 && std::isfinite(note.limit))
        said.push_back(walls_that_gather_shear(note.limit));
    return fmt::format("{}", fmt::join(said, ". Also, "));
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

std::string near_copy_text(const Remark& note) {
    return fmt::format(
        "{} and {} agree within {:.2g} % in the stress ratio at {} steps, better than independent "
        "recordings can (p = {:.1g}): they count once, as {}. If {} is a measurement of its own, "
        "set "
        "keep_implausible = true in [import] of study.toml.",
        note.files[0], note.files[1], 100 * note.relative, note.count, note.p, note.files[0],
        file_name_of(note.files[1]));
}

}  // namespace

std::string unread_sheets_text(const std::string& file, const std::vector<std::string>& sheets) {
    return fmt::format("{}: {} not read: '{}'.", file_name_of(file),
                       sheets.size() == 1 ? "a sheet is" : "sheets are", fmt::join(sheets, "', '"));
}

namespace {

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
        case Kind::sd_read_as_standard_error:
            return fmt::format(
                "{}: '{}' {} of the mean. Beside a column NAME_n, NAME_sd is the standard "
                "deviation "
                "of n single values; NAME_u95 is half of a 95 % interval.",
                note.file(), fmt::join(note.names, "', '"),
                note.names.size() == 1 ? "is read as a standard error"
                                       : "are read as standard errors");
        case Kind::quasi_static_table:
            return fmt::format(
                "{}: all inertial numbers are {}, which counts as the quasi-static limit. If the "
                "grains flowed faster, check the column '{}' and its unit.",
                note.file(), note.size > 0 ? fmt::format("at most {:.2g}", note.size) : "0",
                note.names.front());
        case Kind::copied_readings:
            if (note.relative > 0) return near_copy_text(note);
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
        case Kind::unread_sheets:
            return unread_sheets_text(note.file(), note.names);
        case Kind::recordings_without_reading:
            return lost_recordings_text(note);
        case Kind::ends_early:
            if (note.files.size() == 1)
                return fmt::format(
                    "{} ends within line {}, which is left out. If the file was cut off, export it "
                    "again.",
                    file_name_of(note.file()), note.first_line());
            return fmt::format(
                "{} ends after step {}, {} goes on to step {} from the same beginning. If the "
                "measurement was not stopped there, the file was cut off: export it again.",
                file_name_of(note.files[0]), note.step, file_name_of(note.files[1]), note.count);
        case Kind::lacks_step:
            return fmt::format(
                "{} gives no reading at step {} ({}), but {} does. If the recording ends too "
                "early, the file was cut off: export it again.",
                file_name_of(note.files[0]), note.step, reason_of(note.because.front()),
                file_name_of(note.files[1]));
        default:
            throw std::logic_error("a note on a file has no words");
    }
}

/// Sentences on stated errors that are too large for the scatter of repeated readings.
std::string above_scatter_text(const Remark& note) {
    return fmt::format(
        "The standard errors given for {} are {} times as large as the scatter of repeated "
        "readings "
        "(p = {:.2g}). If they are standard deviations of n single values, add a column NAME_n; if "
        "half of a 95 % interval, call the column NAME_u95. Leave the column out to take the "
        "errors "
        "from the scatter.",
        words_for_quantity(note.quantity), factor_above_scatter(note), note.p);
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
        case Kind::errors_below_scatter:
            return fmt::format(
                "Repeated readings scatter {:.2g} times as much as the standard errors given for "
                "{} allow (p = {:.2g}): the scatter is used in their place.{}",
                note.relative, words_for_quantity(note.quantity), note.p,
                note.relative < far_above_errors || note.quantity == "solid_fraction"
                    ? ""
                    : " Check that readings which are stated at one condition were taken at one "
                      "speed, load and liquid content.");
        case Kind::errors_above_scatter:
            return above_scatter_text(note);
        case Kind::few_replicates:
            return fmt::format(
                "The scatter between replicates is known from {} only: standard errors are widened "
                "{:.1f} times, so that an interval of two standard errors covers 95 %. More "
                "replicates make them smaller.",
                note.size == 1 ? "one pair" : fmt::format("{:.0f} differences", note.size),
                note.relative);
        case Kind::assumed_errors:
            return fmt::format(
                "{} of {} readings have {}: 2 % of the value is assumed. Repeat the measurement "
                "with "
                "another filling, or state the scatter of the instrument in [scatter] of the "
                "study.",
                note.count, note.of,
                note.quantity.empty()
                    ? "no replicates, or no error at all"
                    : "neither replicates nor an error of " + words_for_quantity(note.quantity));
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
        case Kind::grain_weight:
            return weight_text(note);
        default:
            throw std::logic_error("a note on readings has no words");
    }
}

}  // namespace

std::string factor_above_scatter(const Remark& note) {
    constexpr double largest =
        1000;  // beyond, the scatter is that of a copy, and no number says more
    return note.relative * largest > 1 ? fmt::format("{:.2g}", 1 / note.relative)
                                       : fmt::format("more than {}", largest);
}

std::string reason_of(const Remark& remark) {
    return rows_text(remark);
}

std::string text_of(const Remark& remark) {
    if (remark.kind < Kind::repaired_torques) return fault_text(remark);
    if (remark.kind < Kind::after_interval) return doubt_text(remark);
    if (remark.kind < Kind::averaged_rows) return rows_text_with_step(remark);
    return remark.kind < Kind::unlike_files ? note_on_file(remark) : note_on_readings(remark);
}

}  // namespace pendular
