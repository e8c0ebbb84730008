#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Measured values with the covariance of their errors: shear stress [Pa] and solid fraction [1] of
/// each reading in turn, then direct measurements, each in the unit of its parameter.
struct Measured {
    Eigen::VectorXd value;
    /// Covariance of the errors, with the estimated scatter of replicates as if it were exact.
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` if few replicates determine the scatter; may be empty.
    Eigen::MatrixXd widening = {};
};
/// Returns the values of readings, followed by direct measurements, with the covariance of all
/// errors, including those that several readings share, such as the error of a filling.
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

}  // namespace pendular
