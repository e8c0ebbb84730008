// What to do after each verdict, from a diagnosis whose verdict is changed for the purpose.
#include "reports/next_steps.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>

#include "reports/diagnosis_table.h"
#include "reports/other_causes.h"
#include "reports/proposal_report.h"
#include "reports/verdict_report.h"
#include "tests/support/changed_example.h"
#include "tests/support/golden.h"
#include "workflow/rivals.h"
#include "workflow/session.h"

namespace pendular::next_steps_test {

namespace fs = std::filesystem;

/// Diagnosis of beads of friction 0.09 whose walls rub.
class NextSteps : public testing::Test {
  protected:
    NextSteps()
        : session_(fs::path(PENDULAR_SOURCE_DIR) / "examples/hidden-effect",
                   {.fidelity = fidelity_named("quick")}),
          d_(session_.diagnose()) {}

    std::vector<NextStep> steps(const std::optional<ImpactTable>& impacts = {}) const {
        return next_steps(d_, impacts, session_.resolved(), "beads");
    }
    std::vector<std::string> texts() const { return texts_of(steps()); }
    std::string command() const { return next_command(d_.diagnosis, steps(), "beads"); }
    void forget(Verdict verdict) {
        d_.diagnosis.verdict = verdict;
        d_.diagnosis.effects.clear();
        d_.diagnosis.confidence_set.clear();
    }
    FittedShape change_of(const std::string& target) const {
        for (const ChangedQuantity& each :
             quantities_that_may_change(session_.resolved(), d_.readings)) {
            if (each.target != target || !each.relative) continue;
            FittedShape fitted{
                .shape = {each, same_everywhere(d_.readings.size())}, .effect = {}, .change = 0.1};
            fitted.effect = fitted.shape.written(fitted.shape.name());
            return fitted;
        }
        ADD_FAILURE() << target;
        return {};
    }

