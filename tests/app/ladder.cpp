// A study's ladder: leave-one-condition-out errors against closed answers, the file that keeps the
// ladder steps, and the figure.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/ladder.h"
#include "reports/draw_figure.h"
#include "reports/layout.h"
#include "reports/misfit_figures.h"
#include "tests/support/app_support.h"
#include "tests/support/known_flow.h"
#include "workflow/json/fit.h"

namespace analysis_ladder_test {

using namespace pendular;
using testing::HasSubstr;

/// Both observables are the polynomial sum_j theta_j x^j of the normal stress x.
class Polynomial : public KnownFlow {
  public:
    explicit Polynomial(std::size_t terms) : KnownFlow(coefficients(terms)) {}
    Prediction predict(const Eigen::VectorXd& p, const std::vector<Condition>& conditions,
                       PredictionPart /*what*/) const override {
        const auto n = 2 * static_cast<Eigen::Index>(conditions.size());
        Eigen::MatrixXd a(n, p.size());
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < p.size(); ++j) {
                a(i, j) = std::pow(conditions[static_cast<std::size_t>(i / 2)].normal_stress, j);
            }
        }
        return {a * p, a, Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
    }

  private:
    static std::vector<Parameter> coefficients(std::size_t terms) {
        std::vector<Parameter> all;
        for (std::size_t k = 0; k < terms; ++k) {
            all.push_back({.name = fmt::format("p{}", k), .lower = -1e6, .upper = 1e6, .start = 0});
        }
        return all;
    }
};

Reading reading(double x, double y) {
    Reading r;
    r.condition = {.normal_stress = x, .inertial_number = 0.01};
    r.value << y, y;
    r.covariance = Eigen::Matrix2d::Identity();
    return r;
}

/// The fit of a model to the first `count` readings, or to all.
Calibration fitted_to(const Polynomial& model, const std::vector<Reading>& readings,
                      std::size_t count = 1000) {
    Calibration c{.readings = readings};
    c.fitted = std::min(count, readings.size());
    c.parameters = model.parameters();
    const std::vector<Reading> seen(readings.begin(),
                                    readings.begin() + static_cast<std::ptrdiff_t>(c.fitted));
    const ModelOfReadings at(std::make_shared<Polynomial>(model), conditions_of(seen));
    c.fit = fit(at, stack(seen), start_of(at));
    return c;
}

LadderStep ladder_step(const std::string& change, const std::string& effect, double chi2,
                       double stress, double fraction) {
    LadderStep r{.change = change, .effect = effect};
    r.effects = effect.empty() ? std::vector<std::string>{} : std::vector<std::string>{effect};
    r.parameters = {{"friction", "1", 0.09, 0.004}, {"torque-offset.torque", "N m", 1e-3, 1e-4}};
    r.chi2 = chi2;
    r.dof = 40;
    r.rms_percent = {stress, fraction};
    r.left_out_percent = {{1.2 * stress, 1.1 * fraction}};
    return r;
}

TEST(LeftOut, IsTheErrorOfTheMeanOfTheOthers) {
    // A constant fitted with equal weights is the mean. Conditions 1, 2 and 3 (a pair) hold 10, 12
    // and 20, 22. Without the first the mean is (12 + 20 + 22)/3 = 18, without the second
    // (10 + 20 + 22)/3 = 52/3, without the pair 11.
    const Polynomial model(1);
    const auto c =
        fitted_to(model, {reading(100, 10), reading(200, 12), reading(300, 20), reading(301, 22)});
    const auto result = left_out_errors(std::make_shared<Polynomial>(model), c);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->conditions, 3u);
    EXPECT_EQ(result->undetermined, 0u);
    const auto square = [](double predicted, double measured) {
        return std::pow(predicted / measured - 1, 2);
    };
    const double expected =
        100 *
        std::sqrt((square(18, 10) + square(52.0 / 3, 12) + square(11, 20) + square(11, 22)) / 4);
    EXPECT_NEAR(result->rms_percent[0], expected, 1e-6 * expected);
    EXPECT_NEAR(result->rms_percent[1], expected, 1e-6 * expected);
}

TEST(LeftOut, CountsReadingsThatAreOnlyPredictedAsTheyArePredicted) {
    // Fitted: 10 and 12, each predicted by the other; the third, 20, by their mean 11.
    const Polynomial model(1);
    const auto c = fitted_to(model, {reading(100, 10), reading(200, 12), reading(300, 20)}, 2);
    const double expected =
        100 * std::sqrt((std::pow(1.2 - 1, 2) + std::pow(10.0 / 12 - 1, 2) + 0.45 * 0.45) / 3);
    EXPECT_NEAR(left_out_errors(std::make_shared<Polynomial>(model), c)->rms_percent[0], expected,
                1e-6 * expected);
}

