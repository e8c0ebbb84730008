// The virtual laboratory from end to end, on samples too small and soft to measure with.
#include "data/recordings/measurements.h"
#include "sim/lab/lab_checks.h"
#include "sim/lab/virtual_lab.h"
#include "sim/lab/virtual_study.h"
#include "sim/runs/run_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "calib/model/run_planner.h"
#include "data/files/write_whole.h"
#include "sim/lab/lab_plan.h"
#include "sim/runs/run_settings.h"
#include "tests/support/app_support.h"
#include "workflow/json/run.h"

namespace sim_virtual_lab_test {

using namespace pendular;
using testing::HasSubstr;
using testing::Not;

const Fidelity tiny{"tiny", 130, 1000, 0.05, 1};

LabPlan small_plan() {
    LabPlan plan;
    plan.friction = 0.31;
    plan.dry_normal_stresses = {300, 3000};
    plan.wet_normal_stresses = {600};
    plan.liquid_contents = {0.02};
    plan.inertial_numbers = {0.1, 0.2};
    plan.fidelity = tiny;
    plan.seed = 5;
    return plan;
}

const Workers two_workers{.threads = 2};

/// One laboratory for all tests that only look at it: noise 0.
const LabResult& quiet_lab() {
    static const LabResult result = [] {
        LabPlan plan = small_plan();
        plan.instrument.noise = 0;
        return simulate_lab(plan, two_workers);
    }();
    return result;
}

std::map<std::string, std::string> files_with_truth(const LabResult& result) {
    auto files = study_files(result);
    files["truth.json"] = to_json(result).dump();
    return files;
}

std::string refusal(const std::function<void(LabPlan&)>& change) {
    LabPlan plan = small_plan();
    change(plan);
    return input_error([&] { check_plan(plan); });
}

TEST(VirtualLab, IsReadBackAsItWasSimulated) {
    const LabResult& lab = quiet_lab();
    const TemporaryFolder folder;
    const auto study = folder.path() / "study";
    write_whole_folder(study, files_with_truth(lab));
    const Measurements found = read_measurements(read_study(study));
    std::vector<LabStep> steps;
    for (const LabRecording& recording : lab.recordings) {
        steps.insert(steps.end(), recording.steps.begin(), recording.steps.end());
    }
    ASSERT_EQ(steps.size(), 12u);
    ASSERT_EQ(found.readings.size(), steps.size());
    EXPECT_EQ(found.left_out().size(), steps.size());  // the transient of each
    for (std::size_t k = 0; k < steps.size(); ++k) {
        // Seven digits are written.
        const Reading& reading = found.readings[k];
        const dem::RunResult& run = steps[k].run;
        EXPECT_NEAR(reading.stress_ratio(), run[dem::Observable::stress_ratio].value, 1e-6);
        EXPECT_NEAR(reading.value(1), run[dem::Observable::solid_fraction].value, 1e-6);
        EXPECT_NEAR(reading.condition.normal_stress, steps[k].condition.normal_stress, 1e-3);
        EXPECT_NEAR(reading.condition.inertial_number, run.parameters.inertial_number, 1e-6);
        EXPECT_EQ(reading.condition.liquid_content, steps[k].condition.liquid_content);
        EXPECT_EQ(reading.replicates, 2);
    }
}

TEST(VirtualLab, GivesEachStepARunOfItsOwn) {
    std::set<std::uint64_t> seeds;
    std::size_t runs = 0;
    for (const LabRecording& recording : quiet_lab().recordings) {
        for (const LabStep& step : recording.steps) {
            const auto& p = step.run.parameters;
            seeds.insert(p.seed);
            ++runs;
            EXPECT_EQ(p.grains, 195);  // 1.5 x the fidelity's
            EXPECT_EQ(p.stiffness_number, tiny.stiffness_number);
            EXPECT_EQ(p.strain, tiny.strain);
            EXPECT_EQ(p.friction, 0.31);
            EXPECT_EQ(p.wetting.has_value(), recording.liquid_content > 0);
            EXPECT_TRUE(step.run.steady);
            EXPECT_FALSE(step.run.crystallised);
        }
    }
    EXPECT_EQ(seeds.size(), runs);
}

TEST(VirtualLab, ReachesTheLiquidContentsAskedFor) {
    for (const LabRecording& recording : quiet_lab().recordings) {
        for (const LabStep& step : recording.steps) {
            if (step.condition.dry()) continue;
            // The pilots of 65 beads are known to no better than some percent.
            EXPECT_NEAR(step.run[dem::Observable::liquid_content].value, 0.02, 0.05 * 0.02);
            // 0.6 kPa over 0.1294 kPa, where P* = 1 (pi Gamma/a).
            EXPECT_NEAR(step.run.parameters.wetting->reduced_pressure, 4.636, 0.002);
        }
    }
}

TEST(VirtualLab, SharesNoRunWithACalibrationOfTheSameSeed) {
    Study study;
    study.grains = small_plan().grains;
    const RunPlanner fit(study, {{.normal_stress = 300, .inertial_number = 0.2}}, tiny,
                         small_plan().seed, two_workers, {});
    const auto& runs = fit.simulation()->emulator().runs();
    ASSERT_FALSE(runs.empty());
    for (const auto& fitted : runs) {
        for (const LabRecording& recording : quiet_lab().recordings) {
            for (const LabStep& step : recording.steps) {
                EXPECT_NE(step.run.parameters.seed, fitted.parameters.seed);
                EXPECT_NE(step.run.parameters.grains, fitted.parameters.grains);
            }
        }
    }
}

TEST(Seeds, OfDifferentPurposesNeverMeet) {
    for (const std::uint64_t seed : {0ull, 1ull, 7ull, 1ull << 40}) {
        std::set<std::uint64_t> seen;
        constexpr std::uint64_t runs = 10'000;
        for (std::uint64_t run = 0; run < runs; ++run) {
            for (const auto domain :
                 {SeedDomain::calibration, SeedDomain::instrument, SeedDomain::virtual_lab}) {
                seen.insert(seed_of_run(seed, run, domain));
            }
        }
        EXPECT_EQ(seen.size(), 3 * runs);
    }
}

TEST(VirtualLab, NeverShowsItsTruth) {
    const auto files = study_files(quiet_lab());
    EXPECT_THAT(files.at("study.toml"), Not(HasSubstr("truth")));
    EXPECT_THAT(files.at("study.toml"), Not(HasSubstr("0.31")));
    const TemporaryFolder folder;
    const auto study = folder.path() / "study";
    write_whole_folder(study, files_with_truth(quiet_lab()));
    for (const Source& source : read_study(study).sources) {
        for (const auto& file : source.files) {
            EXPECT_NE(file.filename(), "truth.json");
        }
    }
    // A broken truth is not even noticed, and without one all is the same.
    const auto import = [&] {
        const Outcome outcome = run_pendular("import --json - " + study.string());
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return outcome.output;
    };
    const std::string with_truth = import();
    write_whole(study / "truth.json", "{ not json");
    EXPECT_EQ(import(), with_truth);
    std::filesystem::remove(study / "truth.json");
    EXPECT_EQ(import(), with_truth);
}

TEST(VirtualLab, NamesItsTruthNowhereButWhereItIsWritten) {
    namespace fs = std::filesystem;
    const fs::path root = PENDULAR_SOURCE_DIR;
    std::vector<std::string> naming;
    for (const std::string folder :
         {"data", "sim", "calib", "analysis", "workflow", "reports", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.is_regular_file() &&
                content_of(entry.path()).find("truth.json") != std::string::npos) {
                naming.push_back(entry.path().filename().string());
            }
        }
    }
    // The command writes it, and the report tells the user that it is there.
    EXPECT_THAT(naming, testing::UnorderedElementsAre("virtual_lab.cpp", "lab_report.cpp"));
}

