#include "data/recordings/spikes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pendular::data_spikes_test {

std::vector<double> noisy(std::size_t count, double scatter) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    std::vector<double> result;
    for (std::size_t k = 0; k < count; ++k)
        result.push_back(1 + 0.5 * (1 - std::exp(-0.05 * static_cast<double>(k))) +
                         scatter * normal(random));
    return result;
}

TEST(Spikes, AreShortJumpsFarBeyondTheNoise) {
    std::vector<double> series = noisy(400, 0.02);
    series[100] *= 10;
    series[200] = 0;
    series[201] = 0;
    EXPECT_THAT(spikes(series), testing::ElementsAre(100, 200, 201));
}

TEST(Spikes, AreNotSeenInNoiseRisesStepsAndStickSlip) {
    EXPECT_THAT(spikes(noisy(4000, 0.02)), testing::IsEmpty());
    EXPECT_THAT(spikes(noisy(4000, 0)), testing::IsEmpty());
    std::vector<double> step = noisy(400, 0.01);
    for (std::size_t k = 200; k < 400; ++k)
        step[k] *= 2;
    EXPECT_THAT(spikes(step), testing::IsEmpty());
    std::vector<double> slips;  // rises and falls every ten samples
    for (int k = 0; k < 400; ++k)
        slips.push_back(1 + 0.05 * (k % 10));
    EXPECT_THAT(spikes(slips), testing::IsEmpty());
}

}  // namespace pendular::data_spikes_test
