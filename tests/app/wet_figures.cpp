// Figures of wet readings, from a planted study whose every number is known.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "analysis/misfit/compare.h"
#include "calib/fit/fit.h"
#include "calib/fit/parameter_errors.h"
#include "calib/fit/structural_cohesion.h"
#include "data/files/csv.h"
#include "reports/draw_figure.h"
#include "reports/misfit_figures.h"
#include "tests/support/app_support.h"
#include "tests/support/wet_study_support.h"

namespace reports_wet_test {

using namespace pendular;
using testing::ElementsAre;
using testing::IsEmpty;

/// A planted study, calibrated, with its model.
struct Planted {
    Calibration calibration;
    StudyModel model;

    explicit Planted(const std::vector<Reading>& readings = planted::readings())
        : calibration(planted::calibration(readings)), model(planted::study(), calibration) {}
    std::vector<Figure> figures() const { return wet_figures(model, calibration); }
};

std::vector<std::string> names(const std::vector<Figure>& figures) {
    std::vector<std::string> result;
    for (const auto& figure : figures) {
        result.push_back(figure.name);
    }
    return result;
}

/// Rows (x, y, error) of a drawn figure's CSV by the name of the curve.
std::map<std::string, std::vector<std::array<double, 3>>> numbers_of(const Figure& figure) {
    const TemporaryFolder folder;
    draw(figure, folder.path());
    const Table table = read_table(folder.path() / (figure.name + ".csv"));
    std::map<std::string, std::vector<std::array<double, 3>>> result;
    for (const Row& row : table.rows) {
        const auto number = [&](std::size_t cell) {
            const std::string& text = row.cells[cell].text;
            return text.empty() ? std::nan("") : std::stod(text);
        };
        if (row.cells[0].text == "1") {
            result[row.cells[1].text].push_back({number(2), number(3), number(4)});
        }
    }
    return result;
}

constexpr double content = 0.03;
const std::string of_content = "Φ_L/Φ_S = 0.03";

TEST(WetFigures, ExistWhereThereAreWetReadings) {
    const Planted wet;
    EXPECT_THAT(names(wet.figures()),
                ElementsAre("stress_ratio_wet", "solid_fraction_wet", "reduced_cohesion"));
    EXPECT_EQ(comparison_figures(wet.model, wet.calibration, compare(wet.calibration)).size(),
              10u);  // with qq, chi2_ledger and profile
    const Planted dry(planted::readings({}));
    EXPECT_THAT(dry.figures(), IsEmpty());
    EXPECT_EQ(comparison_figures(dry.model, dry.calibration, compare(dry.calibration)).size(), 7u);
}

/// Far from the minimum, where chi2 is no parabola, the curve has no kinks at its refits.
TEST(ProfileFigure, IsDrawnThroughValuesBetweenItsRefits) {
    const Planted study;
    const auto figures =
        comparison_figures(study.model, study.calibration, compare(study.calibration));
    const auto figure = std::ranges::find(figures, "profile", &Figure::name);
    ASSERT_NE(figure, figures.end());
    const Curve& profile = figure->panels.front().curves.front();
    const Calibration& c = study.calibration;
    const std::vector<Reading> fitted(c.readings.begin(),
                                      c.readings.begin() + static_cast<std::ptrdiff_t>(c.fitted));
    const ModelOfReadings model = study.model.at(fitted);
    Fit best = c.fit;
    best.prediction = model.predict(best.parameters);
    const Eigen::Map<const Eigen::VectorXd> drawn_at(profile.x.data(),
                                                     static_cast<Eigen::Index>(profile.x.size()));
    const Eigen::VectorXd exact = profile_rise(model, stack(fitted), best, 0, drawn_at);
    for (std::size_t n = 0; n < profile.x.size(); ++n) {
        const double rise = exact(static_cast<Eigen::Index>(n));
        EXPECT_NEAR(profile.y[n], rise, 0.01 + 0.005 * std::abs(rise)) << profile.x[n];
    }
}

TEST(ResidualMap, IsDrawnWhereReadingsDifferInInertialNumber) {
    Comparison comparison = compare(Planted().calibration);
    EXPECT_THAT(names(residual_figures(comparison)), ElementsAre("residuals"));
    comparison.by_condition.front().condition.inertial_number *= 10;
    EXPECT_THAT(names(residual_figures(comparison)), ElementsAre("residuals", "residual_map"));
}

TEST(WetFigures, ShowReadingsAndModelOverTheInverseReducedPressure) {
    const Planted study;
    const auto figures = study.figures();
    for (const int o : {0, 1}) {
        const auto numbers = numbers_of(figures[static_cast<std::size_t>(o)]);
        const auto& measured = numbers.at("measured, " + of_content);
        const auto& simulated = numbers.at("simulated, " + of_content);
        ASSERT_EQ(measured.size(), planted::pressures.size());
        std::size_t row = 0;
        for (std::size_t k = 0; k < study.calibration.readings.size(); ++k) {
            const Reading& r = study.calibration.readings[k];
            if (r.condition.liquid_content != content) {
                continue;
            }
            const double scale = o == 0 ? r.condition.normal_stress : 1;
            const auto i = static_cast<Eigen::Index>(2 * k) + o;
            EXPECT_NEAR(measured[row][0], 1 / planted::pressures[row], 1e-9);
            EXPECT_NEAR(measured[row][1], r.value(o) / scale, 1e-9);
            EXPECT_NEAR(measured[row][2], std::sqrt(r.covariance(o, o)) / scale, 1e-9);
            EXPECT_NEAR(simulated[row][1], study.calibration.prediction.value(i) / scale, 1e-9);
            EXPECT_NEAR(simulated[row][2],
                        std::sqrt(study.calibration.prediction.covariance(i, i)) / scale, 1e-9);
            ++row;
        }
        // The curve passes through the simulated points: both are the model.
        const auto& curve = numbers.at("model, " + of_content);
        const auto last = std::ranges::max(curve, {}, [](const auto& p) { return p[0]; });
        EXPECT_NEAR(last[0], simulated.front()[0], 1e-9);
        EXPECT_NEAR(last[1], simulated.front()[1], 1e-9);
        EXPECT_NEAR(curve[59][2], simulated.front()[2], 1e-9);
    }
}

TEST(WetFigures, DrawTheCohesionLinesOnBelowWhereTheyWereFitted) {
    const Planted study;
    const Figure figure = study.figures().front();
    const auto numbers = numbers_of(figure);
    const Calibration& c = study.calibration;
    const auto line = std::ranges::find_if(c.cohesion_lines, [](const CohesionLine& l) {
        return l.source == "measured" && std::abs(l.liquid_content - content) < 1e-6;
    });
    ASSERT_NE(line, c.cohesion_lines.end());
    const auto& drawn = numbers.at("cohesion line, measured, " + of_content);
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_EQ(drawn[0][0], 0);
    EXPECT_NEAR(drawn[0][1], line->stress_ratio_intercept.value, 1e-12);
    EXPECT_GT(drawn[1][0], 1 / planted::pressures.front());
    EXPECT_NEAR((drawn[1][1] - drawn[0][1]) / drawn[1][0], line->reduced_cohesion.value, 1e-9);
    EXPECT_TRUE(numbers.contains("cohesion line, simulated, " + of_content));
    ASSERT_EQ(figure.panels.front().references.size(), 1u);
    EXPECT_NEAR(figure.panels.front().references.front().value, 1 / 2.3, 1e-12);
}

TEST(WetFigures, ShowTheCohesionOfLinesAndOfTheStructure) {
    const Planted study;
    const auto numbers = numbers_of(study.figures().back());
    const Calibration& c = study.calibration;
    EXPECT_EQ(c.cohesion_lines.size(), 2 * planted::contents.size());
    for (const auto& line : c.cohesion_lines) {
        const auto& rows =
            numbers.at(line.source == "measured"
                           ? "cohesion line through readings at P* ≥ 2.3, ± 1 standard error"
                           : "cohesion line through the simulations");
        ASSERT_EQ(rows.size(), planted::contents.size());
        const auto row = std::ranges::find_if(rows, [&](const auto& each) {
            return std::abs(each[0] - line.liquid_content) < 1e-12;
        });
        ASSERT_NE(row, rows.end());
        EXPECT_NEAR((*row)[1], line.reduced_cohesion.value, 1e-12);
        EXPECT_NEAR((*row)[2], line.reduced_cohesion.standard_error, 1e-12);
    }
    const auto rumpf = std::ranges::find_if(
        numbers, [](const auto& curve) { return curve.first.find("Rumpf") != std::string::npos; });
    ASSERT_NE(rumpf, numbers.end());
    const auto structural = structural_cohesions(study.model, c);
    ASSERT_EQ(rumpf->second.size(), planted::contents.size());
    for (std::size_t k = 0; k < planted::contents.size(); ++k) {
        EXPECT_NEAR(rumpf->second[k][0], planted::contents[k], 1e-12);
        EXPECT_NEAR(rumpf->second[k][1], structural[k].rumpf.value, 1e-12);
    }
}

TEST(WetFigures, FollowTheLimitOfTheCohesionLines) {
    const CohesionOptions from_four{.lowest_reduced_pressure = 4};
    const Calibration c = planted::calibration(planted::readings({content}), from_four);
    const StudyModel model(planted::study(), c);
    const auto figures = wet_figures(model, c, from_four);
    const Panel& panel = figures.front().panels.front();
    EXPECT_NEAR(panel.references.front().value, 0.25, 1e-12);
    EXPECT_TRUE(std::ranges::any_of(panel.curves, [](const Curve& curve) {
        return curve.in_key && curve.label.find("P* ≥ 4") != std::string::npos;
    }));
    const double from_4 = structural_cohesions(model, c, from_four)[0].rumpf.value;
    EXPECT_NEAR(numbers_of(figures.back()).at("μ*_0Φ_SZ*/π (Rumpf)")[0][1], from_4, 1e-12);
    EXPECT_GT(from_4, structural_cohesions(model, c)[0].rumpf.value);
}

TEST(WetFigures, ShowEveryReadingOnceAtOneInertialNumber) {
    auto readings = planted::readings({content});
    std::mt19937_64 random(8);
    for (const double pressure : planted::pressures) {
        readings.push_back(planted::reading(pressure, content, random, 0.03));
    }
    const Planted study(readings);
    for (const auto& figure : study.figures()) {
        expect_told({figure.title});
    }
    const auto numbers = numbers_of(study.figures().front());
    EXPECT_EQ(numbers.at("measured, " + of_content).size(), 2 * planted::pressures.size());
}

TEST(WetFigures, SayNothingOfCohesionBelowWhereItIsDefined) {
    std::mt19937_64 random(8);
    auto readings = planted::readings({});
    readings.push_back(planted::reading(0.8, content, random));
    readings.push_back(planted::reading(1.5, content, random));
    const Planted study(readings);
    EXPECT_THAT(names(study.figures()), ElementsAre("stress_ratio_wet", "solid_fraction_wet"));
    const auto numbers = numbers_of(study.figures().front());
    for (const auto& [name, rows] : numbers) {
        EXPECT_EQ(name.find("cohesion line"), std::string::npos) << name;
    }
}

TEST(StructuralCohesion, IsThatOfThePlantedStructure) {
    const Planted study;
    const auto found = structural_cohesions(study.model, study.calibration);
    ASSERT_EQ(found.size(), planted::contents.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        const double volume = planted::volume_of(planted::contents[k]);
        double solid_fraction = 0;  // mean over the pressures from 2.3 on
        for (const double pressure : {2.3, 4.0, 8.0, 16.0}) {
            solid_fraction += planted::solid_fraction(planted::friction, 1 / pressure) / 4;
        }
        const double rumpf = planted::dry_ratio(planted::friction) * solid_fraction *
                             planted::effective_coordination(planted::friction, volume) /
                             std::numbers::pi;
        // The law is straight in ln(friction + 0.05), the emulator's polynomials in
        // ln(friction + 0.02).
        EXPECT_NEAR(found[k].rumpf.value, rumpf, 2e-4);
        EXPECT_NEAR(found[k].generalised.value,
                    rumpf - planted::capillary_shear_stress(planted::friction, volume), 2e-4);
    }
}

TEST(StructuralCohesion, CarriesTheErrorOfTheFriction) {
    Planted study;
    Calibration& c = study.calibration;
    const auto found = [&](double friction, double error) {
        c.fit.parameters(0) = friction;
        c.fit.covariance(0, 0) = error * error;
        return structural_cohesions(study.model, c).front();
    };
    // What the friction adds to the variance is the slope of the values themselves.
    constexpr double error = 0.01, step = 1e-4;
    const auto higher = found(planted::friction + step, 0),
               lower = found(planted::friction - step, 0), without = found(planted::friction, 0),
               with = found(planted::friction, error);
    for (const auto which : {&StructuralCohesion::rumpf, &StructuralCohesion::generalised}) {
        const double slope = ((higher.*which).value - (lower.*which).value) / (2 * step);
        const double added = std::pow((with.*which).standard_error, 2) -
                             std::pow((without.*which).standard_error, 2);
        EXPECT_NEAR(std::sqrt(added), error * std::abs(slope), 1e-4 * error * std::abs(slope));
        EXPECT_GT((without.*which).standard_error, 0);  // the runs' noise
    }
}

}  // namespace reports_wet_test