TEST(VirtualLab, HasItsTruthInFull) {
    const auto truth = to_json(quiet_lab());
    EXPECT_EQ(truth["friction"], 0.31);
    EXPECT_EQ(truth["plan"]["seed"], 5);
    ASSERT_EQ(truth["recordings"].size(), 4u);
    const auto& step = truth["recordings"][3]["steps"][1];
    EXPECT_EQ(step["liquid_content"], 0.02);
    EXPECT_EQ(step["run"]["seed"], quiet_lab().recordings[3].steps[1].run.parameters.seed);
    EXPECT_GT(step["run"]["stress_ratio"]["value"], 0.1);
}

TEST(VirtualLab, RefusesWhatItCannotDoBeforeSimulating) {
    expect_told({refusal([](LabPlan& p) { p.friction = -0.1; }),
                 refusal([](LabPlan& p) { p.inertial_numbers = {0.7}; }), refusal([](LabPlan& p) {
                     p.inertial_numbers = {0.1, 0.101};
                 }),
                 refusal([](LabPlan& p) { p.dry_normal_stresses = {-300}; }),
                 refusal([](LabPlan& p) { p.dry_normal_stresses.clear(); }),
                 refusal([](LabPlan& p) { p.wet_normal_stresses = {1}; }),
                 refusal([](LabPlan& p) { p.liquid_contents = {30}; }),
                 refusal([](LabPlan& p) { p.liquid_contents = {std::nan("")}; }),
                 refusal([](LabPlan& p) { p.replicates = 0; }),
                 refusal([](LabPlan& p) { p.instrument.noise = -1; }),
                 refusal([](LabPlan& p) { p.instrument.rows = 10; }),
                 refusal([](LabPlan& p) { p.cell.bead_volume = 1e-6; })});
    EXPECT_NO_THROW(check_plan(small_plan()));
}

