#include "data/remarks/wording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "data/quantities/units.h"
#include "data/reading.h"
#include "data/recordings/plausibility.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Words for the column that was measured, where the instrument computed another from it.
const char* measured_for(const std::string& computed) {
    return computed == "shear_stress"    ? "torque"
           : computed == "normal_stress" ? "normal force"
                                         : "angular velocity";
}

/// Words for a quantity of a reading that has a range of possible values; `numerator` and
/// `denominator` are the measured quantities with which it increases and decreases.
struct ValueWords {
    const char *quantity, *why_not_less, *why_not_more, *check, *numerator, *denominator;
};

constexpr std::array value_words = {
    ValueWords{"solid_fraction", "too low for grains in contact in steady shear",
               "the densest packing of equal spheres",
               "the zero and the unit of the gap height, the total bead mass and the density",
               "total bead mass", "gap or density"},
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
std::string usual_by_power_of_ten(const Remark& doubt, const ValueWords& words) {
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
                       words.check, usual_by_power_of_ten(doubt, words));
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

/// Text with two units: "the factor between rad/s and rpm".
std::string between(const UnitMixUp& units) {
    return fmt::format("the factor between {} and {}", units.unit, units.taken_for);
}

/// Likely cause of a constant factor between a stated and a computed column.
std::string cause_of(const Remark& doubt) {
    constexpr double mix_up_tolerance = 0.02;  // as in contradictions.cpp
    const auto is = [&](double other) {
        return std::abs(doubt.size / other - 1) < mix_up_tolerance;
    };
    if (doubt.quantity == "shear_stress" && (is(2) || is(0.5)))
        return "the printed torque formula gives twice the derived one: see torque_formula in "
               "[cell]";
    if (const int power = power_of_ten(doubt.size, mix_up_tolerance).value_or(0))
        return fmt::format(
            "a factor of 10^{}: check the units of both columns{}", power,
            doubt.quantity == "shear_stress"
                ? "; if only some torques lost a mark, repair = true in [[recording]] takes them "
                  "from the shear stress"
                : "");
    const UnitMixUp* const speeds = find_mix_up("angular_velocity", doubt.size, mix_up_tolerance);
    if (doubt.quantity == "shear_rate" && speeds)
        return fmt::format("{}: check the units of both columns", between(*speeds));
    return "check inner_radius and outer_radius in [cell]: the instrument used others, or another "
           "formula";
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
        "The angular velocities of {} differ by a factor of {:.3g}, {}, from those of {} at the "
        "same steps; check the unit in the headers.",
        names_of(doubt.files), doubt.size, between(*find_mix_up(doubt.quantity, doubt.size, 1e-9)),
        names_of(doubt.names));
}

/// Sentence on the pair of files that may have each other's liquid content, after a blank; empty
/// where there is none.
std::string exchanged_text(const Remark& doubt) {
    if (doubt.because.empty()) return "";
    return fmt::format(
        " {}, which study.toml states as dry, agrees with the wet files, and {}, stated as wet, "
        "with the dry ones: check whether their liquid contents are exchanged.",
        doubt.because.front().names[0], doubt.because.front().names[1]);
}

std::string far_files_text(const Remark& doubt) {
    const bool one = doubt.names.size() == 1;
    return fmt::format(
        "In {}, {} {} at all conditions, by {:.3g} %, while steps within a file agree; check the "
        "units, the zeros and calibrations of the sensors, the total bead mass and the filling.{} "
        "Until then, the fit takes larger errors for {}.",
        words_for_quantity(doubt.quantity), fmt::join(doubt.names, ", "),
        one ? "differs from its replicates" : "differ from one another", 100 * doubt.relative,
        exchanged_text(doubt), one ? "this file" : "these files");
}

std::string creeping_text(const Remark& doubt) {
    const std::string from = fmt::format("{:.2g}", 100 * doubt.size),
                      to = fmt::format("{:.2g}", 100 * doubt.size_to);
    const char* const cause =
        doubt.size_to < 0
            ? "A gap falls where a part of the bed is not sheared and still settles, or where "
              "beads or liquid are lost or beads wear. Shear gathers under the lid where side "
              "walls drag on the bed or where it is heavy: fill the cell lower, use smoother "
              "walls or shear longer, and look for beads outside the cell."
            : "Check the gap sensor for drift and, where the gap rises, the cell for beads "
              "between lid and wall.";
    return fmt::format(
        "In {} of {} readings, first in {}, the gap still changes, by {} % per unit "
        "of strain, while the torque is steady. The torque is used; the solid fraction of these "
        "readings counts as unknown. {}",
        doubt.count, doubt.of, to_string(Position{doubt.file(), doubt.first_line(), 0}),
        from == to ? from : from + " to " + to, cause);
}

std::string uneven_text(const Remark& doubt) {
    return fmt::format(
        "In {} of {} dry readings, first in {}, {} the shear under the lid, down to a layer of "
        "{:.2g} mm of a bed of {:.2g} mm. This raises the stress ratio at the lid, there by about "
        "{:.0f} %, and the solid fraction is in part that of beads at rest. {}",
        doubt.count, doubt.of, to_string(Position{doubt.file(), doubt.first_line(), 0}),
        doubt.of_weight ? "the weight of the beads gathers"
                        : "side walls of the stated friction and the weight of the beads gather",
        1e3 * doubt.size, 1e3 * doubt.size_to, 100 * doubt.relative,
        doubt.of_weight ? "No effect describes this: fill the cell lower, or raise the load."
                        : "The effect shear-localisation describes the torque; a lower filling "
                          "avoids it.");
}

}  // namespace

std::string impossible_text(const Remark& doubt) {
    return fmt::format("the {} {:.3g} is {}", words_for_quantity(doubt.quantity), doubt.size,
                       limit_and_check(doubt));
}

std::string factor_text(const Remark& doubt) {
    return fmt::format(
        "the column of the {} is {:.4g} times what the {} gives with the study's cell (median of "
        "{} rows, {:.0f} % of them agree); {}",
        words_for_quantity(doubt.quantity), doubt.size, measured_for(doubt.quantity), doubt.of,
        100 - 100.0 * static_cast<double>(doubt.count) / static_cast<double>(doubt.of),
        cause_of(doubt));
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
        case Kind::far_condition:
            return fmt::format(
                "The replicates {} differ in {} far beyond the scatter of the others; look for a "
                "disturbance in these steps. The fit takes larger errors for these readings.",
                fmt::join(doubt.names, " and "), words_for_quantity(doubt.quantity));
        case Kind::creeping_gap:
            return creeping_text(doubt);
        case Kind::uneven_shear:
            return uneven_text(doubt);
        default:
            throw std::logic_error("a doubt has no words");
    }
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

}  // namespace pendular
