#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibrate_study.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/failure_report.h"
#include "reports/misfit_figures.h"
#include "reports/tables.h"
#include "sim/runs/run_request.h"
#include "tests/support/app_support.h"
#include "tests/support/wet_study_support.h"
#include "workflow/json/diagnosis.h"
#include "workflow/json/fit.h"
#include "workflow/json/run.h"

namespace reports_test {

using namespace pendular;
using testing::HasSubstr;

Reading reading(double normal_stress, double inertial_number, double ratio, double fraction) {
    Reading r;
    r.origin = {"points.csv", 3};
    r.condition = {.normal_stress = normal_stress, .inertial_number = inertial_number};
    r.value << ratio * normal_stress, fraction;
    const double error = 0.02 * ratio * normal_stress;
    r.covariance << error * error, 0.3 * error * 0.002, 0.3 * error * 0.002, 4e-6;
    return r;
}

/// Six readings of three conditions and a correlated prediction.
struct Example {
    std::vector<Reading> readings;
    Prediction prediction;

    Example() {
        for (const double stress : {500.0, 1000.0, 2000.0}) {
            readings.push_back(reading(stress, 0.003, 0.30, 0.612));
            readings.push_back(reading(1.005 * stress, 0.003, 0.28, 0.615));
        }
        const auto n = static_cast<Eigen::Index>(2 * readings.size());
        prediction.value.resize(n);
        prediction.jacobian = Eigen::MatrixXd::Ones(n, 1);
        Eigen::VectorXd shared(n);
        for (Eigen::Index k = 0; k < n / 2; ++k) {
            const double stress = readings[static_cast<std::size_t>(k)].condition.normal_stress;
            prediction.value.segment<2>(2 * k) << 0.29 * stress, 0.613;
            shared.segment<2>(2 * k) << 0.003 * stress, -0.0005;
        }
        prediction.covariance = shared * shared.transpose();
    }
};

TEST(Compare, SplitsChi2SoThatItsPartsAddUp) {
    const Example e;
    const Comparison c = compare(e.readings, e.prediction, 1, e.readings.size());
    const Measured measured = stack(e.readings);
    const Eigen::VectorXd misfit = measured.value - e.prediction.value;
    const double chi2 =
        misfit.dot((measured.covariance + e.prediction.covariance).inverse() * misfit);
    EXPECT_NEAR(c.total.chi2, chi2, 1e-9 * chi2);
    EXPECT_EQ(c.total.dof, 11);
    EXPECT_EQ(c.predicted.dof, 0);
    EXPECT_EQ(c.by_condition.size(), 3u);  // replicates share a condition
    double by_condition = 0, by_reading = 0;
    for (const auto& group : c.by_condition) {
        by_condition += group.chi2;
    }
    for (const auto& one : c.readings) {
        by_reading += one.chi2.sum();
    }
    EXPECT_NEAR(by_condition, chi2, 1e-9 * chi2);
    EXPECT_NEAR(by_reading, chi2, 1e-9 * chi2);
    EXPECT_NEAR(c.by_observable[0] + c.by_observable[1], chi2, 1e-9 * chi2);
    const double low = 0.29 / 0.30 - 1, high = 0.29 / 0.28 - 1;
    EXPECT_NEAR(c.rms_percent[0], 100 * std::sqrt((low * low + high * high) / 2), 1e-9);
}

TEST(Compare, SaysWhereTheModelFails) {
    Example e;
    for (std::size_t k = 0; k < e.readings.size(); ++k) {
        // The stress is off by a constant, which counts for more where it is low.
        e.readings[k].value(0) = e.prediction.value(static_cast<Eigen::Index>(2 * k)) + 30;
        e.readings[k].replicates = 2;
    }
    const std::vector<Parameter> friction = {{.name = "friction"}};
    const WhereItFails where = where_it_fails(e.readings, {}, e.prediction, friction);
    const auto trend = std::ranges::find_if(where.checks.all, [](const Check& check) {
        return check.kind == Check::Kind::trend && check.covariate == "normal stress" &&
               check.of == "shear stress";
    });
    ASSERT_NE(trend, where.checks.all.end());
    EXPECT_LT(trend->statistic, 0);
    EXPECT_LT(trend->p, 0.01);
    EXPECT_LT(where.checks.p, 0.05);
    expect_told(failure_table(where));
}

TEST(Compare, FindsAFailureOfAModelThatHoldsAsOftenAsItSays) {
    Example e;
    for (Reading& reading : e.readings) {
        reading.replicates = 2;
    }
    const Eigen::MatrixXd covariance = stack(e.readings).covariance + e.prediction.covariance;
    const Eigen::MatrixXd lower = covariance.llt().matrixL();
    std::mt19937_64 random(17);
    std::normal_distribution<double> normal;
    int failures = 0, offending = 0;
    for (int study = 0; study < 100; ++study) {
        const Eigen::VectorXd value =
            e.prediction.value +
            lower * Eigen::VectorXd::NullaryExpr(lower.rows(), [&] { return normal(random); });
        for (std::size_t k = 0; k < e.readings.size(); ++k) {
            e.readings[k].value = value.segment<2>(static_cast<Eigen::Index>(2 * k));
        }
        const WhereItFails where =
            where_it_fails(e.readings, {}, e.prediction, {{.name = "friction"}}, {}, 100 + study);
        failures += where.checks.p < 0.05;
        offending += !where.offending.empty();
    }
    // 5 each; 99 % of binomial scatter is below 12.
    EXPECT_GE(failures, 1);
    EXPECT_LE(failures, 11);
    EXPECT_LE(offending, 11);
}

TEST(Compare, NamesTheFileThatIsOff) {
    Example e;
    for (std::size_t k = 0; k < e.readings.size(); ++k) {
        e.readings[k].value = e.prediction.value.segment<2>(static_cast<Eigen::Index>(2 * k));
        e.readings[k].origin.file = k % 2 == 0 ? "first.csv" : "second.csv";
        e.readings[k].value(0) *= k % 2 == 0 ? 1.15 : 1.0;
    }
    const WhereItFails where = where_it_fails(e.readings, {}, e.prediction, {{.name = "friction"}});
    ASSERT_FALSE(where.offending.empty());
    expect_told({where.offending.front().readings});
    const Comparison c = compare(e.readings, e.prediction, 1, e.readings.size());
    ASSERT_EQ(c.by_file.size(), 2u);
    EXPECT_EQ(c.by_file[0].readings, 3u);
    EXPECT_NEAR(c.by_file[0].chi2 + c.by_file[1].chi2, c.total.chi2, 1e-9 * c.total.chi2);
}

TEST(Json, GivesARunBackAsItWas) {
    auto run = simulate({.friction = 0.2,
                         .inertial_number = 0.05,
                         .stiffness_number = 300,
                         .grains = 100,
                         .strain = 1,
                         .seed = 5,
                         .precision = {{dem::Observable::solid_fraction, 1e-9}}});
    run.parameters.effects = {{"polydispersity", {0.1}}, {"rolling-resistance", {0.2}}};
    const auto back = run_from_json(nlohmann::ordered_json::parse(to_json(run).dump()));
    EXPECT_EQ(back.parameters.effects, run.parameters.effects);
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        EXPECT_EQ(back.means[k].value, run.means[k].value);
        EXPECT_EQ(back.means[k].standard_error, run.means[k].standard_error);
    }
    EXPECT_EQ(back.covariance, run.covariance);
    EXPECT_EQ(back.parameters.seed, 5u);
    ASSERT_EQ(back.parameters.precision.size(), 1u);
    EXPECT_EQ(back.parameters.precision[0].which, dem::Observable::solid_fraction);
    EXPECT_EQ(back.parameters.precision[0].standard_error, 1e-9);
    EXPECT_FALSE(back.precise);
    EXPECT_EQ(back.steps, run.steps);
    EXPECT_EQ(back.crystallised, run.crystallised);
}

