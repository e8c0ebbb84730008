// Quantities along which residuals are checked for trends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/diagnosis/evidence.h"
#include "analysis/diagnosis/where_it_fails.h"

namespace covariates_test {

using namespace pendular;

/// Readings at one condition from files, one each.
std::vector<Reading> from(const std::vector<const char*>& files) {
    std::vector<Reading> readings;
    for (const char* const file : files) {
        readings.emplace_back();
        readings.back().origin = {file, static_cast<int>(readings.size()), 0};
        readings.back().condition.normal_stress = 1000;
    }
    return readings;
}

bool knows_order(const std::vector<Reading>& readings) {
    return std::ranges::any_of(covariates_of(readings, Eigen::VectorXd::Ones(6)),
                               [](const Covariate& each) { return each.name == "run order"; });
}

TEST(RunOrder, IsKnownWithinOneTableOrByTime) {
    EXPECT_TRUE(knows_order(from({"a.csv", "a.csv", "a.csv"})));
    EXPECT_FALSE(knows_order(from({"a.csv", "a.csv", "b.csv"})));
    std::vector<Reading> timed = from({"a.csv", "b.csv", "a.csv"});
    for (std::size_t k = 0; k < 3; ++k)
        timed[k].condition.time = 1000 + 10.0 * static_cast<double>(k);
    EXPECT_TRUE(knows_order(timed));
}

std::vector<std::string> suspects_of(const std::vector<Reading>& readings) {
    std::vector<std::string> names;
    for (const SuspectMeasurement& suspect : evidence_of(readings, {}).suspects) {
        names.push_back(suspect.name);
    }
    return names;
}

TEST(SuspectMeasurements, HoldAllRecordingsSinceAChangeOfTheInstrument) {
    using namespace testing;
    std::vector<Reading> readings =
        from({"dry_1.csv", "dry_2.csv", "wet_1.csv", "wet_2.csv", "wet_1.csv"});
    for (std::size_t k = 0; k < readings.size(); ++k) {
        readings[k].value = {200, 0.6};
        readings[k].covariance = Eigen::Matrix2d::Identity();
        readings[k].condition.liquid_content = k < 2 ? 0 : 0.03;
    }
    EXPECT_THAT(suspects_of(readings), Each(Not(HasSubstr("later")))) << "the order is not known";
    const std::vector<double> times = {0, 100, 200, 400, 300};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        readings[k].condition.time = times[k];
    }
    // Not from wet_1.csv on, since the liquid is added there, nor wet_2.csv alone a second time.
    const std::vector<std::string> names = suspects_of(readings);
    EXPECT_THAT(names, Contains("the readings of dry_2.csv and the 2 later files"));
    EXPECT_THAT(names, Contains(HasSubstr("later")).Times(1));
    readings[0].condition.time = 150;  // dry_1.csv goes on after dry_2.csv has begun
    readings[1].condition.time = 120;
    readings.push_back(readings[0]);
    readings.back().condition.time = 100;
    EXPECT_THAT(suspects_of(readings), Each(Not(HasSubstr("later"))));
}

/// Clean studies of a cell of 0.01 m^2 with two fillings (bead volumes), each sheared dry and wet
/// at five normal stresses in three replicates: shear stress 0.4 s22 and solid fraction 0.6 - 2e-6
/// s22 (0.05 less if wet), scattered by 1 % and 0.2 %. The gap shows `offset` [m] too much. Speed
/// and normal force scatter by 0.1 %.
struct CleanStudy {
    std::vector<Reading> readings;
    Prediction prediction;

