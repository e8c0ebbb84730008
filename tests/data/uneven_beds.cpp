// Beds that are not sheared throughout: balance of forces between side walls, and what import says.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

#include "data/recordings/checks.h"
#include "data/recordings/measurements.h"
#include "data/sheared_layer.h"
#include "data/study/study.h"
#include "data/wall_layers.h"
#include "tests/support/golden.h"
#include "tests/support/ordinary_studies.h"

namespace pendular::data_uneven_beds_test {

using testing::IsEmpty;
using testing::SizeIs;

/// Stress ratio of even shear of the grains of bench/real_cell.
double even_ratio(double inertial_number) {
    return 0.2755 + 0.93 * inertial_number;
}

WalledBed bed(double height, double width, double wall_friction, double inertial_number,
              double weight = 0) {
    return {.height = height,
            .width = width,
            .wall_friction = wall_friction,
            .weight = weight,
            .inertial_number = inertial_number,
            .stress_ratio = even_ratio(inertial_number)};
}

TEST(ShearedLayer, IsTheWholeBedWithoutWallFrictionAndWeight) {
    for (const double inertial_number : {0.001, 0.02, 0.1}) {
        const ShearedLayer layer = sheared_layer(bed(20, 24, 0, inertial_number));
        EXPECT_NEAR(layer.height, 20, 1e-6);
        EXPECT_NEAR(layer.stress_ratio, even_ratio(inertial_number), 1e-9);
    }
}

TEST(ShearedLayer, CarriesTheDragOnTheUpperHalfOfALowBed) {
    // Neighbours take each other along over the whole of a bed as low as their reach, so that the
    // mean over the depth is the ratio of even shear; at the lid half of the drag is added:
    // 2 k/w H/2 = 2 x 0.05 x 0.85/50 x 1.5.
    const ShearedLayer layer = sheared_layer(bed(3, 50, 0.05, 0.05));
    EXPECT_NEAR(layer.stress_ratio - even_ratio(0.05), 0.00255, 0.0002);
    EXPECT_NEAR(layer.height, 3, 0.01);
}

TEST(ShearedLayer, FollowsTheLocalLawInAHighBed) {
    // A fall s = 2 x 0.1 x 0.85/50 = 0.0034 per diameter makes the rate fall linearly, from that of
    // s h at the lid to 0 at the depth h: speed I H = s h^2/(2 b), h = sqrt(2 x 0.93 x 4/0.0034) =
    // 46.8. The height of equal dissipation is 3/4 of it. The reach adds a few diameters.
    const ShearedLayer layer = sheared_layer(bed(200, 50, 0.1, 0.02));
    EXPECT_NEAR(layer.height, 0.75 * 46.8, 2);
    EXPECT_NEAR(layer.stress_ratio - 0.2755, 0.0034 * 46.8, 0.003);
    // It does not know of a base at twice the depth.
    EXPECT_NEAR(sheared_layer(bed(100, 50, 0.1, 0.04)).stress_ratio, layer.stress_ratio, 0.002);
}

TEST(ShearedLayer, ThinsWithWallFrictionAndWeightAndThickensWithSpeedAndWidth) {
    const double height = sheared_layer(bed(24, 24, 0.1, 0.02)).height;
    EXPECT_LT(sheared_layer(bed(24, 24, 0.2, 0.02)).height, height - 1);
    EXPECT_LT(sheared_layer(bed(24, 24, 0.1, 0.02, 0.5)).height, height - 1);
    EXPECT_GT(sheared_layer(bed(24, 24, 0.1, 0.06)).height, height + 1);
    EXPECT_GT(sheared_layer(bed(24, 48, 0.1, 0.02)).height, height + 1);
}

TEST(ShearedLayer, IsFiniteForAnyBed) {
    for (const double inertial_number : {0.0, 1e-6, 0.3, 5.0})
        for (const double friction : {0.0, 1e-9, 1.5})
            for (const double ratio : {0.01, 0.3, 3.0}) {
                const ShearedLayer layer = sheared_layer({.height = 40,
                                                          .width = 3,
                                                          .wall_friction = friction,
                                                          .weight = 1,
                                                          .inertial_number = inertial_number,
                                                          .stress_ratio = ratio});
                EXPECT_TRUE(std::isfinite(layer.stress_ratio)) << inertial_number << ' ' << ratio;
                EXPECT_GT(layer.height, 0) << inertial_number << ' ' << friction << ' ' << ratio;
            }
}

/// State of one of the simulated cells that ship (bench/real_cell/states.csv).
struct SimulatedCell {
    double normal_stress, inertial_number, replicate, seed, strain, grain_volume, stress_ratio,
        stress_ratio_error, shown_normal_stress, gap, solid_fraction, creep, sheared_height;
};

/// Cells with a width of 24 diameters, plain grains and the given walls, as "walls 0.15, height
/// 12".
std::vector<SimulatedCell> simulated_cells(const std::string& name) {
    std::ifstream file(std::filesystem::path(PENDULAR_SOURCE_DIR) / "bench/real_cell/states.csv");
    std::vector<SimulatedCell> cells;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("\"" + name + "\",")) continue;
        std::istringstream words(line.substr(name.size() + 3));
        double values[13] = {};
        char comma = 0;
        for (double& value : values)
            words >> value >> comma;
        cells.push_back({values[0], values[1], values[2], values[3], values[4], values[5],
                         values[6], values[7], values[8], values[9], values[10], values[11],
                         values[12]});
    }
    return cells;
}

