// A virtual laboratory with the user's cell, speeds, order and noise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "data/files/write_whole.h"
#include "data/quantities/statistics.h"
#include "data/recordings/measurements.h"
#include "sim/catalogue/effect.h"
#include "sim/lab/lab_checks.h"
#include "sim/lab/lab_like.h"
#include "sim/lab/virtual_lab.h"
#include "sim/lab/virtual_study.h"
#include "sim/runs/store/run_store.h"
#include "tests/support/app_support.h"

namespace app_laboratory_plans_test {

using namespace pendular;

/// 1 mm beads of steel in a cell of 20 and 40 mm, at two speeds.
LabPlan steel_at_speeds() {
    LabPlan plan;
    plan.friction = 0.3;
    plan.grains = {.diameter = 1e-3, .density = 7800, .poisson_ratio = 0.3};
    plan.cell = {.inner_radius = 0.02, .outer_radius = 0.04, .bead_volume = 250e-3 / 7800};
    plan.dry_normal_stresses = {500, 5000};
    plan.liquid_contents.clear();
    plan.angular_velocities = {1, 4};
    plan.replicates = 1;
    plan.fidelity = {"tiny", 130, 1000, 0.05, 1};
    plan.instrument.noise = 0;
    return plan;
}

const Workers two_workers{.threads = 2};

const LabResult& quiet_lab() {
    static const LabResult result = simulate_lab(steel_at_speeds(), two_workers);
    return result;
}

/// Readings of the study that a laboratory writes.
Measurements readings_of(const LabResult& lab, Study* read = nullptr) {
    const TemporaryFolder folder;
    const auto where = folder.path() / "study";
    write_whole_folder(where, study_files(lab));
    const Study study = read_study(where);
    if (read) *read = study;
    return read_measurements(study);
}

std::string refusal(const std::function<void(LabPlan&)>& change) {
    LabPlan plan = steel_at_speeds();
    change(plan);
    return input_error([&] { check_plan(plan); });
}

TEST(LabAtSpeeds, ShowsExactlyTheSpeedsAskedFor) {
    const Measurements found = readings_of(quiet_lab());
    ASSERT_EQ(found.readings.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        const Reading& reading = found.readings[k];
        const double speed = k % 2 == 0 ? 1 : 4;
        // Seven digits are written.
        EXPECT_NEAR(
            angular_velocity(reading.shear_rate, *reading.condition.height, quiet_lab().plan.cell),
            speed, 1e-5);
    }
}

TEST(LabAtSpeeds, SimulatesTheInertialNumberOfEachNormalStress) {
    const LabPlan& plan = quiet_lab().plan;
    std::vector<double> numbers;
    for (const LabStep& step : quiet_lab().recordings.front().steps) {
        const auto& run = step.run;
        const double fraction = run[dem::Observable::solid_fraction].value;
        // Height from V = phi A H, shear rate omega (Ri + Re)/(2 H), I = rate sqrt(m/(a s22)).
        const double area = std::numbers::pi * (0.04 * 0.04 - 0.02 * 0.02);
        const double height = 250e-3 / 7800 / fraction / area;
        const double rate = step.angular_velocity * 0.06 / (2 * height);
        const double mass = 7800 * std::numbers::pi * 1e-9 / 6;
        const double number = rate * std::sqrt(mass / (1e-3 * step.condition.normal_stress));
        // The pilot run of 65 beads knows the solid fraction to about 1 %.
        EXPECT_NEAR(run.parameters.inertial_number / number, 1, 0.03);
        EXPECT_NEAR(step.condition.inertial_number / number, 1, 1e-9);
        numbers.push_back(run.parameters.inertial_number);
        EXPECT_EQ(run.parameters.stiffness_number, plan.fidelity.stiffness_number);
    }
    ASSERT_EQ(numbers.size(), 4u);
    // Ten times the normal stress at one speed is a third of the inertial number, but for the
    // height.
    EXPECT_NEAR(numbers[0] / numbers[2], std::sqrt(10), 0.15);
}

TEST(LabAtSpeeds, TheShownHeightGivesTheShownInertialNumber) {
    LabPlan plan = steel_at_speeds();
    const Effect& offset = built_in_effect("height-offset");
    const Condition asked{.normal_stress = 1000, .inertial_number = 0.01};
    const FlowPoint flow{.stress_ratio = 0.3, .solid_fraction = 0.6};
    const double without = inertial_number_at_speed(plan, asked, 1, flow);
    plan.effects = {{&offset, {0.5e-3}}};
    const double with = inertial_number_at_speed(plan, asked, 1, flow);
    const double gap = height(0.6, plan.cell);
    EXPECT_NEAR(with / without, gap / (gap + 0.5e-3), 1e-9);
}

TEST(LabAtSpeeds, RefusesWhatCannotBeSimulated) {
    expect_told({refusal([](LabPlan& p) { p.angular_velocities = {200}; }),
                 refusal([](LabPlan& p) { p.cell.outer_radius = 0.023; }),
                 refusal([](LabPlan& p) { p.cell.bead_volume /= 20; }),
                 refusal([](LabPlan& p) { p.cell.outer_radius = 0.01; })});
}

std::vector<double> stresses(const PlannedRecording& recording) {
    std::vector<double> all;
    for (const Condition& condition : recording.conditions)
        all.push_back(condition.normal_stress);
    return all;
}

TEST(LabOrder, IsTheOneAskedFor) {
    LabPlan plan = steel_at_speeds();
    plan.dry_normal_stresses = {1000, 500, 2000, 4000, 3000};
    plan.angular_velocities = {1};
    plan.replicates = 6;
    const auto in = [&](StepOrder order) {
        plan.order = order;
        return recordings_of(plan);
    };
    using testing::ElementsAre;
    EXPECT_THAT(stresses(in(StepOrder::as_listed)[0]), ElementsAre(1000, 500, 2000, 4000, 3000));
    EXPECT_THAT(stresses(in(StepOrder::increasing)[0]), ElementsAre(500, 1000, 2000, 3000, 4000));
    EXPECT_THAT(stresses(in(StepOrder::decreasing)[0]), ElementsAre(4000, 3000, 2000, 1000, 500));
    EXPECT_THAT(stresses(in(StepOrder::up_and_down)[0]),
                ElementsAre(500, 1000, 2000, 3000, 4000, 3000, 2000, 1000, 500));
    std::set<std::vector<double>> different;
    for (const PlannedRecording& recording : in(StepOrder::random)) {
        EXPECT_THAT(stresses(recording),
                    testing::UnorderedElementsAre(500, 1000, 2000, 3000, 4000));
        different.insert(stresses(recording));
    }
    // Six orders out of 120: at least four differ but with a probability of 1e-4.
    EXPECT_GE(different.size(), 4u);
}

TEST(LabStates, AreSharedByLaboratoriesOfOtherNoiseAndFaults) {
    RunStore store(RunStore::in_memory);
    Workers workers = two_workers;
    workers.store = &store;
    LabPlan plan = steel_at_speeds();
    plan.shared_states = true;
    const LabResult first = simulate_lab(plan, workers);
    const std::size_t runs = store.size();
    EXPECT_GE(runs, 4u);
    plan.noise_seed = 77;
    plan.instrument.noise = 1;
    plan.order = StepOrder::decreasing;
    plan.effects = {{&built_in_effect("torque-gain"), {1.1}}};
    const LabResult second = simulate_lab(plan, workers);
    EXPECT_EQ(store.size(), runs);
    EXPECT_NE(study_files(first).at("dry_1.csv"), study_files(second).at("dry_1.csv"));
    plan.replicates = 2;  // a second run of each step, beside the first
    simulate_lab(plan, workers);
    EXPECT_EQ(store.size(), runs + 4);
}

TEST(LabNoise, IsWhiteOrCorrelated) {
    const auto next_row = [](double strain) {
        LabPlan plan = quiet_lab().plan;
        plan.instrument.noise = 1;
        plan.instrument.torque_correlation = strain;
        LabResult lab = quiet_lab();
        lab.plan = plan;
        const TemporaryFolder folder;
        const Recording recording =
            read_recording(folder.write("run.csv", study_files(lab).at("dry_1.csv")));
        double sum = 0, squares = 0;
        // The second half of the first step, far from the start.
        const auto mean = [&] {
            double total = 0;
            for (std::size_t k = 200; k < 400; ++k)
                total += recording.torque[k] / 200;
            return total;
        }();
        for (std::size_t k = 200; k < 399; ++k) {
            sum += (recording.torque[k] - mean) * (recording.torque[k + 1] - mean);
            squares += std::pow(recording.torque[k] - mean, 2);
        }
        return sum / squares;
    };
    // 400 rows in a strain of 20: exp(-0.05/1) = 0.95. Of 200 rows, the correlation of white noise
    // has a standard error of 0.07.
    EXPECT_NEAR(next_row(0), 0, 0.25);
    EXPECT_GT(next_row(1), 0.7);
}

TEST(LabLikeAStudy, MeasuresWhatTheStudyMeasured) {
    Study study;
    LabPlan original = steel_at_speeds();
    original.replicates = 2;
    original.instrument.noise = 1;
    original.instrument.rows = 100;
    original.instrument.torque_error = 0.03;
    original.dry_normal_stresses = {5000, 500, 2000};
    const LabResult lab = simulate_lab(original, two_workers);
    const TemporaryFolder folder;
    const auto where = folder.path() / "study";
    write_whole_folder(where, study_files(lab));
    study = read_study(where);
    std::vector<std::string> notes;
    LabPlan plan;
    plan.friction = 0.5;
    plan = plan_like(study, read_measurements(study), plan, notes);
    EXPECT_EQ(plan.friction, 0.5);
    EXPECT_NEAR(plan.grains.density, 7800, 1e-6);
    EXPECT_NEAR(plan.cell.outer_radius, 0.04, 1e-9);
    ASSERT_EQ(plan.series.size(), 1u);
    EXPECT_EQ(plan.series[0].replicates, 2);
    ASSERT_EQ(plan.series[0].steps.size(), 6u);
    const double expected[][2] = {{5000, 1}, {5000, 4}, {500, 1}, {500, 4}, {2000, 1}, {2000, 4}};
    for (std::size_t k = 0; k < 6; ++k) {
        // 0.2 % of noise from row to row.
        EXPECT_NEAR(plan.series[0].steps[k].normal_stress / expected[k][0], 1, 0.005);
        EXPECT_NEAR(plan.series[0].steps[k].angular_velocity / expected[k][1], 1, 0.005);
    }
    EXPECT_EQ(plan.instrument.rows, 100);
    EXPECT_NEAR(plan.instrument.step_strain, 20, 0.5);
    // From the scatter of two replicates of six steps, to a factor of 2.
    EXPECT_GT(plan.instrument.torque_error, 0.015);
    EXPECT_LT(plan.instrument.torque_error, 0.06);
    EXPECT_TRUE(notes.empty()) << testing::PrintToString(notes);
}

TEST(VirtualLabCommand, RefusesContradictions) {
    const TemporaryFolder folder;
    const std::string free = (folder.path() / "lab").string();
    std::vector<std::string> commands;
    for (const std::string& options :
         {std::string("--speeds \"1 rpm\" --inertial-numbers 0.01"),
          std::string("--speeds \"1 mm\""), std::string("--order sideways"),
          std::string("--like nowhere"),
          std::string("--like " PENDULAR_SOURCE_DIR "/examples/wet --speeds \"1 rpm\""),
          std::string("--correlation-strain \"0.1, 0.2\""), std::string("--torque-scatter 2"),
          std::string("--diameter \"30 mm\""), "--states " + free + "2 --store " + free + "2"})
        commands.push_back("virtual-lab " + free + " --dry " + options);
    expect_refused(commands);
}

}  // namespace app_laboratory_plans_test
