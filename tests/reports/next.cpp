// The next measurement between models whose predictions are known in closed form.
#include "analysis/design/next_measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "data/input_error.h"
#include "data/study/study.h"
#include "reports/next_steps.h"
#include "tests/support/golden.h"
#include "tests/support/known_flow.h"
#include "workflow/json/diagnosis.h"

namespace pendular::analysis_next_test {

/// Shear stress theta s22 + offset, solid fraction 0.6.
class Offset : public KnownFlow {
  public:
    explicit Offset(double offset, double simulation_error = 0,
                    const std::string& parameter = "friction")
        : KnownFlow({{.name = parameter, .upper = 1}}), offset_(offset), error_(simulation_error) {}
    /// One that calls its parameter otherwise.
    explicit Offset(const std::string& parameter) : Offset(0, 0, parameter) {}
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart /*what*/) const override {
        const auto n = 2 * static_cast<Eigen::Index>(conditions.size());
        Prediction result{Eigen::VectorXd(n), Eigen::MatrixXd::Zero(n, 1),
                          Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
        for (Eigen::Index k = 0; k < n; k += 2) {
            const double stress = conditions[static_cast<std::size_t>(k / 2)].normal_stress;
            result.value.segment<2>(k) << parameters(0) * stress + offset_, 0.6;
            result.jacobian(k, 0) = stress;
            result.covariance(k, k) = std::pow(error_ * stress, 2);
        }
        return result;
    }

  private:
    double offset_, error_;
};

FittedModel rival(const std::string& name, const Offset& model, double friction, double error) {
    return {.name = name,
            .predictor = std::make_shared<Offset>(model),
            .fit = {.parameters = Eigen::VectorXd::Constant(1, friction),
                    .covariance = Eigen::MatrixXd::Constant(1, 1, error * error)}};
}

std::vector<Point> at(const std::vector<double>& stresses) {
    std::vector<Point> points;
    for (const double stress : stresses) {
        points.push_back({.condition = {.normal_stress = stress, .inertial_number = 0.01}});
    }
    return points;
}

const Eigen::Vector2d noise(0.01, 0.002);

TEST(NextMeasurement, IsWhereRivalsDifferMost) {
    // 3 Pa more, or a friction that makes up for it at 1 kPa.
    const Offset plain(0), with_offset(3);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 1e-4),
                                             rival("b", with_offset, 0.3, 1e-4)};
    const auto points = at({100, 300, 1000, 3000});
    const auto plans = separating_plans(rivals, points, noise, 10);
    EXPECT_EQ(points[plans.front().point].condition.normal_stress, 100);
    // 2.7 Pa of 30 with 1 %: 81 x 9.63 would be needed for less than one reading.
    EXPECT_EQ(plans.front().repeats, 1);
    ASSERT_EQ(plans.front().separated.size(), 1u);
    // Where they agree, no number of readings helps.
    const auto same = std::ranges::find_if(plans, [&](const Plan& plan) {
        return points[plan.point].condition.normal_stress == 1000;
    });
    EXPECT_EQ(same->repeats, 0);
    EXPECT_TRUE(same->separated.empty());
}

TEST(NextMeasurement, TakesAsManyReadingsAsTellThemApart) {
    const Offset plain(0), with_offset(3);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 1e-6),
                                             rival("b", with_offset, 0.3, 1e-6)};
    const auto plans = separating_plans(rivals, at({500}), noise, 30);
    // They differ by 1.5 Pa with 1.515 Pa of noise: n (1.5/1.515)^2 = 9.63.
    EXPECT_EQ(plans.front().repeats, 10);
    EXPECT_EQ(separating_plans(rivals, at({500}), noise, 9).front().repeats, 0);
    // That many tell them apart in 4 of 5 cases at 5 %.
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    int told = 0;
    for (int study = 0; study < 1000; ++study) {
        const double error = 1.515 / std::sqrt(10.0);
        const double x = 1.5 / error + normal(random), y = normal(random);
        told += x * x + y * y > 5.99;  // the right one is b, judged by a
    }
    EXPECT_NEAR(told, 800, 45);
}