TEST(VirtualLab, GivesUpOnAConditionThatOnlyCrystallises) {
    // Frictionless beads in so small a box order within a strain of some tens, whatever the seed.
    LabPlan plan = small_plan();
    plan.friction = 0;
    plan.dry_normal_stresses = {300};
    plan.liquid_contents.clear();
    plan.inertial_numbers = {0.1};
    plan.replicates = 1;
    plan.fidelity = {"tiny", 43, 100, 0.1, 60};
    try {
        simulate_lab(plan, two_workers);
        FAIL() << "no SimulationError";
    } catch (const dem::SimulationError& error) {
        expect_told({error.what()});
    }
}

ActiveEffect active(const std::string& name, double value) {
    return {&built_in_effect(name), {value}};
}

/// One dry step and, if asked for, one wet one, noise 0.
LabPlan plan_with(const std::vector<ActiveEffect>& effects, bool wet = false) {
    LabPlan plan = small_plan();
    plan.instrument.noise = 0;
    plan.dry_normal_stresses = {1000};
    plan.inertial_numbers = {0.2};
    plan.replicates = 1;
    if (!wet) plan.liquid_contents.clear();
    plan.effects = effects;
    return plan;
}

struct Imported {
    LabResult lab;
    std::vector<Reading> readings;
};

Imported imported(const LabPlan& plan) {
    Imported result{simulate_lab(plan, two_workers), {}};
    const TemporaryFolder folder;
    const auto study = folder.path() / "study";
    write_whole_folder(study, files_with_truth(result.lab));
    result.readings = read_measurements(read_study(study)).readings;
    return result;
}

/// Imposed condition of a plan's only dry step, or of its only wet one.
EffectiveCondition imposed(const LabPlan& plan, bool wet) {
    return imposed_condition(plan, recordings_of(plan).at(wet ? 1 : 0).conditions.at(0));
}

TEST(LabWithEffects, ShowsADragAsAShearStress) {
    const Imported without = imported(plan_with({}));
    const Imported with = imported(plan_with({active("torque-offset", 1e-3)}));
    ASSERT_EQ(with.readings.size(), 1u);
    // The beads are the same; 3 T/(2 pi (Re^3 - Ri^3)) is on top. Seven digits are written.
    const double radii = std::pow(0.045, 3) - std::pow(0.021, 3);
    EXPECT_NEAR(with.readings[0].value(0) - without.readings[0].value(0),
                3 * 1e-3 / (2 * 3.14159265358979 * radii), 1e-3);
    EXPECT_NEAR(with.readings[0].value(1), without.readings[0].value(1), 1e-6);
    EXPECT_EQ(study_files(with.lab).at("study.toml"), study_files(without.lab).at("study.toml"));
    EXPECT_EQ(to_json(with.lab)["effects"].dump(), R"({"torque-offset.torque":0.001})");
}

