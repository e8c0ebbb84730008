#include "data/recordings/speed_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace pendular {
namespace {

using Steps = std::vector<const Reading*>;

/// Factor between the numbers of an angular velocity in two units.
struct UnitFactor {
    double factor;
    const char* units;
};

constexpr UnitFactor unit_factors[] = {{30 / std::numbers::pi, "1/min (rpm) and rad/s"},
                                       {2 * std::numbers::pi, "turn/s and rad/s"}};

/// Readings of recordings by file, in the order of the steps.
std::map<std::string, Steps> steps_by_file(const std::vector<Reading>& readings) {
    std::map<std::string, Steps> files;
    for (const Reading& reading : readings) {
        if (reading.step > 0 && !reading.condition.at_failure)
            files[reading.origin.file].push_back(&reading);
    }
    return files;
}

/// Quotient of the angular velocities of each step that two files took at equal normal stress and
/// liquid content. The inertial number, at equal normal stress, is proportional to the velocity.
std::vector<double> quotients(const Steps& first, const Steps& second) {
    constexpr double same = 0.02;  // relative difference of equal normal stresses
    std::vector<double> found;
    for (const Reading* a : first) {
        const auto b = std::ranges::find(second, a->step, &Reading::step);
        if (b == second.end()) continue;
        const Condition &one = a->condition, &other = (*b)->condition;
        const double stresses = one.normal_stress / other.normal_stress;
        if (one.liquid_content != other.liquid_content || std::abs(stresses - 1) > same ||
            !(one.inertial_number > 0) || !(other.inertial_number > 0))
            continue;
        found.push_back(one.inertial_number / other.inertial_number * std::sqrt(stresses));
    }
    return found;
}

/// The units between whose numbers all quotients (at least two), or all their reciprocals, are the
/// factor.
std::optional<UnitFactor> unit_factor_of(const std::vector<double>& quotients) {
    constexpr double tolerance = 0.02;
    if (quotients.size() < 2) return std::nullopt;
    for (const UnitFactor& each : unit_factors) {
        const auto close = [&](double value) { return std::abs(value - 1) < tolerance; };
        if (std::ranges::all_of(quotients, [&](double q) { return close(q / each.factor); }) ||
            std::ranges::all_of(quotients, [&](double q) { return close(q * each.factor); }))
            return each;
    }
    return std::nullopt;
}

std::string name_of(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

}  // namespace

void doubt_speed_units(Measurements& all) {
    const auto files = steps_by_file(all.readings);
    for (auto second = files.begin(); second != files.end(); ++second) {
        for (auto first = files.begin(); first != second; ++first) {
            const auto factor = unit_factor_of(quotients(first->second, second->second));
            if (!factor) continue;
            std::vector<Position> origins;
            for (const Reading* reading : second->second)
                origins.push_back(reading->origin);
            all.doubts.push_back(
                {fmt::format("The angular velocities of {} and {} differ by a factor of {:.3g} at "
                             "the same steps, the factor between {}; check the unit in the header "
                             "of both files.",
                             name_of(first->first), name_of(second->first), factor->factor,
                             factor->units),
                 "angular_velocity", origins, false});
            break;  // one doubt for each file is enough
        }
    }
}

}  // namespace pendular
