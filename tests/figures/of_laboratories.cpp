// Every figure of laboratories that differ in cell of conditions, liquid contents and protocol:
// nothing that one would not print. Their readings are predictions of the earlier simulations with
// scatter, and with an offset of the shear stress that the model does not know.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "reports/diagnosis_figures.h"
#include "reports/misfit_figures.h"
#include "reports/next_steps.h"
#include "tests/support/figure_faults.h"
#include "tests/support/small_wet_study.h"
#include "workflow/session.h"
#include "workflow/study_input.h"

namespace pendular::figures_of_laboratories_test {

/// Conditions of a laboratory, and what its figures depend on beside them.
struct Laboratory {
    std::string name;
    std::vector<double> contents, stresses;  ///< liquid content [1], normal stress [Pa]
    std::vector<double> numbers;             ///< inertial number [1]
    double diameter = 5e-4;                  ///< [m]
    double error = 0.02;                     ///< standard error of the stress ratio, relative
    bool constant_speed = false;             ///< whether the numbers are those at 1 kPa

    friend void PrintTo(const Laboratory& of, std::ostream* out) { *out << of.name; }
};

/// Geometric series.
std::vector<double> spaced(double from, double to, int count) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k)
        values.push_back(from * std::pow(to / from, k / (count - 1.0)));
    return values;
}

std::vector<Condition> conditions_of(const Laboratory& laboratory) {
    std::vector<Condition> all;
    for (const double content : laboratory.contents) {
        for (const double stress : laboratory.stresses) {
            const double slower = laboratory.constant_speed ? std::sqrt(1000 / stress) : 1;
            for (const double number : laboratory.numbers)
                all.push_back({.normal_stress = stress,
                               .inertial_number = number * slower,
                               .liquid_content = content});
        }
    }
    return all;
}

Study study_of(const Laboratory& laboratory) {
    Study study = small_wet::wet_study();
    study.grains.diameter = laboratory.diameter;
    return study;
}

std::string settings(const Laboratory& laboratory) {
    return fmt::format(
        "[grains]\ndiameter = \"{} m\"\ndensity = \"1050 kg/m^3\"\n"
        "[liquid]\nsurface_tension = \"20.6 mN/m\"\ncontact_angle = \"0 deg\"\n"
        "[[readings]]\nfile = \"points.csv\"\n[model]\nfit_to = \"all\"\n",
        laboratory.diameter);
}

/// Rows of a table of readings: 4 % of the least normal stress too much shear stress.
std::string table(const Laboratory& laboratory) {
    const Study study = study_of(laboratory);
    auto known = known_runs(study, fidelity_named("standard"), nullptr);
    const EmulatedSimulation simulation(study, fidelity_named("standard"),
                                        Emulator(known->runs, std::move(known->hyperparameters)));
    const std::vector<Condition> conditions = conditions_of(laboratory);
    const Eigen::VectorXd value = simulation.predict(small_wet::at(0.09), conditions).value;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const double offset = 0.04 * std::ranges::min(laboratory.stresses);
    std::string text =
        "normal_stress [Pa],stress_ratio,stress_ratio_sd,solid_fraction,solid_fraction_sd,"
        "inertial_number,liquid_content\n";
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(2 * k);
        const double stress = conditions[k].normal_stress, ratio = (value(at) + offset) / stress,
                     error = laboratory.error * ratio, of_fraction = 0.002;
        text += fmt::format("{:.6g},{:.6g},{:.3g},{:.6g},{},{:.6g},{}\n", stress,
                            ratio + error * normal(random), error,
                            value(at + 1) + of_fraction * normal(random), of_fraction,
                            conditions[k].inertial_number, conditions[k].liquid_content);
    }
    return text;
}

class FiguresOfLaboratories : public testing::TestWithParam<Laboratory> {};

void expect_sound(const std::vector<Figure>& figures) {
    EXPECT_FALSE(figures.empty());
    for (const Figure& figure : figures) {
        for (const std::string& fault : figure_check::faults_of(figure))
            ADD_FAILURE() << fault;
    }
}

TEST_P(FiguresOfLaboratories, HaveNoFault) {
    const TemporaryFolder folder;
    folder.write("study.toml", settings(GetParam()));
    folder.write("points.csv", table(GetParam()));
    const Session open(folder.path(), {.fidelity = fidelity_named("standard"), .threads = 2});
    const FittedStudy fit = open.calibrate({.confirm = false});
    std::vector<Figure> figures = comparison_figures(*fit.model, fit.calibration, fit.comparison);
    mark_as_rejected(figures);
    expect_sound(figures);
    const StudyDiagnosis diagnosis = open.diagnose();
    expect_sound(diagnosis_figures(diagnosis, impacts_of(diagnosis, 2)));
    if (const Figure next = next_figure(open.next(diagnosis)); !next.panels.empty())
        expect_sound({next});
}

INSTANTIATE_TEST_SUITE_P(, FiguresOfLaboratories,
                         testing::Values(Laboratory{.name = "ManyContents",
                                                    .contents = {0, 0.003, 0.005, 0.007, 0.01,
                                                                 0.014, 0.02, 0.03, 0.045, 0.063},
                                                    .stresses = {300, 1000, 3000},
                                                    .numbers = {0.005}},
                                         Laboratory{.name = "ManyLoads",
                                                    .contents = {0, 0.02},
                                                    .stresses = spaced(250, 6000, 14),
                                                    .numbers = {0.01}},
                                         Laboratory{.name = "ConstantSpeed",
                                                    .contents = {0, 0.007, 0.03},
                                                    .stresses = {300, 600, 1000, 3000},
                                                    .numbers = {0.01},
                                                    .constant_speed = true},
                                         Laboratory{.name = "OneLoad",
                                                    .contents = {0},
                                                    .stresses = {2000},
                                                    .numbers = spaced(0.004, 0.05, 5)},
                                         Laboratory{.name = "DryAtManyLoadsAndSpeeds",
                                                    .contents = {0},
                                                    .stresses = spaced(200, 5000, 6),
                                                    .numbers = spaced(0.003, 0.05, 5)},
                                         Laboratory{.name = "WetOnly",
                                                    .contents = {0.007, 0.03},
                                                    .stresses = {300, 1000, 3000},
                                                    .numbers = {0.005, 0.02}},
                                         Laboratory{.name = "SmallStresses",
                                                    .contents = {0, 0.03},
                                                    .stresses = {12, 25, 50},
                                                    .numbers = {0.005, 0.03},
                                                    .diameter = 5e-3},
                                         Laboratory{.name = "ExactReadings",
                                                    .contents = {0, 0.03},
                                                    .stresses = {500, 2000},
                                                    .numbers = {0.005, 0.02},
                                                    .error = 1e-4},
                                         Laboratory{.name = "RoughReadings",
                                                    .contents = {0, 0.007, 0.03},
                                                    .stresses = {500, 2000},
                                                    .numbers = {0.005, 0.02},
                                                    .error = 0.3},
                                         Laboratory{.name = "ManyReadings",
                                                    .contents = {0, 0.007, 0.03},
                                                    .stresses = {500, 1000},
                                                    .numbers = spaced(0.003, 0.078, 15)}),
                         [](const auto& of) { return of.param.name; });

}  // namespace pendular::figures_of_laboratories_test
