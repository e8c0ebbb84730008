// A study from its recordings to a verdict without a command line.
#include "workflow/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "tests/support/golden.h"
#include "workflow/json/diagnosis.h"
#include "workflow/rivals.h"

namespace pendular::workflow_session_test {

namespace fs = std::filesystem;
using testing::Contains;

/// A copy of a study of friction 0.09 whose walls rub.
class Sessions : public testing::Test {
  protected:
    Sessions() {
        fs::copy(fs::path(PENDULAR_SOURCE_DIR) / "examples/hidden-effect", study_,
                 fs::copy_options::recursive);
        fs::remove_all(study_ / "out");
    }
    SessionOptions options() {
        return {.fidelity = fidelity_named("quick"), .listener = [this](const Event& event) {
                    kinds_.insert(event.kind);
                    texts_.push_back(event.text);
                }};
    }
    Session session(OutputPlaces outputs = {}) {
        return Session(study_, options(), std::move(outputs));
    }

    TemporaryFolder folder_;
    const fs::path study_ = folder_.path() / "study";
    std::set<Event::Kind> kinds_;
    std::vector<std::string> texts_;
};

/// Writes a study of readings at two shear rates whose solid fractions no friction explains, near
/// the end of the simulated frictions, where the errors of the simulation depend most on the
/// friction.
void write_misfitting_study(const fs::path& folder) {
    fs::create_directory(folder);
    std::ofstream(folder / "study.toml") << R"([grains]
diameter = "300 um"
density = "2500 kg/m^3"
[liquid]
surface_tension = "72 mN/m"
contact_angle = "0 deg"
[[readings]]
file = "points.csv"
[model]
fit_to = "all"
)";
    std::ofstream points(folder / "points.csv");
    points << "normal_stress [Pa],stress_ratio [1],stress_ratio_sd [1],solid_fraction [1],"
              "solid_fraction_sd [1],shear_rate [1/s],liquid_content [1]\n";
    for (const double content : {0.0, 0.03}) {
        for (const double rate : {1.0, 8.0}) {
            for (const double stress : {400.0, 700.0, 1300.0, 2500.0, 5000.0}) {
                const double wet = content > 0 ? 754 / stress : 0;  // 1/P*
                points << stress << ',' << 0.362 + 0.38 * wet - 0.06 * wet * wet << ",0.005,"
                       << 0.563 - 0.027 * wet << ",0.0015," << rate << ',' << content << '\n';
            }
        }
    }
}

TEST_F(Sessions, FitOneModelOnce) {
    const fs::path study = folder_.path() / "misfit";
    write_misfitting_study(study);
    const Session session(study, options());
    const Fit calibrated = session.calibrate({.confirm = false}).calibration.fit;
    const Diagnosis diagnosed = session.diagnose().diagnosis;
    EXPECT_GT(calibrated.chi2, 2 * calibrated.dof);
    EXPECT_NEAR(calibrated.parameters(0), diagnosed.base.fit.parameters(0),
                0.01 * calibrated.standard_error(0));
    EXPECT_NEAR(calibrated.chi2, diagnosed.base.fit.chi2, 1e-3 * diagnosed.base.fit.chi2);
}

