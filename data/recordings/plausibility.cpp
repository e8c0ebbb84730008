#include "data/recordings/plausibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "data/grains.h"
#include "data/quantities/statistics.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Smallest plausible reduced pressure [1], a fifth of the lowest simulated one, and largest
/// plausible inertial number [1], ten times the highest simulated one, here or by Badetti et al.
/// (2018).
constexpr double least_reduced_pressure = 0.1, greatest_inertial_number = 1;

/// Range of a quantity in most flows: chosen, to find the power of ten that a wrong prefix costs.
struct UsualRange {
    std::string_view quantity;
    double least, greatest;
};
constexpr std::array usual_ranges = {
    UsualRange{"solid_fraction", 0.5, 0.66}, UsualRange{"stress_ratio", 0.2, 0.7},
    UsualRange{"inertial_number", 1e-3, 3e-2}, UsualRange{"reduced_pressure", 1, 30}};

/// Adds a remark on a value outside of a range.
void check_range(const char* quantity, double value, double least, double greatest,
                 std::vector<Remark>& found) {
    if (value >= least && value <= greatest) return;
    found.push_back({.kind = Kind::impossible_value,
                     .quantity = quantity,
                     .size = value,
                     .limit = value < least ? least : greatest});
}

/// Reduced pressure P* [1] of a wet reading; infinite for a dry reading.
double pressure_of(const Reading& reading, const Study& study) {
    if (reading.condition.dry() || !study.liquid) return unlimited;
    return reduced_pressure(reading.condition.normal_stress, study.grains, *study.liquid);
}

std::vector<Remark> impossible_values(const Reading& reading, const Study& study) {
    std::vector<Remark> found;
    const double pressure = pressure_of(reading, study), content = reading.condition.liquid_content;
    check_range("solid_fraction", reading.value(1), loosest_solid_fraction, densest_solid_fraction,
                found);
    check_range("stress_ratio", reading.stress_ratio(), least_stress_ratio,
                greatest_stress_ratio(pressure), found);
    check_range("inertial_number", reading.condition.inertial_number, 0, greatest_inertial_number,
                found);
    check_range("reduced_pressure", pressure, least_reduced_pressure, unlimited, found);
    if (content != 0)
        check_range("liquid_content", content, driest_pendular, wettest_pendular, found);
    return found;
}

/// Adds a reading to the remark on all readings that violate the same limit.
void add_to_groups(const Remark& each, const Reading& reading, std::vector<Remark>& groups) {
    const auto below = [](const Remark& remark) { return remark.size < remark.limit; };
    auto group = std::ranges::find_if(groups, [&](const Remark& other) {
        return other.quantity == each.quantity && below(other.because.front()) == below(each);
    });
    if (group == groups.end()) {
        group = groups.insert(groups.end(), each);
        group->size_to = each.size;
        group->because = {each};
    }
    group->size = std::min(group->size, each.size);
    group->size_to = std::max(group->size_to, each.size);
    group->add(reading.origin);
}

}  // namespace

double greatest_stress_ratio(double reduced_pressure) {
    return 1.5 * (1 + 1 / reduced_pressure);
}

int beyond_pendular_range(double content) {
    if (content == 0 || (content >= driest_pendular && content <= wettest_pendular)) return 0;
    return content > wettest_pendular ? 1 : -1;
}

int power_to_usual(std::string_view quantity, double value) {
    const auto usual = std::ranges::find(usual_ranges, quantity, &UsualRange::quantity);
    for (int power = 1; power <= 9; ++power)
        for (const int sign : {-1, 1}) {
            const double mended = value * std::pow(10, sign * power);
            if (mended >= usual->least && mended <= usual->greatest) return sign * power;
        }
    return 0;
}

std::vector<Remark> impossible_readings(const std::vector<Reading>& readings, const Study& study) {
    std::vector<Remark> found, groups;
    for (const Reading& reading : readings) {
        std::vector<Remark> values = impossible_values(reading, study);
        if (values.empty()) continue;
        for (const Remark& each : values)
            add_to_groups(each, reading, groups);
        found.push_back(reading.remark(Kind::impossible_reading));
        found.back().because = std::move(values);
    }
    append(found, std::move(groups));
    return found;
}

std::vector<Remark> constant_columns(const Recording& recording) {
    if (recording.size() < shortest_step) return {};
    const bool torque = least_step(recording.torque) == 0;
    if (!torque && least_step(recording.height) != 0) return {};
    const int line = recording.line.front();
    return {{.kind = torque ? Kind::constant_torque : Kind::constant_gap,
             .quantity = torque ? "torque" : "height",
             .files = {recording.file},
             .lines = {{line, line}},
             .size = torque ? recording.torque[0] : recording.height[0]}};
}

std::vector<Remark> impossible_filling(const Recording& recording, const AnnularCell& cell) {
    std::vector<Remark> found;
    check_range("solid_fraction", solid_fraction(median(recording.height), cell),
                loosest_solid_fraction, densest_solid_fraction, found);
    for (Remark& each : found) {
        each.kind = Kind::impossible_filling;
        each.add({recording.file, recording.line.front(), 0});
    }
    return found;
}

}  // namespace pendular
