#include "data/recordings/checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "data/quantities/units.h"

namespace pendular {
namespace {

using Steps = std::vector<const Reading*>;

/// Readings of recordings in steady shear, by file.
std::map<std::string, Steps> steps_by_file(const std::vector<Reading>& readings) {
    std::map<std::string, Steps> files;
    for (const Reading& reading : readings) {
        const bool has_speed = reading.shear_rate > 0 && reading.condition.height;
        if (reading.within_run_only && reading.step > 0 && has_speed &&
            !reading.condition.at_failure)
            files[reading.origin.file].push_back(&reading);
    }
    return files;
}

/// Speed of the lid at the mean radius [m/s]: shear rate times height.
double speed_of(const Reading& reading) {
    return reading.shear_rate * *reading.condition.height;
}

/// Quotient of the speeds of each step that two files took at equal normal stress and liquid
/// content.
std::vector<double> quotients(const Steps& first, const Steps& second) {
    constexpr double same = 0.02;  // relative, of normal stresses, as for `are_replicates`
    std::vector<double> found;
    for (const Reading* a : first) {
        const auto b = std::ranges::find(second, a->step, &Reading::step);
        if (b == second.end()) continue;
        const Condition &one = a->condition, &other = (*b)->condition;
        if (one.liquid_content == other.liquid_content &&
            std::abs(one.normal_stress / other.normal_stress - 1) <= same)
            found.push_back(speed_of(*a) / speed_of(**b));
    }
    return found;
}

/// Whether there are at least two quotients, all equal to `factor`. The tolerance is below the
/// difference between 2 pi and the ratio 10^0.8 of speeds in a series of five for each decade.
bool all_are(double factor, const std::vector<double>& quotients) {
    constexpr double tolerance = 0.002;
    return quotients.size() >= 2 && std::ranges::all_of(quotients, [&](double quotient) {
               return std::abs(quotient / factor - 1) < tolerance;
           });
}

/// Files whose speeds differ by the factor from more files than they agree with, and the files from
/// which they differ.
struct OddFiles {
    std::vector<std::string> odd, others;
};

OddFiles odd_files(const std::map<std::string, Steps>& files, double factor) {
    OddFiles found;
    for (const auto& [name, steps] : files) {
        if (std::ranges::find(found.others, name) != found.others.end()) continue;
        std::vector<std::string> different;
        std::size_t equal = 0;
        for (const auto& [other, other_steps] : files) {
            if (other == name) continue;
            const std::vector<double> ratios = quotients(steps, other_steps);
            if (all_are(factor, ratios) || all_are(1 / factor, ratios)) different.push_back(other);
            if (all_are(1, ratios)) ++equal;
        }
        if (different.size() <= equal) continue;
        found.odd.push_back(name);
        for (const std::string& other : different) {
            if (std::ranges::find(found.others, other) == found.others.end())
                found.others.push_back(other);
        }
    }
    return found;
}

}  // namespace

std::vector<Remark> other_speed_units(const std::vector<Reading>& readings) {
    const auto files = steps_by_file(readings);
    constexpr std::size_t most = 500;  // the time grows with the square
    std::vector<Remark> found;
    if (files.size() > most) return found;
    for (const UnitMixUp& units : unit_mix_ups("angular_velocity")) {
        if (units.factor < 1) continue;  // the reverse of another, which finds both
        const OddFiles odd = odd_files(files, units.factor);
        if (odd.odd.empty()) continue;
        Remark& doubt = found.emplace_back(Remark{.kind = Remark::Kind::other_speed_unit,
                                                  .quantity = "angular_velocity",
                                                  .size = units.factor,
                                                  .names = odd.others});
        for (const std::string& file : odd.odd)
            for (const Reading* reading : files.at(file))
                doubt.add(reading->origin);
    }
    return found;
}

}  // namespace pendular