TEST_F(Sessions, GoFromRecordingsToTheEffectThatWasMissing) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    {
        Session before = session();
        expect_told({input_error([&] { before.predict({}); })});
        EXPECT_EQ(before.measurements().readings.size(), 24u);
        const FittedStudy calibrated = before.calibrate();
        EXPECT_FALSE(calibrated.belief.believable());
        EXPECT_TRUE(fs::exists(study_ / "out/fit.json"));
        EXPECT_EQ(before.compare().calibration.fit.parameters(0),
                  calibrated.calibration.fit.parameters(0));
        const Reading& first = calibrated.calibration.readings.front();
        const Prediction again = before.predict({first.condition});
        EXPECT_NEAR(again.value(0), calibrated.comparison.readings.front().predicted(0),
                    1e-9 * again.value(0));
        EXPECT_GT(again.covariance(0, 0), 0);
        const StudyDiagnosis diagnosis = before.diagnose();
        EXPECT_EQ(diagnosis.diagnosis.verdict, Verdict::missing);
        EXPECT_THAT(diagnosis.diagnosis.effects, testing::ElementsAre("wall-friction"));
        const ChangedStudy added = before.add("wall-friction");
        EXPECT_TRUE(added.written);
        EXPECT_LT(added.after.ladder_step.chi2_per_dof(),
                  0.1 * added.before.ladder_step.chi2_per_dof());
        EXPECT_TRUE(added.after.belief.believable());
        EXPECT_EQ(added.ladder.size(), 2u);
        // Both fits use all readings, and the diagnosis has the same one before the change.
        EXPECT_EQ(added.before.calibration.fitted, 24u);
        EXPECT_EQ(added.after.calibration.fitted, 24u);
        EXPECT_NEAR(added.before.ladder_step.chi2, diagnosis.diagnosis.base.fit.chi2,
                    1e-3 * diagnosis.diagnosis.base.fit.chi2);
        // The session is one of the changed study.
        EXPECT_THAT(names_of(before.study().model.effects), testing::ElementsAre("wall-friction"));
        EXPECT_EQ(before.study().model.effects[0].position.line,
                  read_study(study_).model.effects[0].position.line);
        EXPECT_EQ(before.compare().calibration.fit.parameters,
                  added.after.calibration.fit.parameters);
        expect_told({input_error([&] { before.add("wall-friction"); })});
        std::ofstream(study_ / "study.toml", std::ios::app) << "# by hand";
        expect_told({input_error([&] { before.add("lid-slip"); })});
    }
    Session after(study_ / "study.toml", options());
    EXPECT_EQ(after.study().model.effects.size(), 1u);
    const StudyDiagnosis diagnosis = after.diagnose();
    EXPECT_FALSE(after.next(diagnosis).sharpenings.empty());
    const ChangedStudy dropped = after.drop("wall-friction");
    EXPECT_TRUE(dropped.change.study.study().model.effects.empty());
    // The study then fits its dry readings alone; a fit to all readings serves the comparison.
    EXPECT_EQ(dropped.after.calibration.fitted, 12u);
    ASSERT_TRUE(dropped.after_to_all);
    EXPECT_EQ(dropped.comparable_after().calibration.fitted, 24u);
    EXPECT_GT(dropped.comparable_after().ladder_step.chi2, 10 * dropped.before.ladder_step.chi2);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    for (const auto kind : {Event::Kind::round, Event::Kind::stage, Event::Kind::refits})
        EXPECT_THAT(kinds_, Contains(kind));
    EXPECT_THAT(texts_, Contains("fitting with wall-friction"));
}

TEST_F(Sessions, ConfirmNothingWithoutTime) {
    const Session without_time = session();
    const StudyDiagnosis plain = without_time.diagnose(), confirmed = without_time.diagnose(0.0);
    EXPECT_FALSE(plain.confirmed);
    ASSERT_TRUE(confirmed.confirmed);
    EXPECT_EQ(confirmed.confirmed->runs, 0u);
    EXPECT_FALSE(confirmed.confirmed->settled);
    EXPECT_EQ(confirmed.confirmed->open, Confirmation::Open::no_simulation);
    EXPECT_EQ(confirmed.diagnosis.effects, plain.diagnosis.effects);
    EXPECT_EQ(confirmed.diagnosis.base.fit.chi2, plain.diagnosis.base.fit.chi2);
}

TEST_F(Sessions, TellTheImpactOfWhatMayBeMissing) {
    const StudyDiagnosis diagnosis = session().diagnose();
    const auto impacts = impacts_of(diagnosis, 1);
    ASSERT_TRUE(impacts);
    EXPECT_EQ(impacts->impacts.front().name, "wall-friction");
    EXPECT_EQ(impacts->impacts.front().group, "instrument");
    // The refit of the diagnosis with wall friction at its estimate has this friction.
    const Fit& refit = diagnosis.diagnosis.confidence_set.front().fit;
    EXPECT_NEAR(impacts->fitted(0) + impacts->impacts.front().at_estimate.refitted(0),
                refit.parameters(0), 1e-9);
}

