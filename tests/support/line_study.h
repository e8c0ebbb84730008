#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "tests/support/linear_space.h"

// Readings about a straight line with standard errors of 1, and a model space of curves that the
// line may lack, so that the right result of every diagnosis is known.
namespace pendular {

constexpr int line_conditions = 15, replicates = 2, entries = line_conditions * replicates;

/// Position x of entry k of the readings [1], from -1 to 1. Two replicates at one position follow
/// each other.
inline double place(Eigen::Index k) {
    return -1 + 2.0 * static_cast<double>(k / replicates) / (line_conditions - 1);
}

/// Returns the values of a function of the position x at all entries of the readings.
template <typename Function>
Eigen::VectorXd over_places(Function function) {
    return Eigen::VectorXd::NullaryExpr(entries,
                                        [&](Eigen::Index k) { return function(place(k)); });
}

/// Returns a candidate effect whose change of the readings is proportional to a function of the
/// position x.
/// @param shape change of a reading at position x if the candidate's parameter is 1
inline LinearSpace::Column column(const std::string& name, double (*shape)(double)) {
    return {.name = name, .values = over_places(shape)};
}

/// Returns the model space of a straight line to which any set of the candidate effects parabola,
/// wave and jump can be added.
/// @param more further candidates
inline LinearSpace line_and(std::vector<LinearSpace::Column> more = {}) {
    Eigen::MatrixXd base(entries, 2);
    base << Eigen::VectorXd::Ones(entries), over_places([](double x) { return x; });
    std::vector<LinearSpace::Column> columns = {
        column("parabola", [](double x) { return x * x; }),
        column("wave", [](double x) { return std::sin(3 * std::numbers::pi * x); }),
        column("jump", [](double x) { return x > 0.3 ? 1.0 : 0.0; })};
    columns.insert(columns.end(), more.begin(), more.end());
    return {base, columns};
}

/// Makes readings with random errors of standard deviation 1.
class Measuring {
  public:
    explicit Measuring(std::uint64_t seed) : random_(seed) {}

    /// Returns readings that scatter about true values with standard deviation 1, and their stated
    /// standard errors.
    /// @param truth true value of each entry
    /// @param estimated true: the stated standard error is estimated from the scatter of the
    ///        replicates; false: the stated standard error is the true one, 1
    Evidence of(const Eigen::VectorXd& truth, bool estimated = false) {
        Evidence evidence;
        evidence.measured.value = truth;
        for (double& value : evidence.measured.value)
            value += normal_(random_);
        evidence.errors = ErrorKnowledge::known(entries);
        double variance = 1;
        if (estimated) {
            variance = 0;
            for (Eigen::Index k = 0; k < entries; k += 2) {
                variance +=
                    std::pow(evidence.measured.value(k) - evidence.measured.value(k + 1), 2) / 2;
            }
            variance /= line_conditions;
            evidence.errors.freedom = {line_conditions};
        }
        evidence.measured.covariance = variance * Eigen::MatrixXd::Identity(entries, entries);
        for (Eigen::Index k = 0; k < entries; k += 2) {
            evidence.conditions.push_back({k, k + 1});
            SuspectMeasurement suspect{"condition " + std::to_string(k / 2),
                                       Eigen::MatrixXd::Zero(entries, 1)};
            suspect.columns(k, 0) = suspect.columns(k + 1, 0) = 1;
            evidence.suspects.push_back(suspect);
        }
        return evidence;
    }

  private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

/// Returns the options of a fast diagnosis, with 1000 random draws for its p values. With so few
/// draws, p values depend on the seed: give each study its own seed.
inline DiagnosisOptions quickly(std::uint64_t seed = 1) {
    return {.draws = 1000, .seed = seed};
}

/// Returns the values of the straight line 5 + 2 x at all entries of the readings. The line alone
/// explains them: no candidate effect is needed.
inline Eigen::VectorXd plain() {
    return over_places([](double x) { return 5 + 2 * x; });
}

}  // namespace pendular
