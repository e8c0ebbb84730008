// Texts of a diagnosis, from results made up for the purpose.
#include "reports/diagnosis_report.h"

#include "reports/diagnosis_table.h"
#include "reports/verdict_report.h"
#include "tests/support/golden.h"
#include "tests/support/linear_space.h"

namespace pendular::reports_diagnosis_test {

/// A refit with the only candidate of a space: its amplitude is 0.5 with this standard error.
FittedModel refit(double standard_error, bool converged) {
    FittedModel result{.chosen = {0}, .suspect = {}, .fit = {}};
    result.fit.parameters = Eigen::Vector2d(1, 0.5);
    result.fit.covariance = Eigen::Vector2d(1, standard_error * standard_error).asDiagonal();
    result.fit.converged = converged;
    return result;
}

/// Models with two effects that change four values in different ways.
LinearSpace drag_and_slip() {
    return {Eigen::MatrixXd::Ones(4, 1),
            {{.name = "drag", .values = Eigen::VectorXd::LinSpaced(4, 0, 1)},
             {.name = "slip", .values = Eigen::VectorXd::LinSpaced(4, 1, 0)}}};
}

TEST(EstimateOfAnEffect, IsThatOfTheRefitWhereOneConverged) {
    const LinearSpace space(Eigen::MatrixXd::Ones(4, 1),
                            {{.name = "drag",
                              .values = Eigen::VectorXd::LinSpaced(4, 0, 1),
                              .parameter = {.name = "amplitude",
                                            .unit = "N",
                                            .lower = 0,
                                            .upper = 10,
                                            .smallest_of_interest = 1}}});
    Diagnosis diagnosis;
    diagnosis.base.fit.parameters = Eigen::VectorXd::Ones(1);
    Finding finding;
    finding.value = 0.4, finding.standard_error = 0.02;
    const auto estimate = [&] { return estimate_of(diagnosis, finding, space); };
    EXPECT_EQ(estimate(), "400 +- 20 mN");
    diagnosis.tried = {refit(0.03, true)};
    EXPECT_EQ(estimate(), "500 +- 30 mN");
    diagnosis.tried = {refit(0.03, false)};
    EXPECT_EQ(estimate(), "400 +- 20 mN");
    diagnosis.tried = {refit(1e5, true)};  // a refit at which the effect vanishes
    expect_told({estimate()});
}

TEST(ImplausibleOffsets, AreThoseAboveAFifthOfTheLargestReading) {
    const LinearSpace space(
        Eigen::MatrixXd::Ones(4, 1),
        {{.name = "drag",
          .values = Eigen::VectorXd::LinSpaced(4, 0, 1),
          .parameter = {.name = "amplitude", .unit = "N", .lower = 0, .upper = 10}}});
    Diagnosis diagnosis;
    diagnosis.base.fit.parameters = Eigen::VectorXd::Ones(1);
    diagnosis.scan.emplace_back();
    diagnosis.effects = {"drag"};
    diagnosis.tried = {refit(0.03, true)};  // 500 mN
    const AnnularCell cell{.inner_radius = 0.01, .outer_radius = 0.02};
    const auto notes_at = [&](double force) {
        Reading reading;
        reading.condition.normal_stress = normal_stress(force, cell);
        return implausible_offsets(diagnosis, space, {reading}, cell);
    };
    expect_told(notes_at(2));
    EXPECT_THAT(notes_at(3), testing::IsEmpty());
    diagnosis.effects.clear();
    EXPECT_THAT(notes_at(2), testing::IsEmpty());
}

TEST(VerdictLine, NamesWhatCouldExplainALargeMisfitOfUntestedErrors) {
    const LinearSpace space(Eigen::MatrixXd::Ones(4, 1),
                            {{.name = "drag", .values = Eigen::VectorXd::LinSpaced(4, 0, 1)}});
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::inconclusive;
    diagnosis.effects = {"drag"};
    diagnosis.scan.emplace_back();
    diagnosis.scan.front().refitted_reduction = 480;
    diagnosis.base.fit.chi2 = 489, diagnosis.dof = 13;
    const auto line = [&] { return verdict_line(diagnosis, space, {}); };
    expect_told({line()});
    diagnosis.scan.front().refitted_reduction = 100;
    expect_told({line()});
    diagnosis.scan.front().refitted_reduction = 480;
    diagnosis.base.fit.chi2 = 20;
    expect_told({line()});
}

TEST(VerdictLine, SaysHowWellEachOfSeveralEffectsExplainsTheReadings) {
    const LinearSpace space = drag_and_slip();
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::indistinguishable;
    diagnosis.base.fit.chi2 = 400, diagnosis.dof = 100;
    diagnosis.confidence_set = {refit(0.1, true), refit(0.1, true)};
    diagnosis.confidence_set[1].chosen = {1};
    for (FittedModel& each : diagnosis.confidence_set) {
        each.fit.dof = 100, each.fit.chi2 = 90;
    }
    const auto line = [&] { return verdict_line(diagnosis, space, {}); };
    expect_told({line()});
    diagnosis.confidence_set[1].fit.chi2 = 95;
    expect_told({line()});
    diagnosis.base.lack_of_fit_p = 0.04, diagnosis.base.further_p = 0.02;
    expect_told({line()});
}

TEST(GrantedInexactness, SaysChi2WithTheExpectedOne) {
    Study stated;
    stated.model.discrepancy = usual_discrepancy;
    StudyDiagnosis study{.discrepancy = usual_discrepancy};
    study.belief.fitted.misfit = {.chi2 = 49.35, .dof = 35};
    EXPECT_EQ(granted_line(study, stated), "");
    study.discrepancy = {0.01, 0.0015};
    const std::string said = granted_line(study, stated);
    EXPECT_NE(said.find("inexact by 1 % of the stress ratio"), std::string::npos) << said;
    EXPECT_NE(said.find("chi2/dof of the same fit is 1.41"), std::string::npos) << said;
}

TEST(DiagnosisTable, SaysWhatEachEffectLeaves) {
    const LinearSpace space = drag_and_slip();
    Diagnosis diagnosis;
    diagnosis.base.fit.chi2 = 500, diagnosis.dof = 11;
    diagnosis.scan.resize(2);
    diagnosis.decisions.resize(2);
    diagnosis.scan[0].refitted_reduction = 480;
    diagnosis.scan[1].candidate = 1;
    diagnosis.scan[1].test.predicted_reduction = 100;
    EXPECT_EQ(remaining_chi2_text(diagnosis, diagnosis.scan[0], space),
              "2.00");  // one parameter more
    EXPECT_EQ(remaining_chi2_text(diagnosis, diagnosis.scan[1], space), "~40.00");
    expect_told(diagnosis_table(diagnosis, space, false));
    expect_told({diagnosis_table(diagnosis, space, true).front()});
}

TEST(VerdictLine, SaysHowAloneTheMissingEffectStands) {
    const LinearSpace space = drag_and_slip();
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::missing;
    diagnosis.complete = true;
    diagnosis.effects = {"drag"};
    diagnosis.base.fit.chi2 = 1010, diagnosis.dof = 10;
    diagnosis.tried = {refit(0.1, true), refit(0.1, true)};
    diagnosis.tried[0].chosen = {0}, diagnosis.tried[1].chosen = {1};
    diagnosis.tried[0].fit.chi2 = 9, diagnosis.tried[1].fit.chi2 = 27;
    for (FittedModel& each : diagnosis.tried)
        each.fit.dof = 9;
    diagnosis.confidence_set = {diagnosis.tried[0]};
    expect_told({verdict_line(diagnosis, space, {})});
    // Of one that fits as well, since it contains the named effect, nothing is said.
    diagnosis.tried[1].accepted = true;
    expect_told({verdict_line(diagnosis, space, {})});
    // A fit that did not converge leaves nothing known.
    diagnosis.tried[1].accepted = diagnosis.tried[1].fit.converged = false;
    expect_told({verdict_line(diagnosis, space, {})});
}

}  // namespace pendular::reports_diagnosis_test
