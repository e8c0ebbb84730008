// What the errors of a study's readings rest on, in words.

#include "analysis/misfit/believable.h"
#include "data/recordings/measurements.h"
#include "tests/support/golden.h"

namespace pendular::error_basis_test {

/// Two readings at one condition with stated errors of 1 %, `apart` from each other.
Measurements pair_of_readings(double apart) {
    Measurements all;
    for (const double factor : {1.0, 1 + apart}) {
        Reading reading;
        reading.condition = {1000, 0.01, 0, std::nullopt};
        reading.value = {300 * factor, 0.6 * factor};
        reading.covariance = (0.01 * reading.value).cwiseAbs2().asDiagonal();
        all.readings.push_back(reading);
    }
    pool_replicates(all);
    return all;
}

TEST(ErrorBasis, IsWhatTheUserStatesUnlessReplicatesRefuteIt) {
    expect_told({error_basis(pair_of_readings(0.01)), error_basis(pair_of_readings(0.1))});
}

TEST(ErrorBasis, SaysWhereStatedErrorsAreTooLarge) {
    expect_told({error_basis(pair_of_readings(1e-5)), error_basis(pair_of_readings(0))});
}

TEST(ErrorBasis, SaysWhatIsAssumed) {
    Measurements all, one;
    for (const double stress : {1000.0, 2000.0}) {
        Reading reading;
        reading.condition = {stress, 0.01, 0, std::nullopt};
        reading.value = {0.3 * stress, 0.6};
        all.readings.push_back(reading);
        reading.covariance(0, 0) = 9;
        one.readings.push_back(reading);
    }
    pool_replicates(all);
    pool_replicates(one);
    expect_told({error_basis(all), error_basis(one)});
}

}  // namespace pendular::error_basis_test
