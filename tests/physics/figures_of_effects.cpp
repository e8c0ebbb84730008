// What figures draw as the model is the fitted one: for every effect, readings that the emulator
// itself predicts with it on. Of each reading in a figure, measured less drawn is the residual of
// the fit, up to 0.3 standard errors: figures draw predictions as one where they differ by less
// than 0.25, and between two points of a curve there is a straight line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "calib/fit/predicted_readings.h"
#include "data/study/effect_tables.h"
#include "data/study/study_table.h"
#include "reports/misfit_figures.h"
#include "tests/support/effect_study.h"

namespace figures_of_effects_test {

using namespace pendular;

constexpr double tolerance = 0.3;  // standard errors

/// A study and what is on in it.
struct Case {
    std::string name;
    std::vector<std::string> effects;
    std::string base = "dem";
    std::string written = {};  ///< an [[effect]] table
    double normal_stress = 0;  ///< all dry readings are quasi-static at this one; 0: as measured
};

void PrintTo(const Case& one, std::ostream* out) {
    *out << one.name;
}

std::vector<Case> cases() {
    std::vector<Case> all = {{"plain", {}}, {"rumpf", {}, "rumpf"}};
    for (const Effect& effect : built_in_effects()) {
        const std::string base = !effect.of_closure()                           ? "dem"
                                 : *effect.level() > closures::Level::strength3 ? "rumpf"
                                                                                : "mohr-coulomb";
        all.push_back({effect.name, {effect.name}, base});
    }
    all.push_back({"torque-offset and wall-friction", {"torque-offset", "wall-friction"}});
    all.push_back({"rumpf with contact-angle", {"contact-angle"}, "rumpf"});
    all.push_back({"lid-slip and polydispersity", {"lid-slip", "polydispersity"}});
    all.push_back({"quasi-static wall-friction", {"wall-friction"}, "dem", "", 1000});
    const std::string table =
        "[[effect]]\nname = \"mine\"\nparameter = \"x\"\nlower = -2\nupper = 2\nmatters = 0.1\n";
    all.push_back({"drift", {"mine"}, "dem", table + "torque = \"torque + x*2e-6*time\"\n"});
    all.push_back(
        {"trend",
         {"mine"},
         "dem",
         table + "stress_ratio = \"stress_ratio*(1 + x*0.1*log(normal_stress/1000))\"\n"});
    return all;
}

/// Readings of two files: the second has half the beads and comes an hour later. One table, where
/// the study has no cell.
std::vector<Condition> conditions_of_files(const Study& study) {
    std::vector<Condition> all = conditions();
    const std::size_t n = study.cell ? all.size() : 0;
    if (!study.cell) {
        for (Condition& each : all)
            each.height.reset(), each.bead_volume.reset();
    }
    for (std::size_t k = 0; k < n; ++k) {
        Condition later = all[k];
        later.bead_volume = *later.bead_volume / 2;
        AnnularCell cell = *study.cell;
        cell.bead_volume = *later.bead_volume;
        later.height = height(0.6, cell);
        later.time += 3600;
        all.push_back(later);
    }
    std::ranges::stable_partition(all, [](const Condition& c) { return c.dry(); });
    return all;
}

/// A planted effect's size: three times what matters.
double planted_value(const Effect& effect, const EffectParameter& p) {
    return effect.given_by_liquid
               ? 0.03
               : std::clamp(p.neutral + 3 * p.smallest_of_interest, p.lower, 0.8 * p.upper);
}

Study study_of(const Case& one) {
    Study study = study_with(one.base);
    study.model.fit_to = "all";
    study.sources = {{.liquid_content = 0.0}, {.liquid_content = 0.03}};
    for (const std::string& effect : one.effects) {
        study.model.effects.push_back({effect, {}});
        const auto built_in = std::ranges::find(built_in_effects(), effect, &Effect::name);
        if (built_in == built_in_effects().end()) continue;
        study.sources.front().at_failure |= built_in->touches == Touches::failure;
        if (built_in->of_table()) study.cell.reset();
    }
    if (!one.written.empty()) {
        study.written_effects =
            read_written_effects(StudyTable::parse("study.toml", one.written, {"effect"}));
    }
    return study;
}

/// A calibration that has found the planted truth, with its model.
struct Planted {
    Study study;
    Calibration calibration;
    std::unique_ptr<StudyModel> model;