TEST(LabWithEffects, ShowsTheTrueStateAtTheSetPointsAskedFor) {
    const Imported found = imported(
        plan_with({active("bead-loss", 0.1), active("grain-weight", 1), active("lid-slip", 0.3),
                   active("height-offset", 5e-4), active("wall-friction", 0.2)}));
    ASSERT_EQ(found.readings.size(), 1u);
    const Reading& reading = found.readings[0];
    const LabStep& step = found.lab.recordings[0].steps[0];
    EXPECT_NEAR(reading.condition.normal_stress, 1000, 1e-3);
    EXPECT_NEAR(reading.condition.inertial_number, 0.2, 1e-6);
    // By hand, from the simulated solid fraction and stress ratio: what the instrument shows.
    const AnnularCell& cell = found.lab.plan.cell;
    const double grains = 0.9 * cell.bead_volume;
    const double gap = grains / (cell.area() * step.run[dem::Observable::solid_fraction].value);
    const double k = 0.2 * 0.937 * gap / 0.024;
    const double force = 1000 * cell.area() / std::exp(0.09 * k) + grains * 1050 * 9.80665 / 2;
    const double torque_at_middle =
        step.run[dem::Observable::stress_ratio].value * torque(force / cell.area(), cell);
    const double lighter = force - grains * 1050 * 9.80665 / 2;
    // Of wall friction, the share that acts along the flow in the upper half; I = 0.15 and more.
    const double x = gap / 500e-6 / (3.8 * std::pow(5, -0.16));
    const double along = 2 / x * std::log(std::cosh(x) / std::cosh(x / 2));
    const double at_lid =
        torque_at_middle + along * k * lighter * (0.021 * 0.021 + 0.045 * 0.045) / (0.021 + 0.045);
    EXPECT_NEAR(reading.value(0) / shear_stress(at_lid, cell), 1, 1e-6);
    EXPECT_NEAR(reading.value(1), solid_fraction(gap + 5e-4, cell), 1e-6);
    // The run was made within 1 % of the true state's stress and inertial number.
    const double stress = force / cell.area();
    EXPECT_NEAR(step.imposed.normal_stress / stress, 1, 0.01);
    const double slower = 0.7 * (gap + 5e-4) / gap * std::sqrt(1000 / stress);
    EXPECT_NEAR(step.run.parameters.inertial_number / (0.2 * slower), 1, 0.01);
}

TEST(LabWithEffects, LosesLiquidAsTimeGoesOn) {
    LabPlan plan = plan_with({active("liquid-loss", 0.05)}, true);
    plan.replicates = 2;
    plan.inertial_numbers = {0.02, 0.2};
    const auto recordings = recordings_of(plan);
    double last = 1;
    for (const PlannedRecording& recording : recordings) {
        for (const Condition& asked : recording.conditions) {
            const EffectiveCondition truth = imposed_condition(plan, asked);
            EXPECT_DOUBLE_EQ(truth.liquid_content,
                             asked.liquid_content * std::exp(-0.05 * asked.time));
            if (truth.dry()) continue;
            EXPECT_LT(truth.liquid_content, last);
            last = truth.liquid_content;
        }
    }
    EXPECT_LT(last, 0.0195);
}

TEST(LabWithEffects, PlansTheTimesThatImportFinds) {
    LabPlan plan = plan_with({active("liquid-loss", 0.05)}, true);
    plan.replicates = 2;
    const Imported found = imported(plan);
    ASSERT_EQ(found.readings.size(), 4u);
    double duration = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const LabStep& step = found.lab.recordings[k].steps[0];
        duration = found.readings[k].sampled_seconds;
        // Up to a transient of a strain of 2, where half of one is planned with.
        EXPECT_NEAR(found.readings[k].condition.time, step.condition.time, 1.5 / 20 * duration);
        EXPECT_EQ(found.readings[k].condition.liquid_content, k < 2 ? 0 : 0.02);
        if (k < 2) continue;
        // The pilots look for the true content; those of 65 beads know it to some percent.
        EXPECT_NEAR(step.run[dem::Observable::liquid_content].value / step.imposed.liquid_content,
                    1, 0.05);
    }
    EXPECT_GT(found.readings[3].condition.time, found.readings[0].condition.time + 2 * duration);
}