TEST(NextMeasurement, IsNotWhereTheSimulationIsTooUncertain) {
    const Offset plain(0, 0.05), with_offset(3, 0.05);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 1e-4),
                                             rival("b", with_offset, 0.3, 1e-4)};
    EXPECT_TRUE(separating_plans(rivals, at({100, 300}), noise, 100).front().separated.empty());
}

TEST(NextMeasurement, WeighsItsCost) {
    const Offset plain(0), with_offset(3);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 1e-4),
                                             rival("b", with_offset, 0.3, 1e-4)};
    auto points = at({100, 150});
    points[0].first_cost = 5;  // another filling
    const auto plans = separating_plans(rivals, points, noise, 10);
    EXPECT_EQ(plans.front().point, 1u);
    EXPECT_EQ(plans.front().cost, plans.front().repeats);
}

TEST(NextMeasurement, TakesSeveralPointsWhereNoneTellsAlone) {
    // A friction known to 3 % only takes over what the rivals differ by at any point, not at two.
    const Offset plain(0), with_offset(3);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 0.01),
                                             rival("b", with_offset, 0.3, 0.01)};
    const auto points = at({100, 300, 1000, 3000});
    const auto plans = separating_plans(rivals, points, noise, 20);
    ASSERT_TRUE(plans.front().separated.empty());
    Rig rig{.repeats = 20, .readings = 12};
    const Series series = next_series(plans, rivals, points, noise, rig);
    ASSERT_GE(series.steps.size(), 2u);
    EXPECT_THAT(series.separated, testing::ElementsAre(std::pair(0u, 1u)));
    EXPECT_EQ(series.steps.front().point, 0u);
    EXPECT_LE(series.readings(), 12);
    EXPECT_EQ(series.cost, series.readings());
    // One reading fewer is not enough.
    rig.readings = series.readings() - 1;
    EXPECT_TRUE(next_series(plans, rivals, points, noise, rig).steps.empty());

    // Measured so, b, which is right, fits better in P(z < sqrt(9.63)/2) = 94 % of cases at least,
    // the frictions fitted anew about what was known of them.
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    int right = 0;
    for (int study = 0; study < 1000; ++study) {
        const double friction = 0.3 + 0.01 * normal(random);
        const auto weigh = [](double misfit, double error) { return std::pow(misfit / error, 2); };
        double known = 1 / (0.01 * 0.01);
        std::array<double, 2> first{}, second{};  // sums of slope x misfit, of misfit^2; a, b
        for (const Series::Step& step : series.steps) {
            const double stress = points[step.point].condition.normal_stress;
            const double error = 0.01 * 0.303 * stress;
            for (int k = 0; k < step.readings; ++k) {
                const double y = friction * stress + 3 + error * normal(random);
                const std::array<double, 2> misfit = {y - 0.303 * stress, y - 3 - 0.3 * stress};
                known += weigh(stress, error);
                for (const std::size_t r : {0u, 1u}) {
                    first[r] += stress * misfit[r] / (error * error);
                    second[r] += weigh(misfit[r], error);
                }
            }
        }
        const auto left = [&](std::size_t r) { return second[r] - first[r] * first[r] / known; };
        right += left(1) < left(0);
    }
    EXPECT_GT(right, 939 - 3 * 8);
}

TEST(NextMeasurement, TakesNoSeriesWhereFrictionMakesUpForAll) {
    // What differs is a friction, and neither is known: any number of points says the same.
    const Offset plain(0);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 0.01),
                                             rival("b", plain, 0.3, 0.01)};
    EXPECT_TRUE(separating_series(rivals, at({100, 300, 1000, 3000}), noise, 20, 40).steps.empty());
}

TEST(NextMeasurement, SpendsNothingOnPairsThatStayTogether) {
    const Offset plain(0), same(0), with_offset(3);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 1e-4),
                                             rival("a again", same, 0.303, 1e-4),
                                             rival("b", with_offset, 0.3, 1e-4)};
    const Series series = separating_series(rivals, at({100, 300, 1000, 3000}), noise, 20, 40);
    EXPECT_THAT(series.separated,
                testing::UnorderedElementsAre(std::pair(0u, 2u), std::pair(1u, 2u)));
    EXPECT_EQ(series.readings(), 1);
}

