// How often independent recordings are taken for copies with noise.
#include <gtest/gtest.h>

#include "tests/support/honest_studies.h"

namespace pendular::near_copies_test {

// At the stated rate of one study in a thousand, 400 studies would give more than 3 with a
// probability of 0.08 %.
TEST(NearCopies, AreSeldomSeenInHonestStudies) {
    const int count = honest_studies_with_copies(400, 91000);
    fmt::print("{} of 400 studies\n", count);
    EXPECT_LE(count, 3);
}

}  // namespace pendular::near_copies_test