    const Session session_;
    StudyDiagnosis d_;
};

TEST_F(NextSteps, MeasureAMissingEffectDirectlyBeforeItIsAdded) {
    ASSERT_EQ(d_.diagnosis.verdict, Verdict::missing);
    const auto list = steps();
    ASSERT_EQ(list.size(), 3u);
    EXPECT_TRUE(list[0].direct);
    EXPECT_TRUE(list[2].readings);
    EXPECT_EQ(command(), "pendular add beads wall-friction");
    const auto lines = step_lines(list, {"Take 5 readings.", "  friction: 0.1 -> 0.05"});
    EXPECT_EQ(first_step(lines), list[0].text);
    expect_told(lines);
    expect_told({friction_line(d_)});
}

TEST_F(NextSteps, CheckTheSensorAndRepeatSuspectReadings) {
    forget(Verdict::suspect_measurement);
    const auto suspect = std::ranges::find_if(d_.evidence.suspects, [](const auto& each) {
        return each.name.find("wet_0.03_1.csv") != std::string::npos && each.group == "files";
    });
    ASSERT_NE(suspect, d_.evidence.suspects.end());
    d_.diagnosis.suspects = {suspect->name};
    FittedModel error{.fit = d_.diagnosis.base.fit};
    error.fit.chi2 = 47;
    error.suspect = static_cast<std::size_t>(suspect - d_.evidence.suspects.begin());
    const auto size = error.fit.parameters.size() + 2;
    error.fit.parameters.conservativeResize(size);
    error.fit.parameters.tail<2>() << 0.09, 0.0001;
    error.fit.covariance = Eigen::MatrixXd::Identity(size, size) * 1e-4;
    error.fit.widening.resize(0, 0), error.fit.discrepancy_part.resize(0, 0);
    d_.diagnosis.confidence_set = {error};
    expect_told(texts());  // an error of two files may be gone, so that they come first
    d_.evidence.suspects[*error.suspect].group = "changes in time";
    expect_told(texts());  // a sensor that is still wrong
    expect_told(suspect_lines(d_));
    d_.diagnosis.overruled = true;  // a wrong unit
    expect_told(texts());
    EXPECT_TRUE(suspect_lines(d_).empty());
}

TEST_F(NextSteps, NameNoReadingsThatCannotBePlanned) {
    Study study = session_.study();
    study.rig->inertial_number = {0.5, 0.9};  // no simulation flows so fast
    const ResolvedStudy far = session_.resolved().changed_to(std::move(study));
    ASSERT_TRUE(std::ranges::any_of(steps(), &NextStep::readings));
    for (const NextStep& step : next_steps(d_, {}, far, "beads"))
        EXPECT_FALSE(step.readings) << step.text;
}

TEST_F(NextSteps, CheckTheSensorBeforeAProposalIsAdded) {
    forget(Verdict::unknown);
    d_.diagnosis.complete = false;
    expect_told(texts());  // three sensors
    expect_told({command()});
    Proposal proposal;
    proposal.shapes = {change_of("stress_ratio")};
    proposal.alike = {change_of("torque")};
    proposal.model.fit = d_.diagnosis.base.fit;
    proposal.model.fit.chi2 = 1e6;
    d_.proposals.push_back(proposal);
    const auto list = steps();
    expect_told(texts());
    EXPECT_TRUE(std::ranges::none_of(list, &NextStep::readings)) << "the check decides";
    expect_told({command()});
    // A check of sensors does not decide between two causes in the beads.
    d_.proposals.push_back(proposal);
    EXPECT_TRUE(std::ranges::any_of(steps(), &NextStep::readings));
    EXPECT_EQ(command(), "pendular next beads");
}

TEST_F(NextSteps, AddWhatIsThereAnywayBeforeItsRivalsAreSought) {
    forget(Verdict::indistinguishable);
    d_.diagnosis.effects = {"torque-offset", "grain-weight"};
    expect_told({texts().front()});
    EXPECT_EQ(command(), "pendular add beads grain-weight");
    d_.diagnosis.effects = {"torque-offset", "normal-force-offset"};
    EXPECT_EQ(command(), "pendular next beads");
}

TEST_F(NextSteps, RuleOutWhatWouldShiftTheFriction) {
    forget(Verdict::inconclusive);
    d_.diagnosis.effects = {"rolling-resistance", "torque-gain"};
    d_.diagnosis.base.fit.chi2 = d_.diagnosis.dof;
    expect_told(texts());
    ImpactTable impacts{.fitted = Eigen::VectorXd::Ones(1),
                        .errors = Eigen::VectorXd::Ones(1),
                        .impacts = {{.name = "torque-gain"}}};
    impacts.impacts[0].at_interest.bounded = Eigen::VectorXd::Constant(1, 0.29);
    expect_told(texts_of(steps(impacts)));
    impacts.impacts[0].at_interest.bounded(0) = -0.31;
    expect_told(texts_of(steps(impacts)));
    expect_told(undetected_table(d_, impacts, session_.resolved().catalogue()));
    expect_told({friction_line(d_)});
}

TEST_F(NextSteps, NameAtMostThreeDirectMeasurements) {
    forget(Verdict::indistinguishable);
    d_.diagnosis.effects = {"torque-gain",   "torque-offset",       "lid-slip",
                            "contact-angle", "normal-force-offset", "height-offset"};
    EXPECT_EQ(std::ranges::count_if(steps(), &NextStep::direct), 3);
    EXPECT_TRUE(steps().back().readings);
    expect_told(texts());  // as the headline, the steps name all of them
    EXPECT_EQ(command(), "pendular next beads");
}

TEST_F(NextSteps, AskForRepeatedReadingsWhereErrorsAreNotKnown) {
    forget(Verdict::inconclusive);
    expect_told(texts());
    d_.diagnosis.errors_assumed = true;
    expect_told(texts());
}

TEST_F(NextSteps, SayWhichConditionOnlySuspectReadingsHave) {
    SuspectMeasurement suspect{.name = "the readings", .columns = d_.evidence.suspects[0].columns};
    for (std::size_t k = 0; k < d_.readings.size(); ++k) {
        suspect.columns.middleRows<2>(2 * static_cast<Eigen::Index>(k))
            .setConstant(d_.readings[k].condition.dry() ? 0 : 1);
    }
    EXPECT_EQ(own_condition(d_.readings, suspect), "liquid content 0.03");
    // Contents that differ by less than 2 % are one content.
    const auto wet = std::ranges::find_if(
        d_.readings, [](const Reading& each) { return !each.condition.dry(); });
    wet->condition.liquid_content *= 1.015;
    expect_told({own_condition(d_.readings, suspect)});
    suspect.columns.topRows<2>().setOnes();  // a dry one too
    EXPECT_EQ(own_condition(d_.readings, suspect), "");
}

TEST_F(NextSteps, WaitForRepeatsOfSuspectReadings) {
    forget(Verdict::indistinguishable);
    d_.diagnosis.effects = {"rolling-resistance", "wet-friction"};
    d_.diagnosis.suspects = {"the readings of dry_1.csv"};
    const auto lines = step_lines(steps(), {"Take 2 readings."});
    expect_told(lines);
    expect_told(texts());
}

TEST_F(NextSteps, NameTheLoadsAndTheErrorOfASensor) {
    FittedShape change = change_of("torque");
    change.change = -0.2;
    change.standard_error = 0.01;
    const auto check = [&](const FittedShape* of, double too_large = 0) {
        return sensor_check("torque", d_.readings, session_.study(), of, too_large);
    };
    expect_told({check(&change)});
    change.shape.profile.variable = "normal_stress";
    expect_told({check(&change), check(nullptr, -0.1)});
    for (Reading& reading : d_.readings) {
        reading.value(0) = 100;
    }
    expect_told({check(nullptr)});
}

TEST_F(NextSteps, TellCausesInTheBeadsApart) {
    forget(Verdict::unknown);
    d_.diagnosis.complete = false;
    Proposal proposal;
    proposal.shapes = {change_of("stress_ratio")};
    proposal.alike = {change_of("torque"), change_of("solid_fraction")};
    proposal.model.fit = d_.diagnosis.base.fit;
    d_.proposals.push_back(proposal);
    // Models that the readings rule out are left out, as are changes of what a sensor shows.
    d_.proposals[0].model.fit.chi2 = 0;
    const auto proposed = proposal_rivals(d_);
    ASSERT_EQ(proposed.size(), 1u);
    EXPECT_EQ(proposed[0].name, "proposal 1: stress-ratio-everywhere");
    d_.proposals[0].model.fit.chi2 = 1e6;
    const auto other = proposal_rivals(d_);
    ASSERT_EQ(other.size(), 1u);
    EXPECT_EQ(other[0].name, "solid-fraction-everywhere");
    EXPECT_EQ(other[0].fit.parameters.size(), d_.diagnosis.base.fit.parameters.size() + 1);
    EXPECT_EQ(other[0].predictor->parameters().back().name, "solid-fraction-everywhere.change");
    Eigen::VectorXd parameters = other[0].fit.parameters;
    const std::vector<Condition> at = {d_.readings.front().condition};
    parameters.tail<1>()(0) = 0;
    const double before = other[0].predictor->predict(parameters, at).value(1);
    parameters.tail<1>()(0) = 0.1;
    EXPECT_NEAR(other[0].predictor->predict(parameters, at).value(1), 1.1 * before, 1e-6);
}

std::string_view decision_on(const StudyDiagnosis& d, const std::string& effect) {
    return to_string(d.diagnosis.decision_on(finding_of(d.diagnosis, *d.models, effect)));
}

// Advice that, once followed, settles what it promises to settle.
TEST(NextStepsFollowed, RuleOutAnEffectByAMeasurementOfTheErrorThatTheyName) {
    const TemporaryFolder folder;
    const fs::path study = copy_with_its_effect(folder);
    const Session session(study, {.fidelity = fidelity_named("quick")});
    const StudyDiagnosis before = session.diagnose();
    ASSERT_EQ(before.diagnosis.verdict, Verdict::inconclusive);
    ASSERT_EQ(decision_on(before, "capillary-bridges"), "cannot be excluded");
    std::string error;
    for (const std::string& text : texts_of(next_steps(before, {}, session.resolved(), "beads"))) {
        std::smatch found;
        const std::regex advice(
            "capillary-bridges, measure.* A standard error of ([0-9.]+ .?N/m) or less");
        if (std::regex_search(text, found, advice)) error = found[1];
    }
    ASSERT_FALSE(error.empty());
    folder.write(
        "study/study.toml",
        content_of(study / "study.toml") +
            fmt::format("\n[[direct]]\neffect = \"capillary-bridges\"\nvalue = \"20.6 mN/m\"\n"
                        "error = \"{}\"\n",
                        error));
    const Session followed(study, {.fidelity = fidelity_named("quick")});
    EXPECT_EQ(decision_on(followed.diagnose(), "capillary-bridges"), "absent") << error;
}

TEST(NextStepsFollowed, BeginWithARecordingThatStandsOut) {
    const TemporaryFolder folder;
    const fs::path study = copy_with_its_effect(folder);
    folder.write("study/dry_2.csv", with_cells(content_of(study / "dry_2.csv"), [](auto& cells) {
                     cells[torque_column] =
                         fmt::format("{:.6g}", 1.1 * std::stod(cells[torque_column]));
                 }));
    const Session session(study, {.fidelity = fidelity_named("quick")});
    const StudyDiagnosis d = session.diagnose();
    EXPECT_THAT(texts_of(next_steps(d, {}, session.resolved(), "beads")).front(),
                testing::StartsWith("Look at dry_2.csv first"));
    expect_told({doubt_line(d)});
}

}  // namespace pendular::next_steps_test