/// A direct measurement of a friction that is 0.25 where it is not fitted.
Point sled(double standard_error, double cost) {
    return {.direct = DirectMeasurement{.parameter = "friction",
                                        .unit = "1",
                                        .neutral = 0.25,
                                        .standard_error = standard_error},
            .cost = cost};
}

TEST(NextMeasurement, IsADirectOneWhereThatTellsMore) {
    // Alike in every reading; but one has the friction as its parameter.
    const Offset has("friction"), has_not("wall.slip");
    const std::vector<FittedModel> rivals = {rival("a", has, 0.3, 0.01),
                                             rival("b", has_not, 0.3, 0.01)};
    auto points = at({100, 1000});
    points.push_back(sled(0.02, 1));
    const auto plans = separating_plans(rivals, points, noise, 20);
    ASSERT_EQ(plans.front().point, 2u);
    // 0.05 apart with the parameter's 0.01 and 0.02/sqrt(n): n = 2 is 0.0025/0.0003 = 8.3.
    EXPECT_EQ(plans.front().repeats, 2);
    EXPECT_TRUE(plans.back().separated.empty());
    EXPECT_EQ(plans.front().forecasts[0].value.size(), 1);
    EXPECT_DOUBLE_EQ(plans.front().forecasts[0].value(0), 0.3);
    EXPECT_DOUBLE_EQ(plans.front().forecasts[1].value(0), 0.25);
    EXPECT_DOUBLE_EQ(plans.front().forecasts[1].from_parameters(0, 0), 0);
    // Too coarse, it tells nothing.
    points.back() = sled(0.5, 1);
    EXPECT_TRUE(separating_plans(rivals, points, noise, 20).front().separated.empty());
}

TEST(NextMeasurement, TakesADirectOneAmongSeveral) {
    // One fits an offset of 3 Pa with 0.3 of friction, the other 0.303 without: what is known of
    // the friction to 3 % only. Neither a reading nor the sled tells alone, both together do.
    const Offset plain(0), with_offset(3);
    const std::vector<FittedModel> rivals = {rival("a", plain, 0.303, 0.01),
                                             rival("b", with_offset, 0.3, 0.01)};
    auto points = at({300});
    points.push_back(sled(1e-4, 0.1));
    ASSERT_TRUE(separating_plans(rivals, at({300}), noise, 20).front().separated.empty());
    const Rig rig{.repeats = 20, .readings = 12};
    const auto plans = separating_plans(rivals, points, noise, rig.repeats);
    EXPECT_TRUE(plans.front().separated.empty());
    const Series series = next_series(plans, rivals, points, noise, rig);
    ASSERT_EQ(series.steps.size(), 2u);
    EXPECT_EQ(series.steps[1].point, 1u);
    EXPECT_EQ(series.separated.size(), 1u);
}

TEST(NextMeasurement, WeighsTheWait) {
    const Study study;
    Rig rig{.normal_stress = {100, 100},
            .inertial_number = Span{0.01, 0.01},
            .waits = {0, 7200},
            .hour_cost = 0.5};
    const auto points = points_of(rig, study, 60);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].condition.time, 60);
    EXPECT_EQ(points[1].condition.time, 7260);
    const Offset plain(0), with_offset(3);
    const auto plans = separating_plans(
        {rival("a", plain, 0.303, 1e-4), rival("b", with_offset, 0.3, 1e-4)}, points, noise, 10);
    EXPECT_EQ(plans[0].point, 0u);
    EXPECT_EQ(plans[1].cost, plans[0].cost + 1);
}

std::string text_of(const NextMeasurement& next) {
    std::string text;
    for (const std::string& line : plan_lines(next)) {
        text += line + "\n";
    }
    return text;
}