/// Bed of a simulated cell of a nominal height, with the friction that its walls mobilise: 0.09 of
/// a coefficient of 0.15.
WalledBed bed_of(const SimulatedCell& cell, double nominal_height, double wall_friction) {
    // Weight of the grains over the load: density x g x volume over area.
    const double weight = 1050 * 9.81 * cell.grain_volume * 500e-6 / cell.normal_stress;
    return bed(cell.gap, 24, 0.6 * wall_friction, cell.inertial_number * nominal_height / cell.gap,
               weight);
}

TEST(ShearedLayer, IsThatOfSimulatedCells) {
    // Beads beside flat walls lie in layers, which slide more easily. Samples of 2600 to 5300 beads
    // scatter by 1 to 3 %.
    const double ordered = 1 - strength_lost_beside_walls(24);
    for (const auto& [name, height, friction] : {std::tuple("walls 0, height 12", 12.0, 0.0),
                                                 std::tuple("walls 0.15, height 12", 12.0, 0.15),
                                                 std::tuple("walls 0.15, height 24", 24.0, 0.15)}) {
        const std::vector<SimulatedCell> cells = simulated_cells(name);
        EXPECT_GE(cells.size(), 4u) << name;
        for (const SimulatedCell& cell : cells) {
            const ShearedLayer layer = sheared_layer(bed_of(cell, height, friction));
            EXPECT_NEAR(ordered * layer.stress_ratio / cell.stress_ratio, 1, 0.08) << name;
            // A third too high in a high bed and a fast lid (docs/explanation/cell.md).
            if (height > 12 && cell.inertial_number > 0.02) continue;
            EXPECT_NEAR(layer.height / cell.sheared_height, 1, 0.25) << name;
            const bool even = layer.height >= 0.92 * cell.gap;  // import does not warn
            EXPECT_EQ(even, friction == 0) << name;
        }
    }
}

/// Mean over the states of a cell without wall friction of the stress ratio at the lid over that
/// without layers along the walls.
double mean_strength(const std::string& name) {
    double sum = 0, count = 0;
    for (const SimulatedCell& cell : simulated_cells(name)) {
        sum += cell.stress_ratio / sheared_layer(bed_of(cell, 12, 0)).stress_ratio;
        ++count;
    }
    return sum / count;
}

