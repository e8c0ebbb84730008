#include "data/quantities/unit_factors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/grains.h"

namespace pendular {
namespace {

constexpr double turn = 2 * std::numbers::pi, degree = std::numbers::pi / 180;

/// Mix-ups of speeds; the last two are those of rates, which have no angle.
constexpr UnitMixUp speeds[] = {
    {"rpm", "rad/s", turn / 60}, {"turn/s (Hz)", "rad/s", turn},     {"deg/s", "rad/s", degree},
    {"rad/s", "rpm", 60 / turn}, {"rad/s", "turn/s (Hz)", 1 / turn}, {"rad/s", "deg/s", 1 / degree},
    {"1/s", "1/min", 60},        {"1/min", "1/s", 1.0 / 60}};

/// Mix-ups of torques; all but the last are those of forces.
constexpr UnitMixUp torques[] = {{"kilogram-force", "newton", gravity},
                                 {"gram-force", "newton", gravity / 1000},
                                 {"newton", "kilogram-force", 1 / gravity},
                                 {"gf cm", "mN m", gravity / 100}};

}  // namespace

std::string UnitMixUp::meaning() const {
    return fmt::format("numbers in {} were read as {}", unit, taken_for);
}

std::span<const UnitMixUp> unit_mix_ups(std::string_view quantity) {
    if (quantity == "angular_velocity") return speeds;
    if (quantity == "shear_rate") return std::span(speeds).last(2);
    if (quantity == "torque") return torques;
    if (quantity == "normal_force") return std::span(torques).first(3);
    return {};
}

const UnitMixUp* find_mix_up(std::string_view quantity, double factor, double tolerance) {
    const auto all = unit_mix_ups(quantity);
    const auto found = std::ranges::find_if(
        all, [&](const UnitMixUp& each) { return std::abs(factor / each.factor - 1) < tolerance; });
    return found == all.end() ? nullptr : &*found;
}

std::optional<int> power_of_ten(double factor, double tolerance) {
    const double size = std::abs(factor);
    if (!(size > 0) || std::isinf(size)) return std::nullopt;
    const double power = std::round(std::log10(size));
    if (std::abs(size / std::pow(10, power) - 1) > tolerance) return std::nullopt;
    return static_cast<int>(power);
}

}  // namespace pendular