    /// @param stated whether the table of readings states the inertial numbers, 0.01 and 0.02
    explicit CleanStudy(std::uint64_t seed, double offset = 0, bool stated = false) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        constexpr double area = 0.01;
        for (const double volume : {3e-5, 6e-5})
            for (const double content : {0.0, 0.03})
                for (const double stress : {500.0, 1000.0, 2000.0, 4000.0, 8000.0})
                    for (int replicate = 0; replicate < 3; ++replicate) {
                        const double fraction = 0.6 - 2e-6 * stress - (content > 0 ? 0.05 : 0);
                        Reading& r = readings.emplace_back();
                        r.origin = {"recording.csv", 10 * static_cast<int>(readings.size())};
                        const double shown =
                            volume / (area * fraction) * (1 + 0.002 * normal(random)) + offset;
                        r.value << 0.4 * stress * (1 + 0.01 * normal(random)),
                            volume / (area * shown);
                        r.condition = {.normal_stress = stress * (1 + 0.001 * normal(random)),
                                       .inertial_number =
                                           0.01 * r.value(1) / fraction * std::sqrt(500 / stress),
                                       .liquid_content = content,
                                       .height = shown,
                                       .bead_volume = volume};
                        r.shear_rate = 1;  // from speed and height
                        if (stated) {
                            r.shear_rate = 0;
                            r.condition.inertial_number = readings.size() % 2 == 0 ? 0.01 : 0.02;
                        }
                        r.covariance << std::pow(0.004 * stress, 2), 0, 0,
                            std::pow(0.002 * fraction, 2);
                        r.replicates = 3;
                        add_prediction(0.4 * stress, fraction);
                    }
        const Eigen::Index n = prediction.value.size();
        prediction.covariance = Eigen::MatrixXd::Zero(n, n);
    }

  private:
    void add_prediction(double stress, double fraction) {
        const Eigen::Index n = prediction.value.size();
        prediction.value.conservativeResize(n + 2);
        prediction.value.tail<2>() << stress, fraction;
        prediction.jacobian.conservativeResize(n + 2, 1);
        prediction.jacobian.bottomRows<2>() << stress / 0.4, 0;  // with respect to the friction
    }
};

WhereItFails failures_of(const CleanStudy& study, std::uint64_t seed) {
    return where_it_fails(study.readings, {}, study.prediction, {{.name = "friction"}}, {}, seed);
}

/// p value of the trend of the residual of an observable along a covariate.
double p_of_trend(const WhereItFails& where, const std::string& of, const std::string& along) {
    const auto trend = std::ranges::find_if(where.checks.all, [&](const Check& check) {
        return check.kind == Check::Kind::trend && check.of == of && check.covariate == along;
    });
    EXPECT_NE(trend, where.checks.all.end()) << along;
    return trend == where.checks.all.end() ? 1 : trend->p;
}

TEST(Covariates, CarryNoErrorOfTheReading) {
    // Along the measured height, the residual of the solid fraction V/(A H) decreases in each of
    // these studies. Of 20 right studies, 6 or more are below p = 0.05 in 1 of 3000 cases.
    constexpr int studies = 20, most = 5;
    int together = 0, by_height = 0, by_speed = 0;
    for (std::uint64_t study = 1; study <= studies; ++study) {
        const WhereItFails where = failures_of(CleanStudy(study), study);
        together += where.checks.p < 0.05;
        by_height += p_of_trend(where, "solid fraction", "height") < 0.05;
        by_speed += p_of_trend(where, "solid fraction", "inertial number") < 0.05;
    }
    EXPECT_LE(together, most);
    EXPECT_LE(by_height, most);
    EXPECT_LE(by_speed, most);
}

TEST(Covariates, TakeStatedInertialNumbersAsTheyAre) {
    const CleanStudy study(1, 0, true);
    for (const Covariate& each : covariates_of(study.readings, study.prediction.value)) {
        if (each.name != "inertial number") continue;
        for (std::size_t k = 0; k < study.readings.size(); ++k) {
            const double value = each.values(2 * static_cast<Eigen::Index>(k));
            EXPECT_EQ(value, study.readings[k].condition.inertial_number);
        }
        return;
    }
    FAIL() << "no covariate";
}

TEST(Covariates, ShowAnOffsetOfTheHeightByTwoFillings) {
    // 0.04 mm of 5 and 10 mm lower the solid fractions by 0.8 % and 0.4 %: a difference of 2
    // standard errors of a reading, 8 of the means of 30 readings each.
    for (std::uint64_t study = 1; study <= 10; ++study) {
        const WhereItFails where = failures_of(CleanStudy(study, 4e-5), study);
        EXPECT_LT(p_of_trend(where, "solid fraction", "height"), 0.05);
        EXPECT_LT(where.checks.p, 0.05);
    }
}

}  // namespace covariates_test