TEST(WallLayers, LearntFromNarrowCellsHoldInOnesTwiceAsWide) {
    // Standard errors of the means: 0.02 and 0.007. Without layers, both would be 1.
    EXPECT_NEAR(mean_strength("narrow, walls 0, height 12"), 1 - strength_lost_beside_walls(12),
                0.04);
    EXPECT_NEAR(mean_strength("walls 0, height 12"), 1 - strength_lost_beside_walls(24), 0.014);
}

/// A study of one recording of 300 rows, whose gap of 4 mm changes by `change`, in a cell with
/// further lines in [cell].
struct OneRecording {
    explicit OneRecording(double change, const std::string& of_cell = "",
                          const std::string& rest = "") {
        std::mt19937_64 random(7);
        const auto torque = autoregressive(300, 0.5, random),
                   gap = autoregressive(300, 0.5, random);
        std::string text = recording_header;
        for (std::size_t i = 0; i < 300; ++i)
            text += fmt::format("{},{},5,{},0.1\n", 0.1 * static_cast<double>(i),
                                30 * (1 + 0.01 * torque[i]),
                                4 * (1 + 0.001 * gap[i] + change * static_cast<double>(i) / 299));
        folder.write("dry.csv", text);
        folder.write("study.toml", grains_table + cell_table("10 g") + of_cell +
                                       "[[recording]]\nfile = \"dry.csv\"\n" + rest);
    }
    Measurements measured() const { return read_measurements(read_study(folder.path())); }
    std::vector<Remark> doubts(Remark::Kind kind) const {
        std::vector<Remark> found = measured().doubts();
        std::erase_if(found, [&](const Remark& doubt) { return doubt.kind != kind; });
        return found;
    }
    TemporaryFolder folder;
};

TEST(CreepingGap, IsADoubtThatKeepsTheTorque) {
    const OneRecording creeps(-0.01);
    const auto doubts = creeps.doubts(Remark::Kind::creeping_gap);
    ASSERT_THAT(doubts, SizeIs(1));
    EXPECT_EQ(doubts[0].outcome, Remark::Outcome::kept);
    expect_told({text_of(doubts[0])});
    const Reading reading = creeps.measured().readings.at(0);
    EXPECT_LT(std::sqrt(reading.covariance(0, 0)) / reading.value(0), 0.03);
    EXPECT_GE(reading.covariance(1, 1), 0.01);
    EXPECT_THAT(OneRecording(0).doubts(Remark::Kind::creeping_gap), IsEmpty());
}

TEST(CreepingGap, IsReadBackFromATableOfReadings) {
    const OneRecording creeps(-0.01);
    const Measurements measured = creeps.measured();
    const auto table = creeps.folder.path() / "readings.csv";
    write_readings(table, measured);
    const auto read = read_points(table, {}, read_study(creeps.folder.path())).readings;
    ASSERT_THAT(read, SizeIs(1));
    EXPECT_TRUE(read[0].fraction_unknown());
    EXPECT_EQ(read[0].condition.gap_creep, measured.readings[0].condition.gap_creep);
    EXPECT_THAT(creeping_gaps(read), SizeIs(1));
}

TEST(UnevenShear, IsToldWhereTheStatedWallsGatherTheShear) {
    // 8 diameters high, 48 wide, slow: walls of friction 0.3, of which 0.13 act, let the stress
    // ratio fall by 0.005 per diameter, and leave a layer of twice (0.16/0.005)^(1/3) = 3.2
    // diameters.
    const auto told = [](const std::string& of_cell, const std::string& rest = "") {
        return OneRecording(0, of_cell, rest).doubts(Remark::Kind::uneven_shear);
    };
    const auto rough = told("wall_friction = 0.3\n");
    ASSERT_THAT(rough, SizeIs(1));
    expect_told({text_of(rough[0])});
    EXPECT_FALSE(rough[0].of_weight);
    EXPECT_THAT(told("wall_friction = 0.01\n"), IsEmpty());
    EXPECT_THAT(told(""), IsEmpty());  // nobody knows the walls
    EXPECT_THAT(told("wall_friction = 0.3\n", "[model]\neffects = [\"shear-localisation\"]\n"),
                IsEmpty());
}

