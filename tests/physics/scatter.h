#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// Variance of the differences of runs from their grand mean over their reported standard errors,
/// 1 where the errors are right: a run's share in the grand mean takes 1/n of its variance away.
inline double variance_of_differences(const std::vector<dem::RunResult>& runs,
                                      dem::Observable which) {
    const double n = static_cast<double>(runs.size());
    double grand_mean = 0, sum = 0;
    for (const auto& run : runs) {
        grand_mean += run[which].value / n;
    }
    for (const auto& run : runs) {
        const double z = (run[which].value - grand_mean) / run[which].standard_error;
        sum += z * z;
    }
    return sum / (n - 1);
}

/// Makes forty runs that differ in their seed alone, leaves out the odd one of a small sample that
/// says it crystallised, as calibrations do, and holds the variance of their standardised
/// differences between 0.5 and 1.7: that of 40 has a standard error of 0.23, and the errors' own
/// errors, from 4 to 30 independent blocks each, add to it.
inline void expect_scatter_as_reported(dem::RunParameters like, int threads) {
    std::vector<dem::RunParameters> parameters(40, like);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        parameters[k].seed += k;
    }
    auto runs = run_all(parameters, {.threads = threads});
    for (const auto& run : runs) {
        ASSERT_TRUE(run.failure.empty()) << run.failure;
        EXPECT_TRUE(run.steady);
    }
    std::erase_if(runs, [](const dem::RunResult& run) { return run.crystallised; });
    EXPECT_GE(runs.size(), 38u);
    for (const auto which : {dem::Observable::stress_ratio, dem::Observable::solid_fraction}) {
        const double variance = variance_of_differences(runs, which);
        double blocks = 0;
        for (const auto& run : runs) {
            blocks += run[which].correlation_samples / static_cast<double>(runs.size());
        }
        std::printf("%s: variance of standardised differences %.2f; 2 tau is %.0f blocks\n",
                    std::string(dem::observable_names[static_cast<std::size_t>(which)]).c_str(),
                    variance, blocks);
        EXPECT_GT(variance, 0.5);
        EXPECT_LT(variance, 1.7);
    }
}

}  // namespace pendular