TEST_F(Sessions, RefuseToWriteOverTheirInputs) {
    expect_told({input_error(
        [&] { session({.folder = study_, .files = {"dry_1.csv"}, .json = std::nullopt}); })});
}

TEST_F(Sessions, EndAtACleanPointWhenToldToStop) {
    std::stop_source stop;
    SessionOptions stopped = options();
    stopped.stop = stop.get_token();
    Session session(study_, stopped);
    stop.request_stop();
    EXPECT_THROW(session.diagnose(), dem::Interrupted);
    EXPECT_THROW(session.add("wall-friction"), dem::Interrupted);
    EXPECT_FALSE(fs::exists(study_ / "out/fit.json"));
}

/// Appends effects "gain-a" and "gain-b", which multiply the torque by 1 + gain, to a study.toml.
void append_two_gains(const fs::path& file) {
    std::ofstream text(file, std::ios::app);
    for (const char* name : {"gain-a", "gain-b"}) {
        text << "\n[[effect]]\nname = \"" << name
             << "\"\nparameter = \"gain\"\nlower = -0.5\nupper = 0.5\n"
                "torque = \"torque*(1 + gain)\"\n";
    }
}

TEST_F(Sessions, KeepTheRivalOfAnAddedEffect) {
    // Two effects of one formula cannot be told apart, a wall's friction and a gain can.
    append_two_gains(study_ / "study.toml");
    fs::create_directories(study_ / "out");
    std::ofstream(study_ / "out/diagnosis.json")
        << R"({"model_effects": [], "confidence_set": [["gain-a"], ["gain-b"], ["lid-slip"]]})";
    EXPECT_THAT(rivals_in(study_ / "out/diagnosis.json", session().study(), "torque-gain"),
                testing::IsEmpty());
    const ChangedStudy added = session().add(
        "gain-a",
        {.rivals = rivals_in(study_ / "out/diagnosis.json", session().study(), "gain-a")});
    ASSERT_TRUE(added.written);
    EXPECT_THAT(
        added.after.ladder_step.rivals,
        testing::ElementsAre(testing::ElementsAre("gain-b"), testing::ElementsAre("lid-slip")));
    EXPECT_THAT(rivals_in(study_ / "out/diagnosis.json", session().study(), "gain-b"),
                testing::IsEmpty())
        << "the model has other effects than the one diagnosed";
    const Session after = session();
    StudyDiagnosis diagnosis = after.diagnose();
    ASSERT_EQ(diagnosis.rivals.size(), 1u);
    EXPECT_EQ(diagnosis.rivals[0].in_place_of, "gain-a");
    EXPECT_THAT(diagnosis.rivals[0].effects, testing::ElementsAre("gain-b"));
    EXPECT_NEAR(diagnosis.rivals[0].fit.chi2, diagnosis.diagnosis.base.fit.chi2,
                0.01 * diagnosis.diagnosis.base.fit.chi2);
    diagnosis.diagnosis.confidence_set.clear();
    diagnosis.diagnosis.leaders.reset();
    ASSERT_EQ(rivals_of(diagnosis).size(), 2u);
    EXPECT_EQ(rivals_of(diagnosis).back().name, "gain-b in place of gain-a");
    EXPECT_EQ(diagnosis.rivals[0].name, "gain-b in place of gain-a");
    // An effect that the study lists by now stays in the model beside the rival.
    Ladder ladder = added.ladder;
    ladder.back().rivals = {{"gain-b", "gain-a"}, {"gain-a"}};
    const auto alive = rivals_not_ruled_out(diagnosis, after.resolved(), ladder);
    ASSERT_EQ(alive.size(), 1u);
    EXPECT_THAT(alive[0].effects, testing::ElementsAre("gain-b"));
    std::ofstream(study_ / "out/ladder.json") << "{";
    expect_told({input_error([&] { after.diagnose(); })});
}

}  // namespace pendular::workflow_session_test
