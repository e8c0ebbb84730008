// Is the standard error of a run the scatter between runs that differ in their seed alone? Forty
// small, soft samples: what is tested is how averages and errors come from the blocks of a run.
// tests/long/run_scatter.cpp does the same with runs as large as those of calibrations. About 20 s.
#include "tests/physics/scatter.h"

TEST(RunScatter, IsTheReportedStandardError) {
    // 500 blocks of strain 0.02.
    pendular::expect_scatter_as_reported({.friction = 0.2,
                                          .inertial_number = 0.05,
                                          .stiffness_number = 300,
                                          .grains = 200,
                                          .strain = 10,
                                          .seed = 9'001},
                                         1);
}
