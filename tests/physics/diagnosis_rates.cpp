// How often a diagnosis is wrong where all laws are exact. Seeds are fixed, the range holds 99 % of
// what binomial scatter makes of 5 % of 300.
#include <gtest/gtest.h>

#include "tests/unit/line_study.h"

using namespace pendular;

TEST(Diagnosis, CallsACompleteModelIncompleteAsOftenAsItSays) {
    const LinearSpace space = line_and();
    for (const bool estimated : {false, true}) {
        Measuring measuring(estimated ? 12 : 11);
        int alarms = 0;
        for (int study = 0; study < 300; ++study) {
            const Diagnosis d = diagnose(space, measuring.of(plain(), estimated),
                                         quickly(1 + static_cast<unsigned>(study)));
            alarms += d.verdict != Verdict::nothing_missing && d.verdict != Verdict::inconclusive;
        }
        EXPECT_GE(alarms, 6) << estimated;
        EXPECT_LE(alarms, 25) << estimated;
    }
}