TEST(FewBeads, SaysFromWhichFrictionOnUnknownWallsGatherTheShear) {
    const auto noted = [](const std::string& of_cell, double normal_stress) {
        const OneRecording recording(0, of_cell);
        Study study = read_study(recording.folder.path());
        study.grains.diameter = 1e-3;  // walls 24 diameters apart
        Reading reading = recording.measured().readings.at(0);
        reading.value(0) *= normal_stress / reading.condition.normal_stress;
        reading.condition.normal_stress = normal_stress;
        return few_beads(study, {reading});
    };
    const auto unknown = noted("", 3000);
    ASSERT_THAT(unknown, SizeIs(1));
    EXPECT_GT(unknown[0].limit, 0);
    EXPECT_LT(unknown[0].limit, 0.5);
    const auto heavy = noted("", 20);
    ASSERT_THAT(heavy, SizeIs(1));
    EXPECT_EQ(heavy[0].limit, 0);  // the weight alone
    expect_told({text_of(unknown[0]), text_of(heavy[0])});
    const auto stated = noted("wall_friction = 0.1\n", 3000);
    ASSERT_THAT(stated, SizeIs(1));
    EXPECT_TRUE(std::isinf(stated[0].limit));
}

TEST(UnevenShear, IsThatOfTheWeightBetweenSmoothWalls) {
    const OneRecording light(0, "wall_friction = 0\n");
    const Study study = read_study(light.folder.path());
    Reading heavy = light.measured().readings.at(0);
    EXPECT_THAT(uneven_shear(study, {heavy}), IsEmpty());
    heavy.condition.normal_stress = 100;
    heavy.value(0) = 30;
    heavy.condition.height = 0.02;
    heavy.condition.bead_volume = 0.6 * study.cell->area() * 0.02;
    const auto told = uneven_shear(study, {heavy});
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_TRUE(told[0].of_weight);
    expect_told({text_of(told[0])});
}

TEST(UnevenShear, SaysWhatIsAddedToEvenShearOfTheGrains) {
    // The lid shows what the layer of some grains dictates; the doubt tells how far that is above
    // the ratio of these grains in even shear, not above what the lid shows.
    const OneRecording walls(0, "wall_friction = 0.3\n");
    const Study study = read_study(walls.folder.path());
    Reading reading = walls.measured().readings.at(0);
    const Condition& c = reading.condition;
    const double diameter = study.grains.diameter, area = study.cell->area();
    const WalledBed grains{
        .height = *c.height / diameter,
        .width = (study.cell->outer_radius - study.cell->inner_radius) / diameter,
        .wall_friction = 0.9 * 0.3 / (1 + 3.6 * 0.3),
        .weight = *c.bead_volume * study.grains.density * gravity / area / c.normal_stress,
        .inertial_number = c.inertial_number,
        .stress_ratio = 0.3};
    const double at_lid = sheared_layer(grains).stress_ratio;
    ASSERT_GT(at_lid, 0.305);
    reading.value(0) = at_lid * c.normal_stress;
    const auto told = uneven_shear(study, {reading});
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_NEAR(told[0].relative, at_lid / 0.3 - 1, 1e-4);
}

TEST(UnevenShear, TakesAWallFrictionThatIsNoAngle) {
    expect_told({input_error([] { OneRecording(0, "wall_friction = 12\n").measured(); }),
                 input_error([] { OneRecording(0, "wall_friction = -0.1\n").measured(); }),
                 input_error([] { OneRecording(0, "wall_friction = \"0.1 Pa\"\n").measured(); })});
}

}  // namespace pendular::data_uneven_beds_test
