// The error of a fitted friction coefficient holds what the budget of the instrument says.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "calib/fit/parameter_errors.h"
#include "data/recordings/measurements.h"
#include "tests/physics/planted_readings.h"

namespace physics_instrument_coverage_test {

using namespace pendular;

const std::vector<std::pair<std::string, double>> budget = {
    {"torque-gain", 0.02},   {"normal-force-gain", 0.01}, {"bead_mass", 0.005},
    {"inner_radius", 0.005}, {"density", 0.01},           {"diameter", 0.02}};

Study stating_budget() {
    Study study = planted_study();
    for (const auto& [name, size] : budget)
        study.instrument.stated.push_back({name, std::to_string(size)});
    return study;
}

std::shared_ptr<const EffectModel> predictor_of(const Study& study) {
    const std::shared_ptr<const EmulatedSimulation> simulation(std::shared_ptr<void>(),
                                                               &models().simulation());
    return assemble_model(study, simulation, {});
}

std::vector<Condition> conditions_of_study(bool dry) {
    std::vector<Condition> all = conditions();
    if (dry) std::erase_if(all, [](const Condition& each) { return !each.dry(); });
    return all;
}

/// Number of studies of 400 whose fit holds the truth within so many standard errors.
int count_within(double errors, const std::vector<Fit>& fits) {
    return static_cast<int>(std::ranges::count_if(fits, [&](const Fit& each) {
        return std::abs(each.parameters(0) - planted_friction) < errors * each.standard_error(0);
    }));
}

/// The readings with errors as their scatter shows them: each run knows a third of its own.
std::vector<Reading> with_errors_from_replicates(std::vector<Reading> readings) {
    for (Reading& reading : readings) {
        reading.covariance /= 9;
        reading.within_run_only = true;
    }
    Measurements all;
    all.readings = std::move(readings);
    pool_replicates(all);
    return all.readings;
}

struct Design {
    bool dry = false, replicated = false;
};

/// Fits of studies whose shared errors are drawn from the budget and that a model with (or without)
/// the budget is fitted to.
std::vector<Fit> fits_of(int studies, Design design, const Study& fitted) {
    std::vector<Condition> at = conditions_of_study(design.dry);
    if (design.replicated) {
        const std::vector<Condition> again = at;
        at.insert(at.end(), again.begin(), again.end());
    }
    const Eigen::VectorXd friction = Eigen::VectorXd::Constant(1, planted_friction);
    const auto truth = predictor_of(stating_budget());
    const Eigen::VectorXd exact = truth->predict(friction, at, PredictionPart::values).value;
    const Eigen::MatrixXd changes = truth->shared_changes(friction, at);
    const auto predictor = predictor_of(fitted);
    std::mt19937_64 random((design.dry ? 11U : 2026U) + (design.replicated ? 1000U : 0U));
    std::normal_distribution<double> normal;
    std::vector<Fit> fits;
    for (int k = 0; k < studies; ++k) {
        Eigen::VectorXd values = exact;
        for (std::size_t j = 0; j < budget.size(); ++j)
            values += normal(random) * changes.col(static_cast<Eigen::Index>(j));
        std::vector<Reading> readings = scattered(at, values, random);
        if (design.replicated) readings = with_errors_from_replicates(std::move(readings));
        fits.push_back(fit(ModelOfReadings(predictor, at), stack(readings),
                           Eigen::VectorXd::Constant(1, 0.2)));
    }
    return fits;
}

// 400 studies: binomial errors are 2.3 % and 1.1 %, the limits three of them.
void expect_honest(Design design) {
    constexpr int studies = 400;
    const std::vector<Fit> fits = fits_of(studies, design, stating_budget());
    const int one = count_within(1, fits), two = count_within(1.96, fits);
    std::printf("%s readings, %s: %.1f %% within one error, %.1f %% within 1.96\n",
                design.dry ? "dry" : "all", design.replicated ? "replicated" : "with known errors",
                100.0 * one / studies, 100.0 * two / studies);
    EXPECT_NEAR(one, 0.683 * studies, 3 * 0.0233 * studies);
    EXPECT_NEAR(two, 0.95 * studies, 3 * 0.0109 * studies);
}

TEST(InstrumentCoverage, IsHonestForAllReadings) {
    expect_honest({.dry = false});
}

TEST(InstrumentCoverage, IsHonestForDryReadings) {
    expect_honest({.dry = true});
}

TEST(InstrumentCoverage, IsHonestForReplicatesOfAllReadings) {
    expect_honest({.dry = false, .replicated = true});
}

TEST(InstrumentCoverage, IsHonestForReplicatesOfDryReadings) {
    expect_honest({.dry = true, .replicated = true});
}

TEST(InstrumentCoverage, IsMissingWithoutTheBudget) {
    constexpr int studies = 100;
    EXPECT_LT(count_within(1, fits_of(studies, {.dry = false}, planted_study())), studies / 3);
}

}  // namespace physics_instrument_coverage_test
