#include "data/recordings/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "data/grains.h"
#include "data/recordings/robust.h"

namespace pendular {

Excluded left_out(const Reading& reading, std::string reason) {
    return {reading.origin, std::max(reading.last_line, reading.origin.line), std::move(reason),
            Excluded::Kind::reading};
}

double greatest_stress_ratio(double reduced_pressure) {
    return 1.5 * (1 + 1 / reduced_pressure);
}

namespace {

/// Impossible value in a reading, with the limit that it violates.
struct Impossible {
    std::string_view quantity;  ///< name of the quantity, "solid_fraction"
    std::string words;          ///< words for the quantity, "solid fraction"
    double value = 0;
    bool below = false;  ///< whether the value is below the lower limit; else above the upper limit
    std::string limit;   ///< "above 0.74, the densest packing of equal spheres"
    std::string check;  ///< advice what to check, with a factor of ten that would explain the value
};

/// Value of a quantity with the range of possible values. `numerator` and `denominator` are words
/// for the measured quantities with which the value increases and decreases.
struct PlausibleRange {
    std::string_view quantity;
    std::string words;
    double value;
    double least, greatest;
    std::string why_not_less, why_not_more;
    std::string check;
    std::string numerator, denominator;
    /// Range of the quantity in most flows; a power of ten that leads into this range is reported.
    double usual_least, usual_greatest;
};

/// Text with the power of ten that leads to a usual value: "a bead mass 10 times smaller or a gap
/// 10 times larger would give 0.6"; empty if no power of ten does.
std::string power_of_ten(const PlausibleRange& range) {
    for (int power = 1; power <= 9; ++power) {
        for (const int sign : {-1, 1}) {
            const double mended = range.value * std::pow(10, sign * power);
            if (mended < range.usual_least || mended > range.usual_greatest) continue;
            const auto change = [&](const std::string& what, bool larger) {
                return fmt::format("a {} {:.0f} times {}", what, std::pow(10, power),
                                   larger ? "larger" : "smaller");
            };
            const std::string other =
                range.denominator.empty() ? "" : " or " + change(range.denominator, sign < 0);
            return fmt::format(" ({}{} would give {:.2g})", change(range.numerator, sign > 0),
                               other, mended);
        }
    }
    return "";
}

void check_range(const PlausibleRange& range, std::vector<Impossible>& found) {
    if (range.value >= range.least && range.value <= range.greatest) return;
    const bool below = range.value < range.least;
    found.push_back({range.quantity, range.words, range.value, below,
                     fmt::format("{} {:.3g}, {}", below ? "below" : "above",
                                 below ? range.least : range.greatest,
                                 below ? range.why_not_less : range.why_not_more),
                     range.check + power_of_ten(range)});
}

void check_content_range(double content, std::vector<Impossible>& found) {
    const auto warning = pendular_range_warning(content);
    if (!warning) return;
    const bool percent = !pendular_range_warning(content / 100) && content >= 0.1;
    found.push_back(
        {"liquid_content", "liquid content", content, content < 0.02,
         warning->substr(warning->find(" is ") + 4),
         percent
             ? fmt::format("liquid_content, the volume of liquid over that of beads: {:g} would "
                           "be right in percent, so write {:g} or \"{:g} %\"",
                           content, content / 100, content)
             : "liquid_content, the volume of liquid over that of beads"});
}

/// Reduced pressure P* [1] of a wet reading; infinite for a dry reading.
double pressure_of(const Reading& reading, const Study& study) {
    if (reading.condition.dry() || !study.liquid) return std::numeric_limits<double>::infinity();
    return reduced_pressure(reading.condition.normal_stress, study.grains, *study.liquid);
}

/// Smallest plausible reduced pressure [1], a fifth of the lowest simulated one, and largest
/// plausible inertial number [1], ten times the highest simulated one, here or by Badetti et al.
/// (2018).
constexpr double least_reduced_pressure = 0.1, greatest_inertial_number = 1;

PlausibleRange solid_fraction_range(double value) {
    return {"solid_fraction",
            "solid fraction",
            value,
            loosest_solid_fraction,
            densest_solid_fraction,
            "too low for grains in contact in steady shear",
            "the densest packing of equal spheres",
            "the zero and the unit of the gap height, the total bead mass and the density",
            "total bead mass",
            "gap",
            0.5,
            0.66};
}

std::vector<Impossible> impossible(const Reading& reading, const Study& study) {
    std::vector<Impossible> found;
    const double pressure = pressure_of(reading, study);
    check_range(solid_fraction_range(reading.value(1)), found);
    check_range(
        {"stress_ratio", "stress ratio", reading.stress_ratio(), least_stress_ratio,
         greatest_stress_ratio(pressure), "half of the stress ratio of frictionless grains",
         reading.condition.dry() ? "more than dry grains of any shape have"
                                 : "1.5 (1 + 1/P*), more than wet grains can have at this P*",
         "the torque, the normal force, their units and the radii of the cell", "torque",
         "normal force", 0.2, 0.7},
        found);
    check_range(
        {"inertial_number", "inertial number", reading.condition.inertial_number, 0,
         greatest_inertial_number, "",
         "above which grains collide rather than touch: no dense flow",
         "the angular velocity or shear rate (turns or radians, per second or minute), the bead "
         "diameter and the normal force",
         "speed", "", 1e-3, 3e-2},
        found);
    if (std::isfinite(pressure))
        check_range({"reduced_pressure", "reduced pressure", pressure, least_reduced_pressure,
                     std::numeric_limits<double>::infinity(),
                     "below which grains form lumps and no state was simulated", "",
                     "the normal force, the bead diameter and the surface tension", "normal force",
                     "surface tension", 1, 30},
                    found);
    check_content_range(reading.condition.liquid_content, found);
    return found;
}

std::string reason_of(const Impossible& each) {
    return fmt::format("the {} {:.3g} is {}; check {}", each.words, each.value, each.limit,
                       each.check);
}

/// Readings that violate the same limit, reported as one doubt.
struct ImpossibleGroup {
    Impossible first;
    double least, greatest;
    std::vector<Position> origins;
    std::set<std::string> files;
};

/// Position and number of the readings of a group: "dry_1.csv:12 (8 readings in 2 files)".
std::string where_doubted(const ImpossibleGroup& group) {
    const std::string first = to_string(group.origins.front());
    if (group.origins.size() == 1) return first;
    return fmt::format("{} ({} readings in {} file{})", first, group.origins.size(),
                       group.files.size(), group.files.size() > 1 ? "s" : "");
}

std::string doubt_sentence(const ImpossibleGroup& group) {
    const std::string least = fmt::format("{:.3g}", group.least),
                      greatest = fmt::format("{:.3g}", group.greatest);
    return fmt::format("{}: the {} {} is {}; check {}.", where_doubted(group), group.first.words,
                       least == greatest ? least : least + " to " + greatest, group.first.limit,
                       group.first.check);
}

void add_to_groups(Impossible each, const Reading& reading, std::vector<ImpossibleGroup>& groups) {
    auto group = std::ranges::find_if(groups, [&](const ImpossibleGroup& other) {
        return other.first.quantity == each.quantity && other.first.below == each.below;
    });
    const double value = each.value;
    if (group == groups.end())
        group = groups.insert(groups.end(), {std::move(each), value, value, {}, {}});
    group->least = std::min(group->least, value);
    group->greatest = std::max(group->greatest, value);
    group->origins.push_back(reading.origin);
    group->files.insert(reading.origin.file);
}

}  // namespace

void doubt_impossible_readings(Measurements& measurements, const Study& study) {
    std::vector<ImpossibleGroup> groups;
    std::vector<Reading> kept;
    for (const Reading& reading : measurements.readings) {
        std::vector<std::string> reasons;
        for (Impossible& each : impossible(reading, study)) {
            reasons.push_back(reason_of(each));
            add_to_groups(std::move(each), reading, groups);
        }
        if (reasons.empty() || study.import.keep_implausible)
            kept.push_back(reading);
        else
            measurements.excluded.push_back(
                left_out(reading, fmt::format("set aside: {}", fmt::join(reasons, "; "))));
    }
    measurements.readings = std::move(kept);
    for (const ImpossibleGroup& group : groups)
        measurements.doubts.push_back({doubt_sentence(group), std::string(group.first.quantity),
                                       group.origins, !study.import.keep_implausible});
}

namespace {

/// Column of a recording that has the same value in every row.
struct StuckColumn {
    std::string_view quantity;  ///< name of the quantity, "torque"
    std::string what;           ///< "the torque is 0.03 N m"
    std::string check;          ///< what the user should check
    bool usable;                ///< whether readings are kept although the column is constant
};

std::vector<StuckColumn> stuck_columns(const Recording& recording) {
    std::vector<StuckColumn> stuck;
    const bool torque = least_step(recording.torque) == 0, gap = least_step(recording.height) == 0;
    if (torque)
        stuck.push_back({"torque", fmt::format("the torque is {:.4g} N m", recording.torque[0]),
                         "whether the torque was recorded, or a set point or an empty channel "
                         "instead",
                         false});
    if (gap && !torque)
        stuck.push_back({"height", fmt::format("the gap is {:.4g} mm", 1e3 * recording.height[0]),
                         "whether the gap was measured or is a set point, whose error is unknown",
                         true});
    return stuck;
}

}  // namespace

void doubt_stuck_columns(const Recording& recording, Measurements& part,
                         const ImportSettings& choice) {
    if (recording.size() < shortest_step) return;
    for (const StuckColumn& stuck : stuck_columns(recording)) {
        const bool aside = !stuck.usable && !choice.keep_implausible;
        const std::string what = fmt::format(
            "{} in every row, as no measurement would be; check {}", stuck.what, stuck.check);
        const Position origin{recording.file, recording.line.front(), 0};
        part.doubts.push_back({fmt::format("{}: {}.", recording.file, what),
                               std::string(stuck.quantity),
                               {origin},
                               aside});
        if (!aside) continue;
        for (const Reading& reading : part.readings)
            part.excluded.push_back(left_out(reading, "set aside: " + what));
        part.readings.clear();
    }
}

void doubt_solid_fraction_of(const Recording& recording, const AnnularCell& cell,
                             Measurements& part) {
    std::vector<Impossible> found;
    check_range(solid_fraction_range(solid_fraction(median(recording.height), cell)), found);
    for (const Impossible& each : found)
        part.doubts.push_back({fmt::format("{}: {}.", recording.file, reason_of(each)),
                               std::string(each.quantity),
                               {{recording.file, recording.line.front(), 0}},
                               true});
}

}  // namespace pendular
