// Observables at stiffness numbers other than that of most training runs: predictions against
// runs that were left out of the training, with the errors that the predictions state.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "calib/emulator/emulated_observables.h"
#include "tests/support/emulator_support.h"

namespace pendular::other_stiffness_test {

using dem::Observable;

/// Bounds of the mean square of 60 standardised deviations: chi2 of 60 degrees of freedom per
/// degree lies outside with probability 0.001.
constexpr double least = 0.50, most = 1.71;
/// Number of parts of the stiff runs, each of which is left out in turn.
constexpr int parts = 5;

/// Deviation of a run from the prediction for its state and stiffness number, in standard errors of
/// both.
double deviation(const Emulator& emulator, const dem::RunResult& run, Observable which) {
    const std::vector<Query> query = {{emulated::flow_state_of(run.parameters), which}};
    const double variance = emulator.covariance(query)(0, 0) + emulator.noise_variance(run, which);
    return (emulated::training_value(run, which).value - emulator.mean(query)(0)) /
           std::sqrt(variance);
}

TEST(OtherStiffness, IsPredictedWithItsError) {
    std::vector<dem::RunResult> usual = shipped_runs(), other;
    std::erase_if(usual, [&](const dem::RunResult& run) {
        const bool stiff = run.parameters.stiffness_number > 2000;
        if (stiff && emulated::usable(run)) other.push_back(run);
        return stiff;
    });
    std::map<Observable, std::vector<double>> deviations, unchanged;
    const Emulator unknowing(usual, shipped_hyperparameters());
    for (int part = 0; part < parts; ++part) {
        std::vector<dem::RunResult> training = usual, left_out;
        for (std::size_t k = 0; k < other.size(); ++k) {
            (static_cast<int>(k % parts) == part ? left_out : training).push_back(other[k]);
        }
        const Emulator emulator(training, shipped_hyperparameters());
        for (const dem::RunResult& run : left_out) {
            for (const Observable which : emulated::observables()) {
                if (!emulated::has_value(run, which)) continue;
                deviations[which].push_back(deviation(emulator, run, which));
                unchanged[which].push_back(deviation(unknowing, run, which));
            }
        }
    }
    const auto mean_square = [](const std::vector<double>& all) {
        double sum = 0;
        for (const double one : all)
            sum += one * one;
        return sum / static_cast<double>(all.size());
    };
    fmt::print("{:32} {:>5} {:>9} {:>9}\n", "observable", "runs", "variance", "without");
    for (const auto& [which, all] : deviations) {
        const std::string_view name = dem::observable_names[static_cast<std::size_t>(which)];
        fmt::print("{:32} {:5} {:9.2f} {:9.1f}\n", name, all.size(), mean_square(all),
                   mean_square(unchanged[which]));
        EXPECT_LT(mean_square(all), most) << name;
        EXPECT_GT(mean_square(all), least) << name;
    }
}

}  // namespace pendular::other_stiffness_test
