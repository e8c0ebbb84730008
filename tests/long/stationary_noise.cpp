// Rates of findings in stationary noise, from seeds that no other test uses: the table of
// docs/validation.md.
#include "tests/support/stationary_noise.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace pendular::long_stationary_noise_test {

using Kind = Remark::Kind;
using Fault = std::function<void(RowOfStep, int, int)>;

constexpr int studies = 400;

/// Number of studies of a noise with any finding, or with one of a kind.
int found_in(const StationaryNoise& noise, int files, std::uint64_t first, const Fault& fault = {},
             std::optional<Kind> kind = std::nullopt) {
    int count = 0;
    for (int study = 0; study < studies; ++study) {
        const auto findings =
            findings_in_noise(files, first + static_cast<std::uint64_t>(study), noise, 450, fault);
        count += std::ranges::any_of(
            findings, [&](const Remark& each) { return !kind || each.kind == *kind; });
    }
    return count;
}

// 400 studies with a rate of 5 % give more than 31 findings with a probability of 0.7 %.
TEST(StationaryNoise, SeldomGivesAFinding) {
    fmt::print("{:20} {:>6} {:>8} {:>7} {:>7}\n", "noise", "none", "wobble", "drift", "step");
    for (const StationaryNoise& noise : stationary_noises()) {
        const int alarms = found_in(noise, 3, 900000);
        const int wobbles = found_in(
            noise, 1, 910000,
            [](RowOfStep row, int, int) { row.torque *= 1 + 0.02 * std::cos(row.angle + 0.7); },
            Kind::wobble);
        const int drifts = found_in(
            noise, 3, 920000, [](RowOfStep row, int, int) { row.gap *= 1 - 0.003 * row.time / 90; },
            Kind::drift);
        const int steps = found_in(
            noise, 6, 930000,
            [](RowOfStep row, int, int file) { row.torque *= file >= 3 ? 1.1 : 1; },
            Kind::level_change);
        fmt::print("{:20} {:6} {:8} {:7} {:7}\n", noise.name, alarms, wobbles, drifts, steps);
        EXPECT_LE(alarms, 31) << noise.name;
    }
}

}  // namespace pendular::long_stationary_noise_test