    explicit Planted(const Case& one) : study(study_of(one)) {
        static const std::vector<dem::RunResult> shipped = all_shipped_runs();
        Calibration& c = calibration;
        c.grains = study.grains;
        c.liquid = study.liquid;
        c.model = study.model;
        c.written_effects = study.written_effects;
        c.fidelity = fidelity_named("quick");
        c.runs = runs_serving(study, c.fidelity, shipped);
        c.hyperparameters = shipped_hyperparameters();
        for (const Condition& condition : conditions_of_files(study)) {
            c.readings.push_back({.origin = {condition.time > 3600 ? "two.csv" : "one.csv", 1},
                                  .condition = condition});
            // With points of failure, they are the second file.
            c.readings.back().condition.at_failure =
                study.sources.front().at_failure && condition.time > 3600;
            if (one.normal_stress > 0 && condition.dry()) {
                c.readings.back().condition.inertial_number = 0;
                c.readings.back().condition.normal_stress = one.normal_stress;
            }
        }
        c.fitted = c.readings.size();
        model = std::make_unique<StudyModel>(study, c);
        c.parameters = model->model().parameters();
        c.fit.parameters = Eigen::VectorXd(std::ssize(c.parameters));
        // Off the nodes of the curve against friction, which lie 0.01 apart.
        c.fit.parameters(0) = planted_friction + 0.005;
        Eigen::VectorXd error = c.fit.parameters;
        error(0) = 0.003;
        Eigen::Index next = 1;
        for (const Effect* effect : model->effects()) {
            for (const EffectParameter& p : effect->parameters) {
                if (!p.is_fitted()) continue;
                c.fit.parameters(next) = planted_value(*effect, p);
                error(next++) = 0.1 * p.smallest_of_interest;
            }
        }
        c.fit.covariance = error.cwiseAbs2().asDiagonal();
        c.fit.at_bound = std::vector<bool>(c.parameters.size(), false);
        read();
    }