Study study() {
    Study s;
    s.grains = {.diameter = 5e-4, .density = 1050};
    return s;
}

Calibration small_calibration() {
    Measurements m;
    m.readings = {reading(500, 0.05, 0.36, 0.60), reading(1000, 0.05, 0.36, 0.60)};
    return calibrate_study(study(), m, {.fidelity = {"tiny", 100, 300, 0.03, 1}, .seed = 2},
                           {.threads = 2});
}

TEST(FitFile, IsReadBackForTheSameReadingsOnly) {
    const TemporaryFolder folder;
    const Calibration c = small_calibration();
    const auto file = folder.path() / "fit.json";
    write_calibration(folder.path(), c, compare(c), {});
    const Calibration back = read_calibration(file, study(), c.readings);
    EXPECT_EQ(back.fit.parameters(0), c.fit.parameters(0));
    EXPECT_EQ(back.runs.size(), c.runs.size());
    const Prediction again = predict_readings(StudyModel(study(), back).model(), back);
    EXPECT_LT((again.value - c.fit.prediction.value).norm(), 1e-9 * again.value.norm());

    Study inexact = study();
    inexact.model.discrepancy = usual_discrepancy;
    EXPECT_THROW(read_calibration(file, inexact, c.readings), InputError);
    Calibration more = c;
    more.model = inexact.model;
    more.fit.inexactness = 2;
    more.fit.discrepancy_part = 0.1 * c.fit.covariance;
    write_calibration(folder.path(), more, compare(more), {});
    const Fit reread = read_calibration(file, inexact, c.readings).fit;
    EXPECT_EQ(reread.inexactness, 2);
    EXPECT_NEAR(reread.standard_error(0), std::sqrt(1.3) * c.fit.standard_error(0),
                1e-9 * c.fit.standard_error(0));
    EXPECT_NEAR(reread.discrepancy_error(0), more.fit.discrepancy_error(0), 1e-12);
    write_calibration(folder.path(), c, compare(c), {});

    auto others = c.readings;
    others[0].value(0) *= 1.01;
    EXPECT_THROW(read_calibration(file, study(), others), InputError);
    Study stiffer = study();
    stiffer.grains.youngs_modulus = 3e9;
    EXPECT_THROW(read_calibration(file, stiffer, c.readings), InputError);
    Study sieved = study();
    sieved.direct = {{.effect = "polydispersity", .value = "0.02", .error = "0.01"}};
    EXPECT_THROW(read_calibration(file, sieved, c.readings), InputError);
    EXPECT_THROW(read_calibration(folder.path() / "none.json", study(), c.readings), InputError);
    folder.write("cut.json", content_of(file).substr(0, 200));
    EXPECT_THROW(read_calibration(folder.path() / "cut.json", study(), c.readings), InputError);
}