TEST(LabWithEffects, GivesWetBeadsWhatTouchesThem) {
    const LabPlan without = plan_with({}, true);
    const auto run = [&](const std::string& name, double value, bool wet) {
        const LabPlan plan = plan_with({active(name, value)}, true);
        return run_at(plan, imposed(plan, wet), 1e-3);
    };
    const auto wet = run_at(without, imposed(without, true), 1e-3);
    const auto dry = run_at(without, imposed(without, false), 1e-3);
    EXPECT_EQ(run("wet-friction", 0.05, true).friction, 0.31 + 0.05);
    EXPECT_EQ(run("wet-friction", 0.05, false).friction, 0.31);
    EXPECT_NEAR(run("contact-angle", 0.5, true).wetting->reduced_pressure,
                wet.wetting->reduced_pressure / std::cos(0.5), 1e-12);
    EXPECT_NEAR(run("capillary-bridges", 41.2e-3, true).wetting->reduced_pressure,
                wet.wetting->reduced_pressure / 2, 1e-12);
    EXPECT_FALSE(run("capillary-bridges", 0, true).wetting);
    for (const char* name : {"contact-angle", "capillary-bridges"}) {
        EXPECT_EQ(run_description(run(name, 0.3, false)), run_description(dry)) << name;
    }
}

TEST(LabWithEffects, IsTheSameBitForBitAtNeutral) {
    LabPlan plan = small_plan();
    plan.instrument.noise = 0;
    for (const Effect& effect : built_in_effects()) {
        if (effect.of_instrument() && !effect.of_table())
            plan.effects.push_back({&effect, effect.neutral()});
    }
    const auto with = study_files(simulate_lab(plan, two_workers));
    EXPECT_EQ(with, study_files(quiet_lab()));
}

TEST(LabWithEffects, RefusesWhatItCannotHave) {
    const auto refused = [](const ActiveEffect& effect, bool wet) {
        return input_error([&] { check_plan(plan_with({effect}, wet)); });
    };
    expect_told({refused(active("wet-friction", 0.1), false),
                 refused(active("capillary-shear-stress", 1), true),
                 refused(active("normal-force-offset", 9), false),
                 refused(active("wet-friction", -0.5), true)});
    // The laboratory's contact angle is 0 and cannot become smaller.
    expect_told({refused(active("contact-angle", -0.1), true)});
    EXPECT_NO_THROW(check_plan(plan_with({active("capillary-bridges", 20.6e-3)}, true)));
}

TEST(LabWithEffects, TakesAnEffectThatBeginsWithTime) {
    const Effect wear{.name = "wear",
                      .parameters = {{.name = "rise"}},
                      .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                          condition.friction_difference += v["rise"] * condition.time / 3600;
                          return condition;
                      }}};
    EXPECT_NO_THROW(check_plan(plan_with({{&wear, {0.1}}})));
}

/// Liquid contents of samples whose coordination is Z = z (V0/a^3)^slope, and how many were asked.
struct Samples {
    double z = 7.5, slope = 0;
    std::size_t asked = 0;

    MeasureLiquidContents measure() {
        return [this](std::span<const std::size_t> which, std::span<const double> volumes) {
            asked += which.size();
            std::vector<double> contents;
            for (const double v : volumes) {
                contents.push_back(dem::liquid_content(v, z * std::pow(v, slope)));
            }
            return contents;
        };
    }
};

TEST(BridgeVolumes, GiveTheLiquidContentsAskedFor) {
    const std::vector<double> contents = {0.007, 0.03};
    const auto reached = [&](Samples samples, double tolerance) {
        const auto volumes = bridge_volumes(contents, samples.measure());
        const auto found = samples.measure()(std::vector<std::size_t>{0, 1}, volumes);
        for (std::size_t k = 0; k < contents.size(); ++k) {
            EXPECT_NEAR(found[k] / contents[k], 1, tolerance);
        }
    };
    // A coordination that does not depend on volume is corrected for at once, and exactly.
    reached({.z = 5.0}, 1e-12);
    // Z as measured, growing by 3.5 % where V0 doubles, at twice the usual coordination.
    reached({.z = 20, .slope = 0.05}, 0.03);
    // A coordination that follows the volume far more than any does: the secant is exact.
    reached({.z = 60, .slope = 0.2}, 1e-9);
}

TEST(BridgeVolumes, TakeAsFewPilotsAsTheyNeed) {
    const std::vector<double> contents = {0.007, 0.03};
    Samples usual, other{.z = 6};
    bridge_volumes(contents, usual.measure());
    EXPECT_EQ(usual.asked, 2u);
    bridge_volumes(contents, other.measure());
    EXPECT_EQ(other.asked, 4u);
}

}  // namespace sim_virtual_lab_test