  private:
    /// Readings of 1 % and 0.2 % scatter, and what follows from them.
    void read() {
        Calibration& c = calibration;
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal;
        c.prediction = model->model().predict(c.fit.parameters, conditions_of(c.readings));
        for (std::size_t k = 0; k < c.readings.size(); ++k) {
            const Eigen::Vector2d value =
                c.prediction.value.segment<2>(2 * static_cast<Eigen::Index>(k));
            const Eigen::Vector2d error(0.01 * value(0), 0.002 * value(1));
            const Eigen::Vector2d scatter(normal(random), normal(random));
            c.readings[k].value = value + error.cwiseProduct(scatter);
            c.readings[k].covariance = error.cwiseAbs2().asDiagonal();
        }
        c.prediction = predict_readings(model->model(), c);
        add_cohesion_lines(model->model(), c);
    }
};

/// Values as figures show them, of observable `o`.
struct Values {
    double measured, predicted, error;
};
Values values_of(const Calibration& c, std::size_t k, std::size_t o) {
    const Reading& reading = c.readings[k];
    const auto i = static_cast<Eigen::Index>(o);
    const double unit = o == 0 ? reading.condition.normal_stress : 1;
    return {reading.value(i) / unit,
            c.prediction.value(2 * static_cast<Eigen::Index>(k) + i) / unit,
            std::sqrt(reading.covariance(i, i)) / unit};
}

/// Mean of readings with their weights, where a figure draws them as one.
Values mean_of_readings(const Calibration& c, const std::vector<std::size_t>& which,
                        std::size_t o) {
    double measured = 0, predicted = 0, weights = 0;
    for (const std::size_t k : which) {
        const Values one = values_of(c, k, o);
        const double weight = std::pow(one.error, -2);
        measured += weight * one.measured, predicted += weight * one.predicted, weights += weight;
    }
    return {measured / weights, predicted / weights, 1 / std::sqrt(weights)};
}

const Curve* curve_named(const Panel& panel, const std::vector<std::string>& labels,
                         Curve::Style style) {
    for (const Curve& curve : panel.curves) {
        if (curve.style == style && !curve.x.empty() &&
            std::ranges::find(labels, curve.label) != labels.end()) {
            return &curve;
        }
    }
    return nullptr;
}

double interpolated(const Curve& curve, double x) {
    for (std::size_t k = 1; k < curve.x.size(); ++k) {
        if (curve.x[k - 1] <= x * (1 + 1e-9) && x <= curve.x[k] * (1 + 1e-9)) {
            const double share = (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
            return curve.y[k - 1] + share * (curve.y[k] - curve.y[k - 1]);
        }
    }
    return std::nan("");
}

/// Label of the model beside measured values, "points of failure, model, liquid content 0.03" for
/// "points of failure, measured, liquid content 0.03".
std::string of_model(std::string measured, const char* word) {
    const std::string from = "measured";
    return measured.replace(measured.find(from), from.size(), word);
}

/// Value of the model that a panel draws beside a measured point: a point of its own, else its
/// curve.
double drawn_model(const Panel& panel, const Curve& measured, std::size_t k) {
    const auto with = [&](const char* word) { return of_model(measured.label, word); };
    if (const Curve* points =
            curve_named(panel, {with("model at the readings"), with("simulated"), with("model")},
                        Curve::Style::points)) {
        return points->x.size() == measured.x.size() ? points->y[k] : std::nan("");
    }
    const Curve* line = curve_named(panel, {with("model")}, Curve::Style::line);
    return line ? interpolated(*line, measured.x[k]) : std::nan("");
}

/// Distance [1] of a value from the nearest line of the model of these points, of which there may
/// be several: for each mass of beads or file. Symbols repeat predictions; lines are made apart
/// from them, at conditions between those of readings. None where no line is drawn.
std::optional<double> off_lines(const Panel& panel, const Curve& measured, double x, double value) {
    const std::string of = of_model(measured.label, "model");
    std::optional<double> least;
    for (const Curve& curve : panel.curves) {
        if (curve.style != Curve::Style::line || !curve.label.starts_with(of)) continue;
        const double off = std::abs(interpolated(curve, x) - value);
        if (std::isfinite(off)) least = std::min(least.value_or(off), off);
    }
    return least;
}

const Figure& figure_named(const std::vector<Figure>& figures, const std::string& name) {
    return *std::ranges::find(figures, name, &Figure::name);
}

class FiguresOfEffects : public testing::TestWithParam<Case> {
  protected:
    Planted planted{GetParam()};
    const Calibration& c = planted.calibration;
    std::vector<Figure> figures = comparison_figures(*planted.model, c, compare(c));

    std::vector<std::size_t> readings(bool dry) const {
        std::vector<std::size_t> result;
        for (std::size_t k = 0; k < c.readings.size(); ++k) {
            if (c.readings[k].condition.dry() == dry) result.push_back(k);
        }
        return result;
    }
    std::vector<std::size_t> slow(std::vector<std::size_t> which) const {
        std::erase_if(
            which, [&](std::size_t k) { return c.readings[k].condition.inertial_number > 0.004; });
        return which;
    }
    /// Slow dry readings that figures draw as one: points of failure are none of them.
    std::vector<std::size_t> slow_dry() const {
        std::vector<std::size_t> which = slow(readings(true));
        std::erase_if(which, [&](std::size_t k) { return c.readings[k].condition.at_failure; });
        return which;
    }
    /// The readings (or their mean) that were measured so, and what the fit leaves of them.
    Values told(double measured, std::size_t o, const std::vector<std::size_t>& which,
                bool* is_mean) const {
        for (const std::size_t k : which) {
            const Values one = values_of(c, k, o);
            if (std::abs(one.measured - measured) < 1e-12) return one;
        }
        *is_mean = true;
        return mean_of_readings(c, slow_dry(), o);
    }
    /// Demands of every measured point of a figure that the drawn model beside it leaves the fit's
    /// own residual. @return how many readings it shows
    std::size_t expect_residuals(const std::string& name) {
        const Figure& figure = figure_named(figures, name);
        std::size_t points = 0;
        double worst = 0, worst_line = 0;
        std::size_t lines = 0;
        for (std::size_t p = 0; p < figure.panels.size(); ++p) {
            const Panel& panel = figure.panels[p];
            const std::size_t o = panel.y_label.find("solid fraction") == std::string::npos ? 0 : 1;
            for (const Curve& curve : panel.curves) {
                const bool named = curve.label.starts_with("measured") ||
                                   curve.label.starts_with("points of failure, measured");
                const bool measured =
                    named && curve.style == Curve::Style::points && !curve.x.empty();
                for (std::size_t k = 0; measured && k < curve.x.size(); ++k) {
                    bool is_mean = false;
                    const Values told_so = told(curve.y[k], o, all_readings(), &is_mean);
                    const double drawn = drawn_model(panel, curve, k);
                    const double off = (told_so.predicted - drawn) / told_so.error;
                    EXPECT_NEAR(off, 0, tolerance)
                        << name << ", " << curve.label << ", x = " << curve.x[k];
                    EXPECT_NEAR(told_so.measured, curve.y[k], 1e-9) << name << curve.label;
                    worst = std::max(worst, std::isfinite(off) ? std::abs(off) : INFINITY);
                    points += is_mean ? 0 : 1;
                    if (is_mean || curve.x[k] == 0) continue;
                    const auto line = off_lines(panel, curve, curve.x[k], told_so.predicted);
                    if (!line) continue;
                    ++lines;
                    worst_line = std::max(worst_line, *line / told_so.error);
                    EXPECT_LT(*line / told_so.error, tolerance)
                        << name << ", line of " << curve.label << ", x = " << curve.x[k];
                }
            }
        }
        RecordProperty(name, fmt::format("{:.3f}", worst));
        RecordProperty(name + "_line", fmt::format("{:.3f} of {}", worst_line, lines));
        return points / (name == "inertial_number" ? 2 : 1);
    }
    /// Where the slowest dry readings leave the residual r in the mean, the measured band of the
    /// calibration figure stands r above its curve at the calibrated friction.
    void expect_crossing_at_the_calibrated_friction() {
        const Figure& figure = figure_named(figures, "calibration");
        for (const std::size_t o : {0u, 1u}) {
            const Panel& panel = figure.panels[o];
            const auto friction = std::ranges::find(panel.references, true, &Reference::vertical);
            const auto band = std::ranges::find(panel.references, false, &Reference::vertical);
            const auto line = std::ranges::find(panel.curves, Curve::Style::line, &Curve::style);
            const Values mean = mean_of_readings(c, slow_dry(), o);
            const double off = (band->value - interpolated(*line, friction->value) -
                                (mean.measured - mean.predicted)) /
                               mean.error;
            EXPECT_NEAR(off, 0, tolerance) << panel.y_label;
            RecordProperty("calibration" + std::to_string(o), fmt::format("{:.3f}", off));
        }
    }
    void expect_parity() {
        const Figure& figure = figure_named(figures, "parity");
        for (const std::size_t o : {0u, 1u}) {
            const Curve& points = figure.panels[o].curves.front();
            ASSERT_EQ(points.x.size(), c.readings.size());
            for (std::size_t k = 0; k < c.readings.size(); ++k) {
                EXPECT_EQ(points.y[k], c.prediction.value(static_cast<Eigen::Index>(2 * k + o)));
            }
        }
    }
    std::vector<std::size_t> all_readings() const {
        std::vector<std::size_t> all = readings(true);
        std::ranges::copy(readings(false), std::back_inserter(all));
        return all;
    }
};

std::string test_name(const testing::TestParamInfo<Case>& test) {
    std::string name = test.param.name;
    std::ranges::replace_if(
        name, [](char c) { return c == '-' || c == ' '; }, '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Every, FiguresOfEffects, testing::ValuesIn(cases()), test_name);

TEST_P(FiguresOfEffects, DrawTheFittedModel) {
    EXPECT_EQ(expect_residuals("inertial_number"), readings(true).size());
    expect_crossing_at_the_calibrated_friction();
    expect_parity();
    // The wet figures show the readings at one inertial number.
    ReadingsAtOneRate at = at_one_inertial_number(planted.model->model(), c);
    planted.calibration.readings = std::move(at.readings);
    planted.calibration.prediction = std::move(at.predicted);
    for (const std::string name : {"stress_ratio_wet", "solid_fraction_wet"}) {
        EXPECT_GE(expect_residuals(name), readings(false).size());
    }
}

/// Where the model is Rumpf's itself, its estimate of the cohesion explains the cohesion that the
/// model shows: the mean of mu* Phi Z*/pi and the slope of the line through the predictions differ
/// by a few per cent, since solid fraction and coordination fall with cohesion.
class CohesionsOfRumpf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Every, CohesionsOfRumpf,
                         testing::Values("", "contact-angle", "capillary-bridges", "wet-friction",
                                         "torque-offset", "wall-friction", "torque-gain",
                                         "grain-weight", "liquid-loss", "normal-force-offset",
                                         "polydispersity", "viscous-bridges"));

TEST_P(CohesionsOfRumpf, AreThoseOfTheModel) {
    const Case one{"rumpf",
                   GetParam().empty() ? std::vector<std::string>{} : std::vector{GetParam()},
                   "rumpf"};
    const Planted planted(one);
    const Calibration& c = planted.calibration;
    const auto figures = comparison_figures(*planted.model, c, compare(c));
    const Panel& panel = figure_named(figures, "reduced_cohesion").panels.front();
    const auto rumpf = std::ranges::find_if(panel.curves, [](const Curve& curve) {
        return curve.label.find("Rumpf") != std::string::npos && !curve.x.empty();
    });
    ASSERT_NE(rumpf, panel.curves.end());
    std::size_t found = 0;
    double worst = 0;
    for (const Curve& curve : panel.curves) {
        if (curve.label != "cohesion line through the model") continue;
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            const auto place = std::ranges::find(rumpf->x, curve.x[k]) - rumpf->x.begin();
            ASSERT_LT(place, std::ssize(rumpf->x));
            const double ratio = rumpf->y[static_cast<std::size_t>(place)] / curve.y[k];
            EXPECT_NEAR(ratio, 1, 0.05) << GetParam() << ", liquid content " << curve.x[k];
            worst = std::max(worst, std::abs(ratio - 1));
            ++found;
        }
    }
    EXPECT_EQ(found, 3u);
    RecordProperty("worst", fmt::format("{:.4f}", worst));
}

}  // namespace figures_of_effects_test