TEST(LeftOut, RisesWithAParameterThatFitsNoise) {
    // A straight line with 5 % noise at six places. A polynomial with five terms lowers the error
    // of the fit and raises that of what was left out.
    std::mt19937_64 random(4);
    std::normal_distribution<double> noise;
    std::vector<Reading> readings;
    for (int x = 1; x <= 6; ++x) {
        readings.push_back(reading(x, (10 + x) * (1 + 0.05 * noise(random))));
    }
    const Polynomial line(2), bent(5);
    const auto simple = fitted_to(line, readings), wild = fitted_to(bent, readings);
    EXPECT_LT(wild.fit.chi2, simple.fit.chi2);
    EXPECT_GT(left_out_errors(std::make_shared<Polynomial>(bent), wild)->rms_percent[0],
              1.5 * left_out_errors(std::make_shared<Polynomial>(line), simple)->rms_percent[0]);
}

TEST(LeftOut, TakesNothingFromTheConditionThatAloneDeterminesAParameter) {
    // p0 + p1 x through (0, 10) and (1, 20). Without the second, p1 stays where it starts, at 0,
    // and 10 is predicted for 20; from the optimum it would be 20 exactly. Without the first, only
    // the sum of both is determined; from 0 both reach 10, which is right by accident.
    const Polynomial model(2);
    const auto c = fitted_to(model, {reading(0, 10), reading(1, 20)});
    const auto result = left_out_errors(std::make_shared<Polynomial>(model), c);
    EXPECT_EQ(result->undetermined, 2u);
    EXPECT_NEAR(result->rms_percent[0], 100 * std::sqrt(0.25 / 2), 1e-3);
}

TEST(LeftOut, NeedsTwoConditions) {
    const Polynomial model(1);
    EXPECT_FALSE(left_out_errors(std::make_shared<Polynomial>(model),
                                 fitted_to(model, {reading(100, 10), reading(101, 12)})));
}

TEST(Ladder, IsReadBackAsItWasWritten) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "out" / "ladder.json";
    EXPECT_TRUE(read_ladder(file).empty());
    Ladder ladder;
    add_step(ladder, ladder_step("start", "", 400, 4.1, 0.3),
             ladder_step("add", "torque-offset", 44, 1, 0.28));
    ladder[0].left_out_percent.reset();
    ladder[0].parameters[0].standard_error = std::nan("");
    write_ladder(file, ladder);
    const Ladder back = read_ladder(file);
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ(back[0].change, "start");
    EXPECT_FALSE(back[0].left_out_percent);
    EXPECT_TRUE(std::isnan(back[0].parameters[0].standard_error));
    EXPECT_EQ(back[1].step, 1);
    EXPECT_EQ(back[1].effect, "torque-offset");
    EXPECT_EQ(back[1].effects, std::vector<std::string>{"torque-offset"});
    EXPECT_EQ(back[1].find("torque-offset.torque")->value, 1e-3);
    EXPECT_EQ(back[1].find("torque-offset.torque")->unit, "N m");
    EXPECT_EQ(back[1].find("no"), nullptr);
    EXPECT_EQ(back[1].rms_percent, ladder[1].rms_percent);
    EXPECT_EQ(back[1].left_out_percent, ladder[1].left_out_percent);
    const auto json = nlohmann::json::parse(content_of(file));
    EXPECT_EQ(json["ladder_steps"][1]["parameters"]["friction"]["stderr"], 0.004);
}

TEST(Ladder, BeginsAnewWhereTheStudyWasChangedOtherwise) {
    const auto after_with = [](const LadderStep& before) {
        Ladder ladder;
        add_step(ladder, ladder_step("start", "", 400, 4, 0.3),
                 ladder_step("add", "torque-offset", 44, 1, 0.3));
        add_step(ladder, before, ladder_step("drop", "torque-offset", 401, 4, 0.3));
        return ladder;
    };
    const LadderStep same =
        ladder_step("start", "torque-offset", 44.5, 1, 0.3);  // after fresh runs
    EXPECT_EQ(after_with(same).size(), 3u);
    LadderStep others = same, more = same, worse = same;
    others.effects.push_back("lid-slip");
    more.dof = 60;
    worse.chi2 = 80;
    for (const LadderStep& before : {others, more, worse}) {
        const Ladder ladder = after_with(before);
        ASSERT_EQ(ladder.size(), 4u);
        EXPECT_EQ(ladder[2].change, "start");
        EXPECT_EQ(ladder[3].step, 3);
    }
}