TEST(NextMeasurement, SaysWhatToMeasureDirectly) {
    const Offset has("friction"), has_not("wall.slip");
    const Study study{.grains = {.diameter = 5e-4, .density = 1000}};
    NextMeasurement next{.study = study,
                         .rivals = {rival("a", has, 0.3, 0.01), rival("b", has_not, 0.3, 0.01)},
                         .points = at({100, 1000}),
                         .plans = {},
                         .sharpenings = {},
                         .most_repeats = 20,
                         .most_readings = 12};
    next.points.push_back(sled(0.02, 1));
    next.points.back().direct->by = "a sled";
    const Rig rig{.repeats = 20, .readings = 12};
    next.plans = separating_plans(next.rivals, next.points, noise, rig.repeats);
    next.series = next_series(next.plans, next.rivals, next.points, noise, rig);
    expect_told({text_of(next)});
    const auto json = to_json(next);
    EXPECT_EQ(json.at("point").at("direct"), "friction");
    EXPECT_EQ(json.at("forecasts").at(1).at("direct").at("value"), 0.25);
    // Drawn are readings, of which none is to be made.
    expect_told({next_figure(next).title});
    next.points.erase(next.points.begin(), next.points.begin() + 2);
    next.plans = separating_plans(next.rivals, next.points, noise, rig.repeats);
    next.series = next_series(next.plans, next.rivals, next.points, noise, rig);
    EXPECT_TRUE(next_figure(next).panels.empty());
}

TEST(NextMeasurement, ShowsTheMostTellingPointWhereNoneTells) {
    const Offset plain(0), with_offset(3);
    const Study study{.grains = {.diameter = 5e-4, .density = 1000}};
    NextMeasurement next{
        .study = study,
        .rivals = {rival("a", plain, 0.303, 1e-6), rival("b", with_offset, 0.3, 1e-6)},
        .points = at({1000, 900}),
        .plans = {},
        .sharpenings = {},
        .most_repeats = 1,
        .most_readings = 1};
    next.points.push_back(sled(1, 0.1));  // cheap, and knows nothing
    next.points[1].wait = 7200;
    const Rig rig{.repeats = 1, .readings = 1};
    next.plans = separating_plans(next.rivals, next.points, noise, rig.repeats);
    next.series = next_series(next.plans, next.rivals, next.points, noise, rig);
    expect_told({text_of(next)});
    const auto json = to_json(next);
    EXPECT_EQ(json.at("point").at("wait"), 7200);
    EXPECT_EQ(json.at("others").size(), 2u);
    for (const auto& other : json.at("others"))
        EXPECT_NE(other.at("point"), json.at("point"));
}

TEST(NextMeasurement, SharpensAParameterByADirectOne) {
    const Offset model(0);
    auto points = at({1000});
    points.push_back(sled(0.003, 1));
    const auto plans = sharpening_plans(rival("a", model, 0.3, 0.003), points, noise, 1);
    const auto direct =
        std::ranges::find_if(plans, [](const Sharpening& each) { return each.point == 1; });
    EXPECT_NEAR(direct->standard_errors(0), 0.003 / std::sqrt(2.0), 1e-12);
}

TEST(NextMeasurement, SharpensAParameterAsMuchAsItSays) {
    const Offset model(0);
    const auto plans = sharpening_plans(rival("a", model, 0.3, 0.003), at({1000}), noise, 4);
    // 0.003 with 0.003/2 from four readings of 1 %.
    const double expected = 1 / std::sqrt(1 / (0.003 * 0.003) + 4 / (0.003 * 0.003));
    EXPECT_NEAR(plans.front().standard_errors(0), expected, 1e-9);
}