TEST(FitFile, NamesItsRunsWhichStandBesideIt) {
    const TemporaryFolder folder;
    const Calibration c = small_calibration();
    const auto file = folder.path() / "fit.json", runs = folder.path() / "fit_runs.csv";
    write_calibration(folder.path(), c, compare(c), {});
    const auto json = nlohmann::ordered_json::parse(content_of(file));
    EXPECT_EQ(json["runs"]["number"], c.runs.size());
    EXPECT_EQ(json["runs"]["names"].get<std::string>().size(), 17 * c.runs.size() - 1);
    const Calibration back = read_calibration(file, study(), c.readings);
    const auto predicted = [](const Calibration& by) {
        return predict_readings(StudyModel(study(), by).model(), by);
    };
    // Bit for bit: the same runs in the same order.
    EXPECT_EQ(predicted(back).value, predicted(c).value);
    EXPECT_EQ(predicted(back).covariance, predicted(c).covariance);

    // Versions before --runs-of wrote a list of the names, those without formats whole runs.
    auto older = json;
    older["runs"] = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < c.runs.size(); ++k) {
        older["runs"].push_back(json["runs"]["names"].get<std::string>().substr(17 * k, 16));
    }
    folder.write("listed.json", older.dump());
    EXPECT_EQ(predicted(read_calibration(folder.path() / "listed.json", study(), c.readings)).value,
              predicted(c).value);
    older["runs"] = nlohmann::ordered_json::array();
    for (const auto& run : c.runs) {
        older["runs"].push_back(to_json(run));
    }
    folder.write("older.json", older.dump());
    const Calibration of_older =
        read_calibration(folder.path() / "older.json", study(), c.readings);
    EXPECT_EQ(predicted(of_older).value, predicted(c).value);

    std::filesystem::remove(runs);
    expect_told({input_error([&] { read_calibration(file, study(), c.readings); })});
    older["format"] = 7;
    folder.write("newer.json", older.dump());
    expect_told({input_error(
        [&] { read_calibration(folder.path() / "newer.json", study(), c.readings); })});
}

