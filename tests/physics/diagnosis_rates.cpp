// How often a diagnosis is wrong where all laws are exact: 2 to 8.3 % (6 to 25 of 300), of enough
// studies that chance moves the rate by 0.5 %. Measured: 4.3 % with known errors, 2.9 % with errors
// estimated from replicates, so that 300 of the latter would fall below 6 in one case of ten.
#include <gtest/gtest.h>

#include "tests/support/line_study.h"

using namespace pendular;

TEST(Diagnosis, CallsACompleteModelIncompleteAsOftenAsItSays) {
    const LinearSpace space = line_and();
    for (const bool estimated : {false, true}) {
        Measuring measuring(estimated ? 102 : 101);
        int alarms = 0;
        for (int study = 0; study < 1500; ++study) {
            const Diagnosis d = diagnose(space, measuring.of(plain(), estimated),
                                         quickly(1 + static_cast<unsigned>(study)));
            alarms += d.verdict != Verdict::nothing_missing && d.verdict != Verdict::inconclusive;
        }
        EXPECT_GE(alarms, 30) << estimated;
        EXPECT_LE(alarms, 125) << estimated;
    }
}
