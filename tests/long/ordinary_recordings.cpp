// Ordinary recordings, from seeds that no other test uses: how often a study of them gives a
// finding, and how often independent ones are taken for copies with noise.
#include <gtest/gtest.h>

#include "tests/support/ordinary_studies.h"

namespace pendular::ordinary_recordings_test {

// 400 studies with 5 % of false alarms would give more than 31 with a probability of 0.7 %.
TEST(OrdinaryRecordings, SeldomGiveAFinding) {
    constexpr std::uint64_t first = 70000;
    int count = alarms(100, 3, {}, first);
    count += alarms(100, 4, {.torque = 0.02, .correlation_rows = 10}, first + 100);
    count += alarms(100, 6, {.correlation_rows = 0.2, .torque_resolution = 2e-4}, first + 200);
    count += alarms(100, 8, {.filling = 0.04, .step = 0.02}, first + 300);
    fmt::print("{} of 400 studies\n", count);
    EXPECT_LE(count, 31);
}

// At the stated rate of one study in a thousand, 400 studies would give more than 3 with a
// probability of 0.08 %.
TEST(NearCopies, AreSeldomSeenInHonestStudies) {
    const int count = honest_studies_with_copies(400, 91000);
    fmt::print("{} of 400 studies\n", count);
    EXPECT_LE(count, 3);
}

}  // namespace pendular::ordinary_recordings_test
