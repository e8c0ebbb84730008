// Recordings of the virtual laboratory, from states given to it without simulations, are ordinary:
// what their rows show besides the steady means is only what was put into them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "data/recordings/measurements.h"
#include "sim/lab/virtual_recording.h"
#include "tests/support/data_support.h"

namespace sim_ordinary_labs_test {

using namespace pendular;

/// States at three normal stresses and two inertial numbers, like those of dry polystyrene beads.
std::vector<TrueState> states() {
    std::vector<TrueState> result;
    for (const double stress : {300.0, 1000.0, 3000.0})
        for (const double number : {0.003, 0.03})
            result.push_back({{.normal_stress = stress, .inertial_number = number},
                              {0.28 + number, 0.001, 1},
                              {0.62 - 0.2 * number, 0.0005, 1}});
    return result;
}

/// Import of a study of four recordings in a cell of 200 g of beads, so that a step covers more
/// than two turns of the lid.
Measurements study_of(std::uint64_t seed, const Instrument& instrument, double change) {
    const GrainProperties grains{.diameter = 5e-4, .density = 1050};
    const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.2 / 1050};
    const TemporaryFolder folder;
    for (std::uint64_t file = 0; file < 6; ++file) {
        Recording recording = record(states(), cell, grains, instrument, 100 * seed + 10 * file);
        if (file >= 3)
            for (double& torque : recording.torque)
                torque *= change;
        folder.write(fmt::format("dry_{}.csv", file + 1), recording_csv(recording));
    }
    folder.write("study.toml",
                 grains_table + cell_table("200 g") + "[[recording]]\nfile = \"dry_*.csv\"\n");
    return read_measurements(read_study(folder.path()));
}

// 30 studies with 5 % of false alarms would give more than 5 with a probability of 0.3 %.
TEST(OrdinaryLabs, SeldomShowMoreThanTheirMeans) {
    int alarms = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const Measurements m =
            study_of(seed, {.noise = seed % 2 ? 1.0 : 3.0, .drift = seed % 3 ? 0.0 : 1.0}, 1);
        alarms += !m.faults(true).empty();
        for (const std::string& line : sentences(m.faults(true)))
            fmt::print("study {}: {}\n", seed, line);
    }
    EXPECT_LE(alarms, 5);
}

TEST(OrdinaryLabs, ShowAStepBetweenRecordings) {
    const Measurements m = study_of(5, {}, 1.1);
    ASSERT_EQ(m.faults(true).size(), 1u);
    EXPECT_EQ(m.faults(true)[0].kind, Remark::Kind::level_change);
    EXPECT_NEAR(m.faults(true)[0].relative, 0.1, 0.02);
}

}  // namespace sim_ordinary_labs_test