TEST(Ladder, RefusesAFileThatIsCutOrSomethingElse) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "ladder.json";
    Ladder ladder;
    add_step(ladder, ladder_step("start", "", 400, 4, 0.3),
             ladder_step("add", "torque-offset", 44, 1, 0.3));
    write_ladder(file, ladder);
    const std::string whole = content_of(file);
    auto strange = nlohmann::json::parse(whole);
    strange["ladder_steps"][1]["change"] = "fly";
    for (const std::string& broken :
         {whole.substr(0, whole.size() / 2), std::string(), std::string("[]"), std::string("{}"),
          std::string("null"), std::string("{\"rungs\": [{\"step\": \"one\"}]}"), strange.dump()}) {
        folder.write("ladder.json", broken);
        expect_told({input_error([&] { read_ladder(file); })});
        EXPECT_EQ(content_of(file), broken);  // nothing is lost
    }
}

TEST(Ladder, KnowsAFallByChance) {
    LadderStep before = ladder_step("start", "", 50, 1, 1), after = before;
    after.dof = before.dof - 1;
    after.chi2 = 47;  // 5 % of chi2 with one degree of freedom lie above 3.84
    EXPECT_EQ(reduction_of(before, after), Reduction::by_chance);
    after.chi2 = 46;
    EXPECT_EQ(reduction_of(before, after), Reduction::significant);
    after.dof = before.dof - 2;  // 5.99 with two
    EXPECT_EQ(reduction_of(before, after), Reduction::by_chance);
    // F(1, 40) at 5 % is 4.08: beside chi2/dof of 10, chi2 must fall by 41.
    before.dof = 41, before.chi2 = 439, after.dof = 40, after.chi2 = 400;
    EXPECT_EQ(reduction_of(before, after), Reduction::beside_misfit);
    before.chi2 = 443;
    EXPECT_EQ(reduction_of(before, after), Reduction::significant);
}

TEST(LadderFigure, ShowsEveryRung) {
    const TemporaryFolder folder;
    Ladder ladder = {ladder_step("start", "", 3900, 14.1, 1.9),
                     ladder_step("add", "torque-offset", 480, 4.6, 0.62),
                     ladder_step("add", "capillary-shear-stress", 300, 3.6, 0.60),
                     ladder_step("add", "normal-force-offset", 75, 1.6, 0.41),
                     ladder_step("start", "", 130, 1.7, 0.5),
                     ladder_step("add", "polydispersity", 72, 1.6, 0.35),
                     ladder_step("add", "lid-slip", 60, 1.55, 0.31),
                     ladder_step("drop", "torque-offset", 41, 1.5, 0.28)};
    const Figure figure = ladder_figure(ladder);
    for (const PanelPlace& place : page_of(figure).panels) {
        EXPECT_TRUE(place.log_y);
        EXPECT_GT(place.y.first, 0);
    }
    draw(figure, folder.path());
    for (const std::string extension : {".svg", ".png", ".pdf", ".csv"}) {
        EXPECT_GT(std::filesystem::file_size(folder.path() / fmt::format("ladder{}", extension)),
                  300u);
    }
    const std::string numbers = content_of(folder.path() / "ladder.csv");
    for (const char* part : {"1,model of the study,1,97.5,,start,,",
                             "1,model of the study,3,7.5,,'+ capillary-shear-stress,,",
                             "1,model of the study,8,1.025,,− torque-offset,,χ^2 per degree of "
                             "freedom\n",
                             "2,\"shear stress, fitted readings\",0.88,14.1,,start,,RMS error "
                             "[%]\n"}) {
        EXPECT_THAT(numbers, HasSubstr(part));
    }
    const std::string drawing = content_of(folder.path() / "ladder.svg");
    EXPECT_THAT(drawing, HasSubstr("normal-"));  // names are broken behind hyphens
    EXPECT_THAT(drawing, HasSubstr("polydispersity"));
    // A ladder step without left-out error, and one alone.
    ladder.resize(1);
    ladder[0].left_out_percent.reset();
    draw(ladder_figure(ladder), folder.path());
}

}  // namespace analysis_ladder_test
