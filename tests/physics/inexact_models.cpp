// Verdicts on studies whose model differs from the grains by an error of each condition that the
// replicates share, as two codes differ. Readings are those that the emulator predicts, off by its
// own errors, by an error of 0.4 % of the shear stress and 0.06 % of the solid fraction for each
// condition, and by the scatter of two replicates. Seeds are fixed.
#include <gtest/gtest.h>

#include "analysis/diagnosis/diagnosis.h"
#include "tests/physics/planted_readings.h"

namespace pendular::inexact_models_test {

constexpr int studies = 24;
constexpr std::array error_of_model = {0.004, 0.0006};
constexpr std::array scatter = {0.01, 0.001};

/// Each condition twice.
std::vector<Condition> repeated() {
    std::vector<Condition> all = conditions();
    const std::vector<Condition> once = all;
    all.insert(all.end(), once.begin(), once.end());
    return all;
}

StudyModelSpace space_of(const std::array<double, 2>& discrepancy) {
    return models_of(repeated(), planted_study()).with_discrepancy(discrepancy);
}

/// Readings of grains with an effect of some size, or without one.
std::vector<Reading> measured(const Planted& planted, std::uint64_t seed) {
    static const StudyModelSpace exact = models_of(repeated());
    const std::shared_ptr<const Model> truth =
        exact.with(planted.effect.empty() ? EffectSet{} : place_of(planted.effect));
    const Prediction prediction = truth->predict(truth_of(planted, *truth));
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd covariance = prediction.covariance;
    covariance.diagonal() *= 1 + 1e-6;  // replicates are predicted alike
    const Eigen::MatrixXd lower = covariance.llt().matrixL();
    Eigen::VectorXd values =
        prediction.value + lower * Eigen::VectorXd::NullaryExpr(prediction.value.size(),
                                                                [&] { return normal(random); });
    const Eigen::Index half = values.size() / 2;
    for (Eigen::Index k = 0; k < half; ++k) {
        const double factor = 1 + error_of_model[static_cast<std::size_t>(k % 2)] * normal(random);
        values(k) *= factor, values(half + k) *= factor;
    }
    std::vector<Reading> readings;
    for (const Condition& condition : repeated()) {
        const auto at = 2 * static_cast<Eigen::Index>(readings.size());
        Reading reading{.condition = condition};
        const Eigen::Vector2d errors(scatter[0] * values(at), scatter[1] * values(at + 1));
        reading.value = values.segment<2>(at) +
                        Eigen::Vector2d(errors(0) * normal(random), errors(1) * normal(random));
        reading.covariance = errors.cwiseAbs2().asDiagonal();
        readings.push_back(reading);
    }
    return readings;
}

/// Alarms of complete studies whose models are expected to err by `discrepancy`, in the first
/// diagnosis and in the one that stands.
std::array<int, 2> alarms(const std::array<double, 2>& discrepancy) {
    const StudyModelSpace space = space_of(discrepancy);
    const auto raised = [](const Diagnosis& d) {
        return d.verdict != Verdict::nothing_missing && d.verdict != Verdict::inconclusive;
    };
    std::array<int, 2> count{};
    for (std::uint64_t seed = 1; seed <= studies; ++seed) {
        const Evidence evidence = evidence_of(measured({"", 0}, 5400 + seed), {});
        const DiagnosisOptions options{.draws = 1000, .seed = seed};
        count[0] += raised(diagnose(space, evidence, options));
        count[1] += raised(diagnose_inexact(space, discrepancy, evidence, options).diagnosis);
    }
    return count;
}

TEST(InexactModels, RaiseNoAlarmUnlessTheyCountAsExact) {
    EXPECT_LE(alarms(usual_discrepancy)[1], 4);  // 5 % of 24: more in 1 of 200 cases
    EXPECT_GE(alarms({0, 0})[1], 8);
}

TEST(InexactModels, RaiseFewAlarmsWhereTheyErrByMoreThanExpected) {
    // The models expect 40 % of the error that the readings have.
    const auto [first, standing] = alarms({usual_discrepancy[0] / 2.5, usual_discrepancy[1] / 2.5});
    EXPECT_LE(standing, 6);
    EXPECT_LT(standing, first);  // 6 and 7: the expected discrepancy does most
}

TEST(InexactModels, LeaveALargeEffectNamed) {
    const StudyModelSpace space = space_of(usual_discrepancy);
    int named = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Diagnosis d =
            diagnose_inexact(space, usual_discrepancy,
                             evidence_of(measured({"lid-slip", 0.4}, 5500 + seed), {}),
                             {.draws = 1000, .seed = seed})
                .diagnosis;
        named += d.verdict == Verdict::missing && d.effects == std::vector<std::string>{"lid-slip"};
        EXPECT_GT(d.holds_up_to, 1);
        EXPECT_LE(d.holds_up_to, most_inexact);
    }
    EXPECT_GE(named, 7);
}

}  // namespace pendular::inexact_models_test
