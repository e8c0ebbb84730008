#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"
#include "sim/catalogue/resolved_study.h"

// What a fit is given: the readings of a study in the order of a calibration, and their values with
// the covariance of all errors.
namespace pendular {

/// Returns the readings of a study in the order of a calibration: dry readings, then wet readings,
/// each in the order of `Measurements::readings`.
std::vector<Reading> dry_first(const Measurements& measurements);

/// Largest number of readings that a fit treats one by one. The time of a fit grows with the cube
/// of the number: 200 readings take 0.5 s, 3000 would take minutes and 2 GB.
inline constexpr std::size_t most_fitted = 200;

/// Returns the readings that every fit and test of a study uses, dry readings first: the readings
/// of the study or, if there are more than `most_fitted`, means of readings at similar conditions
/// (`binned_readings`).
std::vector<Reading> readings_to_fit(const Measurements& measurements);

/// Returns a note for the user that `used` means take the place of `measured` readings; empty if
/// the readings themselves are used.
std::optional<std::string> note_on_means(std::size_t used, std::size_t measured);

std::size_t dry_count(const std::vector<Reading>& readings);

/// Returns the readings with indices `from` to `to` - 1.
std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to);

/// Measured values with the covariance of their errors: shear stress [Pa] and solid fraction [1] of
/// each reading in turn, then direct measurements, each in the unit of its parameter.
struct Measured {
    Eigen::VectorXd value;
    /// Covariance of the errors, with the estimated scatter of replicates as if it were exact.
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` if few replicates determine the scatter; may be empty.
    Eigen::MatrixXd widening = {};
    /// Entries whose error is so large that they tell nothing, such as the solid fraction of a bed
    /// that creeps: they are no degrees of freedom.
    std::vector<Eigen::Index> unknown = {};

    /// Returns the number of values that tell something.
    Eigen::Index informative() const { return value.size() - std::ssize(unknown); }
};
/// Returns the values of readings, followed by direct measurements, with the covariance of all
/// errors, including those that several readings share, such as the error of a filling.
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

}  // namespace pendular