TEST(Rig, IsReadWithItsUnits) {
    const TemporaryFolder folder;
    const auto study = [&](const std::string& rig) {
        std::ofstream(folder.path() / "points.csv")
            << "normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number\n"
               "1000,300,0.6,0.01\n";
        std::ofstream(folder.path() / "study.toml")
            << "[grains]\ndiameter = \"500 um\"\ndensity = \"1000 kg/m^3\"\n[[readings]]\n"
               "file = \"points.csv\"\nliquid_content = 0.0\n[rig]\n"
            << rig;
        return read_study(folder.path());
    };
    const Study read = study(
        "normal_stress = [\"0.1 kPa\", \"5 kPa\"]\nshear_rate = \"2 1/s\"\n"
        "bead_mass = [\"30 g\", \"60 g\"]\nrepeats = 3\n");
    EXPECT_EQ(read.rig->normal_stress.least, 100);
    EXPECT_EQ(read.rig->shear_rate->greatest, 2);
    EXPECT_EQ(read.rig->repeats, 3);
    EXPECT_EQ(read.rig->readings, 12);
    EXPECT_NEAR(read.rig->bead_volumes.at(1), 6e-5, 1e-12);
    EXPECT_EQ(points_of(*read.rig, read, 0).size(), 2u * 7u);

    const Study direct = study(
        "normal_stress = \"1 kPa\"\ninertial_number = 0.01\nwait = [\"0 h\", \"2 h\"]\n"
        "[[rig.direct]]\neffect = \"polydispersity\"\nerror = 0.01\ncost = 2\n");
    EXPECT_EQ(direct.rig->waits, (std::vector<double>{0, 7200}));
    const auto points = points_of(*direct.rig, direct, 0);
    ASSERT_EQ(points.size(), 2u + 1u);
    EXPECT_EQ(points.back().direct->parameter, "polydispersity.deviation");
    EXPECT_EQ(points.back().direct->standard_error, 0.01);
    EXPECT_EQ(points.back().cost, 2);

    // An effect of the study whose direct measurement is stated needs no table of the rig.
    const std::string rig = "normal_stress = \"1 kPa\"\ninertial_number = 0.01\n";
    const std::string own =
        "[[effect]]\nname = \"peak\"\nparameter = \"rise\"\nunit = \"1\"\nlower = 0\nupper = 1\n"
        "stress_ratio = \"stress_ratio + rise\"\nmeasured_by = \"a tilted bed\"\n";
    const auto planned = [&](const std::string& text) {
        const Study with = study(text);
        return points_of(*with.rig, with, 0);
    };
    EXPECT_EQ(planned(rig + own).size(), 1u);
    const auto stated = planned(rig + own + "measured_to = \"2 %\"\n");
    ASSERT_EQ(stated.size(), 2u);
    EXPECT_EQ(stated.back().direct->parameter, "peak.rise");
    EXPECT_EQ(stated.back().direct->by, "a tilted bed");
    EXPECT_DOUBLE_EQ(stated.back().direct->standard_error, 0.02);
    EXPECT_EQ(stated.back().cost, 1);
    EXPECT_EQ(planned(rig + "[[rig.direct]]\neffect = \"peak\"\nerror = 0.1\ncost = 3\n" + own +
                      "measured_to = 0.02\n")
                  .back()
                  .cost,
              3);

    const auto refusal = [&](const std::string& rig_table) {
        try {
            study(rig_table);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    expect_told({refusal("inertial_number = 0.01\n"), refusal("normal_stress = \"1 kPa\"\n"),
                 refusal("normal_stress = \"1 mN\"\ninertial_number = 0.01\n"),
                 refusal("normal_stress = \"1 kPa\"\ninertial_number = 0.01\n"
                         "liquid_contents = [0, 0.03]\n"),
                 refusal("normal_stress = \"1 kPa\"\ninertial_number = 0.01\nreadings = 0\n"),
                 refusal("normal_stress = \"1 kPa\"\ninertial_number = 0.01\nrepeat = 3\n"),
                 refusal("normal_stress = \"1 kPa\"\ninertial_number = 0.01\nwait = \"-1 h\"\n"),
                 refusal("normal_stress = \"1 kPa\"\ninertial_number = 0.01\n"
                         "[[rig.direct]]\neffect = \"polydispersity\"\n"),
                 refusal("normal_stress = \"1 kPa\"\ninertial_number = 0.01\n"
                         "[[rig.direct]]\neffect = \"polydispersity\"\nerror = 0.1\ncost = 0\n")});
}

}  // namespace pendular::analysis_next_test
