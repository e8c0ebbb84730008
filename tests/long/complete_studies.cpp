// How often the diagnosis calls a complete model of a study incomplete: readings that the emulator
// predicts, off by its own errors and by those of the measurement.
#include <gtest/gtest.h>

#include "analysis/diagnosis/diagnosis.h"
#include "tests/physics/planted_readings.h"

using namespace pendular;

TEST(CompleteStudies, AreCalledIncompleteAsOftenAsIsSaid) {
    int alarms = 0;
    for (std::uint64_t study = 1; study <= 300; ++study) {
        const Diagnosis d = diagnose(models(), evidence_of(readings_with({}, study, true), {}),
                                     {.draws = 2000, .seed = study});
        const bool alarm =
            d.verdict != Verdict::nothing_missing && d.verdict != Verdict::inconclusive;
        alarms += alarm;
        if (alarm) {
            std::string named;
            for (const std::string& effect : d.effects)
                named += " " + effect;
            std::printf("%d of %d:%s%s\n", alarms, static_cast<int>(study),
                        std::string(to_string(d.verdict)).c_str(), named.c_str());
            std::fflush(stdout);
        }
    }
    std::printf("%d of 300\n", alarms);
    // 5 %, with 99 % of binomial scatter.
    EXPECT_GE(alarms, 6);
    EXPECT_LE(alarms, 25);
}
