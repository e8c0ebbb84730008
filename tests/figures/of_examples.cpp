// Every figure of every example, and of every command that draws: nothing that one would not print.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study_page.h"
#include "reports/change_figure.h"
#include "reports/diagnosis_figures.h"
#include "reports/effect_pages.h"
#include "reports/misfit_figures.h"
#include "reports/next_steps.h"
#include "reports/recording_figures.h"
#include "reports/simulation_figures.h"
#include "sim/catalogue/effect_catalogue.h"
#include "sim/runs/run_settings.h"
#include "sim/runs/store/run_table.h"
#include "tests/support/figure_faults.h"
#include "workflow/reproduction.h"
#include "workflow/session.h"
#include "workflow/state_prediction.h"

namespace pendular::figures_of_examples_test {

namespace fs = std::filesystem;

/// Expects that figures have no fault, and that there are any.
void expect_sound(const std::vector<Figure>& figures) {
    EXPECT_FALSE(figures.empty());
    for (const Figure& figure : figures) {
        for (const std::string& fault : figure_check::faults_of(figure))
            ADD_FAILURE() << fault;
    }
}

std::vector<Figure> recordings_of(const Session& session) {
    std::vector<Figure> figures;
    app::for_each_recording(
        session.study(), [](const std::string&) {},
        [&](const FileView& view) {
            figures.push_back(recording_figure(view, session.measurements().readings,
                                               session.measurements().left_out()));
        });
    return figures;
}

/// Figures of `compare` as of a fit that is not believed, whose titles are the longest.
std::vector<Figure> compared(const FittedStudy& fit) {
    std::vector<Figure> figures = comparison_figures(*fit.model, fit.calibration, fit.comparison);
    mark_as_rejected(figures);
    return figures;
}

/// An example, and the effect that it lacks; empty for none.
struct Example {
    std::string name, missing;

    friend void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }
};

class FiguresOfExamples : public testing::TestWithParam<Example> {
  protected:
    FiguresOfExamples() : study_(folder_.path() / GetParam().name) {
        fs::copy(fs::path(PENDULAR_SOURCE_DIR) / "examples" / GetParam().name, study_,
                 fs::copy_options::recursive);
    }
    Session session() const {
        return Session(study_, {.fidelity = fidelity_named("standard"), .threads = 2});
    }

    TemporaryFolder folder_;
    fs::path study_;
};

TEST_P(FiguresOfExamples, HaveNoFault) {
    Session open = session();
    expect_sound(compared(open.calibrate()));
    if (GetParam().name != "polystyrene") expect_sound(recordings_of(open));
    const StudyDiagnosis diagnosis = open.diagnose();
    expect_sound(diagnosis_figures(diagnosis, impacts_of(diagnosis, 2)));
    if (const Figure next = next_figure(open.next(diagnosis)); !next.panels.empty())
        expect_sound({next});
}

TEST_P(FiguresOfExamples, HaveNoFaultWithTheMissingEffect) {
    if (GetParam().missing.empty()) GTEST_SKIP() << "nothing is missing";
    Session open = session();
    open.calibrate();
    const ChangedStudy changed = open.add(GetParam().missing);
    expect_sound({ladder_figure(changed.ladder), change_figure(changed)});
    expect_sound(compared(changed.after));
}

INSTANTIATE_TEST_SUITE_P(
    , FiguresOfExamples,
    testing::Values(Example{"dry-recordings", ""}, Example{"hidden-effect", "wall-friction"},
                    Example{"polystyrene", ""}, Example{"rumpf-to-full", "capillary-shear-stress"},
                    Example{"straight-line", "contact-stress"},
                    Example{"water-glass", "torque-offset"}, Example{"wet", ""}),
    [](const auto& of) {
        std::string name = of.param.name;
        std::erase(name, '-');
        return name;
    });

TEST(FiguresOfSimulations, OfThePublishedStudyHaveNoFault) {
    const Reproduction reproduction(fidelity_named("standard"), nullptr);
    expect_sound(paper_figures(reproduction.study()));
}

/// Runs that come with the program, as if a store had them.
std::vector<StoredRun> atlas() {
    return read_runs(atlas_file());
}

TEST(FiguresOfSimulations, OfARangeOfRunsHaveNoFault) {
    for (const char* const x : {"reduced_pressure", "inertial_number", "friction"}) {
        for (const char* const y : {"stress_ratio", "solid_fraction"})
            expect_sound({runs_figure(atlas(), x, y)});
    }
}

TEST(FiguresOfSimulations, OfEffectsHaveNoFault) {
    const EffectCatalogue catalogue;
    const Study study = signature_study(catalogue.all());
    auto known = known_runs(study, fidelity_named("standard"), nullptr);
    const auto simulation = std::make_shared<EmulatedSimulation>(
        study, fidelity_named("standard"),
        Emulator(known->runs, std::move(known->hyperparameters)));
    for (const Effect& effect : catalogue.all())
        expect_sound({signature_figure(effect, study, simulation)});
}

TEST(FiguresOfSimulations, AlongACurveHaveNoFault) {
    const StatePredictor predictor(fidelity_named("standard"), nullptr, 1000);
    const std::vector<std::string> drawn = {"stress_ratio", "solid_fraction"};
    for (const auto& [name, from, to] :
         {std::tuple("inertial_number", 0.002, 0.05), std::tuple("friction", 0.05, 0.4)}) {
        const PredictionCurve curve =
            predictor.along({.friction = 0.1}, {.name = name, .from = from, .to = to});
        expect_sound({prediction_figure(curve, predictor.emulator(), drawn)});
    }
}

}  // namespace pendular::figures_of_examples_test
