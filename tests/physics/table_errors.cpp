// Diagnoses of tables of readings without a cell whose stresses or solid fractions have an error
// that all rows share.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/diagnosis/diagnosis.h"
#include "tests/physics/planted_readings.h"

namespace table_errors_test {

using namespace pendular;
using ::testing::Contains;

/// A table as someone writes it who is wrong about shear stresses, normal stresses and solid
/// fractions by these factors, and has a constant in the shear stress [Pa].
struct Mistake {
    double shear = 1, normal = 1, fraction = 1, constant = 0;
};

const Study& table_study() {
    static const Study study = [] {
        Study table = planted_study();
        table.cell.reset();
        for (Source& source : table.sources)
            source.kind = Source::Kind::readings;
        return table;
    }();
    return study;
}

std::vector<Reading> table_with(const Mistake& mistake, std::uint64_t seed) {
    std::vector<Condition> truth = conditions();
    for (Condition& each : truth)
        each.height.reset(), each.bead_volume.reset();
    const auto values = models_of(truth, table_study())
                            .with({})
                            ->predict(Eigen::VectorXd::Constant(1, planted_friction),
                                      PredictionPart::values)
                            .value;
    std::mt19937_64 random(seed);
    std::vector<Reading> readings = scattered(truth, values, random);
    for (Reading& reading : readings) {
        reading.condition.normal_stress *= mistake.normal;
        // Computed from the shear rate with the stress of the table.
        reading.condition.inertial_number /= std::sqrt(mistake.normal);
        reading.value(0) = mistake.shear * reading.value(0) + mistake.constant;
        reading.value(1) *= mistake.fraction;
    }
    return readings;
}

/// Names of the effects in the models that fit.
std::vector<std::string> fitting(const Mistake& mistake, std::uint64_t seed) {
    const std::vector<Reading> readings = table_with(mistake, seed);
    const StudyModelSpace space = models_of(conditions_of(readings), table_study());
    const Diagnosis d = diagnose(space, evidence_of(readings, {}));
    EXPECT_TRUE(d.verdict == Verdict::missing || d.verdict == Verdict::indistinguishable)
        << to_string(d.verdict);
    return d.effects;
}

TEST(TableErrors, AreNamedForWhatTheyAre) {
    EXPECT_THAT(fitting({.shear = 1.15}, 1), Contains("shear-stress-gain"));
    EXPECT_THAT(fitting({.normal = 0.78}, 2), Contains("normal-stress-gain"));  // the full disc
    EXPECT_THAT(fitting({.fraction = 1.02}, 3), Contains("solid-fraction-gain"));
    EXPECT_THAT(fitting({.constant = 15}, 4), Contains("shear-stress-offset"));
}

}  // namespace table_errors_test
