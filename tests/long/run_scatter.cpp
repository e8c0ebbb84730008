// The scatter between runs against their reported standard errors, at the size of calibrations, dry
// and wet. tests/physics/run_scatter.cpp does it on small samples. About 10 minutes on two cores.
#include "tests/physics/scatter.h"

#include <algorithm>
#include <thread>

namespace run_scatter_test {

using namespace pendular;

const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));

constexpr dem::RunParameters calibration_run{.friction = 0.15,
                                             .inertial_number = 0.01,
                                             .stiffness_number = 1000,
                                             .grains = 1000,
                                             .strain = 6};

TEST(RunScatter, OfDryCalibrationRunsIsTheReportedStandardError) {
    dem::RunParameters run = calibration_run;
    run.seed = 20'000;
    expect_scatter_as_reported(run, threads);
}

TEST(RunScatter, OfWetCalibrationRunsIsTheReportedStandardError) {
    dem::RunParameters run = calibration_run;
    run.wetting = dem::Wetting{.reduced_pressure = 2, .bridge_volume = 2e-3};
    run.seed = 30'000;
    expect_scatter_as_reported(run, threads);
}

}  // namespace run_scatter_test
