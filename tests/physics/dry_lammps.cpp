// The same dry flow run with LAMMPS (reference/README.md): an independent code, damping law and
// height control. Both codes' standard errors count, and on top the differences the two contact
// models may make: 0.004 in stress ratio, 0.0015 in solid fraction.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "sim/dem/run.h"
#include "sim/runs/run_request.h"

namespace dry_lammps_test {

using namespace pendular::dem;

struct Row {
    double friction, inertial_number, stiffness_number, grains, strain;
    double stress_ratio, stress_ratio_sd, solid_fraction, solid_fraction_sd;
};

std::vector<Row> reference() {
    std::ifstream file(PENDULAR_SOURCE_DIR "/tests/physics/reference/dry-lammps.csv");
    std::vector<Row> rows;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::ranges::replace(line, ',', ' ');
        std::istringstream cells(line);
        Row r{};
        cells >> r.friction >> r.inertial_number >> r.stiffness_number >> r.grains >> r.strain >>
            r.stress_ratio >> r.stress_ratio_sd >> r.solid_fraction >> r.solid_fraction_sd;
        rows.push_back(r);
    }
    return rows;
}

void PrintTo(const Row& r, std::ostream* out) {
    *out << "friction " << r.friction << ", I " << r.inertial_number;
}

std::string name_of(const testing::TestParamInfo<Row>& info) {
    std::ostringstream name;
    name << "friction" << std::lround(1000 * info.param.friction) << "e3_I"
         << std::lround(1000 * info.param.inertial_number) << "e3";
    return name.str();
}

class DryLammps : public testing::TestWithParam<Row> {};

TEST_P(DryLammps, Agrees) {
    const Row& row = GetParam();
    const RunResult run = pendular::simulate({.friction = row.friction,
                                              .inertial_number = row.inertial_number,
                                              .stiffness_number = row.stiffness_number,
                                              .grains = static_cast<int>(row.grains),
                                              .strain = 4,
                                              .seed = 2026});
    EXPECT_TRUE(run.steady);
    EXPECT_FALSE(run.crystallised);
    const auto& ratio = run[Observable::stress_ratio];
    const auto& fraction = run[Observable::solid_fraction];
    EXPECT_NEAR(ratio.value, row.stress_ratio,
                3 * std::hypot(ratio.standard_error, row.stress_ratio_sd) + 0.004);
    EXPECT_NEAR(fraction.value, row.solid_fraction,
                3 * std::hypot(fraction.standard_error, row.solid_fraction_sd) + 0.0015);
    EXPECT_LT(run[Observable::localization].value, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Rows, DryLammps, testing::ValuesIn(reference()), name_of);

TEST(DryLammpsTable, IsThere) {
    EXPECT_EQ(reference().size(), 8u);
}

}  // namespace dry_lammps_test