TEST(FitFile, HoldsWetReadingsAndCohesionLines) {
    const Calibration c = planted::calibration(planted::readings());
    const Comparison comparison = compare(c);
    const auto json = to_json(c, comparison, {});
    EXPECT_EQ(json["dof"], comparison.fitted.dof);
    EXPECT_EQ(json["predicted_only"]["dof"], 2 * static_cast<int>(c.readings.size() - c.fitted));
    EXPECT_EQ(json["predictions"].size(), c.readings.size());
    EXPECT_EQ(json["predictions"].front()["fitted"], true);
    EXPECT_EQ(json["predictions"].back()["fitted"], false);
    ASSERT_EQ(json["cohesion_lines"].size(), 2 * planted::contents.size());
    const auto& line = json["cohesion_lines"][0];
    EXPECT_EQ(line["source"], "measured");
    EXPECT_GT(line["reduced_cohesion"]["stderr"], 0);
    EXPECT_GT(line["stress_ratio_intercept"]["value"], 0.2);
    // Total, fitted and predicted of compare add up.
    const auto compared = to_json(comparison, c.cohesion_lines, {});
    EXPECT_NEAR(
        compared["chi2"].get<double>(),
        compared["fitted"]["chi2"].get<double>() + compared["predicted_only"]["chi2"].get<double>(),
        1e-9);

    const TemporaryFolder folder;
    const auto file = folder.path() / "fit.json";
    write_calibration(folder.path(), c, comparison, {});
    const Calibration back = read_calibration(file, planted::study(), c.readings);
    EXPECT_EQ(back.fitted, c.fitted);
    const Prediction again = predict_readings(StudyModel(planted::study(), back).model(), back);
    EXPECT_LT((again.value - c.prediction.value).norm(), 1e-9 * again.value.norm());
    // Another liquid, another base, another bridge force: not this fit any more.
    for (const auto change : {0, 1, 2}) {
        Study other = planted::study();
        if (change == 0) other.liquid->surface_tension *= 1.1;
        if (change == 1) other.model.base = "rumpf";
        if (change == 2) other.model.bridge_force = FormulaVariant::as_printed;
        EXPECT_THROW(read_calibration(file, other, c.readings), InputError) << change;
    }
}

TEST(Figures, AreDrawnInEveryFormatWithTheirNumbers) {
    const TemporaryFolder folder;
    const Calibration c = small_calibration();
    const Comparison comparison = compare(c);
    const auto figures = comparison_figures(StudyModel(study(), c), c, comparison);
    std::vector<std::string> names;
    for (const Figure& figure : figures) {
        names.push_back(figure.name);
    }
    // No residual_map, as there is one inertial number; no qq, as there are too few readings; no
    // corner, as there is one parameter.
    ASSERT_THAT(names, testing::ElementsAre("calibration", "inertial_number", "parity", "residuals",
                                            "chi2_ledger", "profile"));
    for (const Curve& curve : figures.back().panels.at(0).curves) {
        EXPECT_LE(std::ranges::max(curve.y), 9.001) << "behind the key: " << curve.label;
    }
    for (const auto& figure : figures) {
        draw(figure, folder.path());
        for (const std::string extension : {".svg", ".png", ".pdf", ".csv"}) {
            EXPECT_GT(std::filesystem::file_size(folder.path() / (figure.name + extension)), 200u)
                << figure.name;
        }
    }
    EXPECT_THAT(content_of(folder.path() / "calibration.csv"),
                HasSubstr("panel,curve,x,y,y_error"));
    EXPECT_THAT(content_of(folder.path() / "calibration.svg"), HasSubstr("intergranular friction"));
}

TEST(Figures, SayWhenNothingCouldBeDrawn) {
    Figure figure{
        .name = "missing/folder/name", .title = "", .panels = {{.x_label = "x", .y_label = "y"}}};
    EXPECT_THROW(draw(figure, "/proc/pendular"), std::exception);
}

TEST(Tables, SayOnceHowFarReplicatesAreFromACohesionLine) {
    const CohesionLine line{
        .source = "measured",
        .liquid_content = 0.03,
        .inertial_number = 0.003,
        .below = {{1.401, {0.06, 0.02}}, {1.399, {0.08, 0.02}}, {0.7, {0.3, 0.02}}}};
    const auto table = cohesion_table({line});
    EXPECT_EQ(
        std::ranges::count_if(
            table,
            [](const auto& row) { return row.find("gives a stress ratio") != std::string::npos; }),
        1);
    EXPECT_TRUE(table.back().ends_with(
        "7.0 +- 2.0 % too high at P* = 1.4, 30.0 +- 2.0 % too high at P* = 0.7."))
        << table.back();
}

TEST(Tables, SayWhyAPValueIsLargerThanThatOfChi2) {
    const Misfit known{.chi2 = 56, .dof = 11}, estimated{.chi2 = 56, .dof = 11, .freedom = 2};
    ASSERT_LT(known.p(), 1e-3);
    ASSERT_GT(estimated.p(), 1e-3);
    EXPECT_EQ(misfit_text(known), "chi2 = 56.0 for 11 degrees of freedom (p < 0.001)");
    const Misfit many{.chi2 = 12, .dof = 11, .freedom = 40};
    expect_told({misfit_text(estimated), misfit_text(many)});
}

TEST(Tables, NameEveryReadingAndUnit) {
    const Example e;
    expect_told(predictions_table(compare(e.readings, e.prediction, 1, e.readings.size())));
}

}  // namespace reports_test
