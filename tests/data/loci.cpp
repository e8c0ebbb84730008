// Yield loci after several preshears, wall yield loci, and instruments with a lever.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include "data/recordings/file_view.h"
#include "data/recordings/locus_table.h"
#include "data/recordings/recording.h"
#include "data/recordings/test_kinds.h"
#include "tests/support/golden.h"

namespace pendular::data_loci_test {

using testing::SizeIs;
using testing::StartsWith;

/// Preshears of 990, 1000 and 1010 Pa, of which prorating takes 1000: points that lie on 100 Pa +
/// 0.4 s after it are recorded times 0.99, 1 and 1.01.
const std::string unequal =
    "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa],Bulk density [kg/m^3]\n"
    "2000,990,500,297,1490\n2000,1000,1000,500,1500\n2000,1010,1500,707,1510\n";

TEST(Prorating, TakesOutHowUnequallySamplesWereConsolidated) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", unequal);
    FileFormat format;
    const YieldLocus as_written = view_of_file(path, format).loci.at(0);
    EXPECT_FALSE(as_written.prorated);
    EXPECT_NEAR(as_written.points[0].prorating.value(), 1000.0 / 990, 1e-12);
    format.prorate = true;
    const YieldLocus locus = view_of_file(path, format).loci.at(0);
    EXPECT_TRUE(locus.prorated);
    EXPECT_NEAR(locus.line->cohesion, 100, 1e-9);
    EXPECT_NEAR(std::tan(locus.line->slope_angle), 0.4, 1e-12);
    EXPECT_GT(std::abs(as_written.line->cohesion - 100), 1);
}

TEST(Preshears, OfATableAreAveragedWithTheErrorOfTheirMean) {
    const TemporaryFolder folder;
    const PreshearPoint mean =
        view_of_file(folder.write("t.csv", unequal)).loci.at(0).preshear.value();
    EXPECT_NEAR(mean.shear_stress, 1000, 1e-9);
    EXPECT_NEAR(mean.shear_stress_error.value(), 10 / std::sqrt(3), 1e-9);
    EXPECT_NEAR(mean.bulk_density.value(), 1500, 1e-9);
    // A value that is repeated in each row is one preshear, whose error is not known.
    std::string equal = "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa]\n";
    for (const double s : {500, 1000, 1500})
        equal += fmt::format("2000,1000,{},{}\n", s, 100 + 0.4 * s);
    const YieldLocus same = view_of_file(folder.write("e.csv", equal)).loci.at(0);
    EXPECT_FALSE(same.preshear->shear_stress_error);
    EXPECT_FALSE(same.points[0].prorating);
}

/// A shear stress that one row lacks, and the sign of a tester that turns the other way.
TEST(Preshears, OfATableLackAValueAndHaveEitherSign) {
    const TemporaryFolder folder;
    const std::string header = "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa]\n";
    const PreshearPoint mean =
        view_of_file(folder.write("b.csv", header + "2000,,500,297\n2000,1000,1000,500\n" +
                                               "2000,1010,1500,707\n"))
            .loci.at(0)
            .preshear.value();
    EXPECT_NEAR(mean.shear_stress, 1005, 1e-9);
    EXPECT_NEAR(mean.shear_stress_error.value(), 5, 1e-9);
    const auto locus = [&](int sign) {
        std::string text = header;
        for (const double s : {500, 1000, 1500})
            text += fmt::format("2000,{},{},{}\n", sign * 1000, s, sign * (100 + 0.4 * s));
        return view_of_file(folder.write("s.csv", text)).loci.at(0);
    };
    EXPECT_EQ(locus(-1).preshear->shear_stress, 1000);
    EXPECT_NEAR(*locus(-1).line->flowability, *locus(1).line->flowability, 1e-9);
}

/// The major principal stress of points that lie on a line without scatter about it is as uncertain
/// as the preshear makes it: by its derivative, from a change by hand.
TEST(Preshears, AddTheirErrorToThatOfTheMajorPrincipalStress) {
    // Residuals +1, -1, -1, +1 about 100 + 0.4 s.
    const std::vector<double> s = {0, 1000, 2000, 3000}, t = {101, 499, 899, 1301};
    PreshearPoint preshear{4000, 1500};  // below the line, as steady shear is
    const LinearYieldLocus without = linear_yield_locus(s, t, preshear);
    preshear.shear_stress_error = 20;
    const LinearYieldLocus with = linear_yield_locus(s, t, preshear);
    const auto principal = [&](double shear) {
        return *linear_yield_locus(s, t, PreshearPoint{4000, shear}).major_principal_stress;
    };
    const double by_preshear = 20 * (principal(1500.5) - principal(1499.5));
    EXPECT_GT(by_preshear, 20);
    EXPECT_NEAR(with.errors->major_principal_stress,
                std::hypot(without.errors->major_principal_stress, by_preshear),
                1e-3 * by_preshear);
    EXPECT_NEAR(with.errors->cohesion, without.errors->cohesion, 1e-12);
}

TEST(WallLocus, HasTheAngleOfWallFrictionWithItsError) {
    const TemporaryFolder folder;
    // Residuals +2, -2, -2, +2 about 0.3 s at s = 1000, 2000, 3000, 4000, orthogonal to 1 and s:
    // the best line is 0.3 s with variance 16/2 = 8; mean 2500, squares 5e6.
    const FileView view =
        view_of_file(folder.write("t.csv",
                                  "Wandnormalspannung [Pa];Wandschubspannung "
                                  "[Pa]\n1000;302\n2000;598\n3000;898\n4000;1202\n"));
    EXPECT_TRUE(view.loci.empty());
    ASSERT_THAT(view.walls, SizeIs(1));
    const WallLocus& wall = view.walls[0];
    EXPECT_NEAR(wall.slope, 0.3, 1e-12);
    EXPECT_NEAR(wall.adhesion, 0, 1e-9);
    EXPECT_NEAR(wall.coefficient, 0.3, 1e-12);
    EXPECT_NEAR(wall.errors->slope, std::sqrt(8 / 5e6), 1e-9);
    EXPECT_NEAR(wall.errors->adhesion, std::sqrt(8 * (0.25 + 2500.0 * 2500 / 5e6)), 1e-9);
    EXPECT_NEAR(wall.errors->coefficient, std::sqrt(16.0 / 3 / 30e6), 1e-9);
    EXPECT_FALSE(wall.adheres());
}

/// Residuals +2, -2, -2, +2 about a + 0.3 s at s = 1000, 2000, 3000, 4000: the error of a is 3.46
/// Pa with two degrees of freedom, of which Student's t is 4.30.
TEST(WallLocus, AdheresByStudentsTAndNeverBelowZero) {
    const TemporaryFolder folder;
    const auto wall = [&](double adhesion) {
        std::string text = "Wall normal stress [Pa],Wall shear stress [Pa]\n";
        for (const int k : {1, 2, 3, 4})
            text += fmt::format("{},{}\n", 1000 * k, adhesion + 300 * k + (k % 3 == 1 ? 2 : -2));
        return view_of_file(folder.write("w.csv", text)).walls.at(0);
    };
    EXPECT_NEAR(wall(10).errors->adhesion, std::sqrt(12), 1e-9);
    EXPECT_FALSE(wall(10).adheres());  // 2.9 errors
    EXPECT_TRUE(wall(20).adheres());   // 5.8 errors
    EXPECT_FALSE(wall(-20).adheres());
}

TEST(WallLocus, IsShownByWholeWords) {
    const TemporaryFolder folder;
    const auto walls = [&](const std::string& name) {
        const auto path =
            folder.write("t.csv", fmt::format("{} [Pa],Shear stress [Pa]\n500,180\n1000,362\n"
                                              "2000,728\n",
                                              name));
        FileFormat format;
        format.named_columns["normal_stress"] = name + " [Pa]";
        return view_of_file(path, format).walls.size();
    };
    for (const std::string name : {"Prepared load", "Gewandelte Last", "sigma wet"})
        EXPECT_EQ(walls(name), 0u) << name;
    for (const std::string name :
         {"Wandnormalspannung", "wall_load", "sigma_w", "σw", "Last (Wand)"})
        EXPECT_EQ(walls(name), 1u) << name;
}

TEST(WallLocus, NeedsEvidence) {
    const TemporaryFolder folder;
    const std::string plain = "Normal stress [Pa],Shear stress [Pa]\n500,180\n1000,362\n2000,728\n";
    const auto walls = [&](const std::string& name, const FileFormat& format = {}) {
        return view_of_file(folder.write(name, plain), format).walls.size();
    };
    EXPECT_EQ(walls("points.csv"), 0u);
    EXPECT_EQ(walls("wall of sand.csv"), 0u);
    EXPECT_EQ(walls("Wandreibung Stahl.csv"), 1u);
    EXPECT_EQ(walls("wall_friction.csv"), 1u);
    FileFormat format;
    format.wall = true;
    EXPECT_EQ(walls("points.csv", format), 1u);
    EXPECT_FALSE(view_of_file(folder.write("points.csv", plain), format).walls[0].errors);
}

TEST(LocusTable, HasARowForEachLocusWithItsErrors) {
    const TemporaryFolder folder;
    std::string text = "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa]\n";
    for (const double pre : {2000.0, 4000.0})
        for (const int k : {1, 2, 3, 4})
            text += fmt::format("{},{},{},{}\n", pre, 0.5 * pre + k, 0.2 * k * pre,
                                0.1 * pre + 0.08 * k * pre + (k % 3 == 1 ? 2 : -2));
    const FileView view = view_of_file(folder.write("loci.csv", text));
    const FileView wall = view_of_file(
        folder.write("wall.csv",
                     "Wall normal stress [Pa],Wall shear stress [Pa]\n1000,302\n2000,598\n"
                     "3000,898\n4000,1202\n"));
    const std::string table = locus_table({view, wall});
    expect_told({table});
    std::vector<std::ptrdiff_t> commas;
    for (std::size_t at = 0; at < table.size();) {
        const std::size_t end = table.find('\n', at);
        commas.push_back(std::count(table.begin() + static_cast<std::ptrdiff_t>(at),
                                    table.begin() + static_cast<std::ptrdiff_t>(end), ','));
        at = end + 1;
    }
    EXPECT_THAT(commas, testing::AllOf(SizeIs(4), testing::Each(commas[0])));
}

TEST(LeverArm, MakesTorquesOfForces) {
    const TemporaryFolder folder;
    std::string text = "Zeit [s],Scherkraft [N],Normalkraft [N],Spalt [mm],Drehzahl [U/min]\n";
    for (int i = 0; i < 5; ++i)
        text += fmt::format("{},{},20,6.2,5\n", i, 2 + i);
    const auto path = folder.write("t.csv", text);
    AnnularCell cell{.inner_radius = 0.02, .outer_radius = 0.04, .lever_arm = 0.15};
    Recording recording = read_recording(path);
    fill_from_stresses(recording, cell);
    EXPECT_NEAR(recording.torque.at(1), 0.45, 1e-12);
    const FileView view = view_of_file(path, {}, cell);
    EXPECT_NEAR(view.series[0].shear_stress.at(1), shear_stress(0.45, cell), 1e-9);
    EXPECT_NEAR(view.series[0].normal_stress.at(1), normal_stress(20, cell), 1e-9);
    cell.lever_arm = 0;
    Recording without = read_recording(path);
    expect_told({input_error([&] { fill_from_stresses(without, cell); })});
}

/// Series of rows at constant load and speed with the given shear stress.
IntervalSeries sheared(const std::function<double(int)>& stress, int rows = 200) {
    IntervalSeries series;
    for (int i = 0; i < rows; ++i) {
        series.line.push_back(i + 2);
        series.time.push_back(0.1 * i);
        series.angular_velocity.push_back(0.5);
        series.normal_stress.push_back(1000);
        series.shear_stress.push_back(stress(i));
    }
    return series;
}

/// Independent noise, and noise of which each value keeps half of the one before.
TEST(KindsOfShear, AreNoNoise) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (const double kept : {0.0, 0.5}) {
        const auto shown = [&](double growth, double deviation) {
            int growing = 0;
            for (int trial = 0; trial < 600; ++trial) {
                double noise = 0;
                const IntervalSeries series = sheared(
                    [&](int i) {
                        noise = kept * noise + deviation * normal(random);
                        return 300 * (1 + growth * i) * (1 + noise);
                    },
                    20);
                growing += stress_growth(series).has_value();
            }
            return growing;
        };
        const int growing = shown(0, 0.05);
        const int found = shown(0.2, 0.005);
        EXPECT_GE(found, 590) << kept;
        EXPECT_LE(growing, 6) << kept;  // 3 are expected at `finding_significance`
    }
}

TEST(KindsOfShear, AreToldByTheColumnThatShowsThem) {
    IntervalSeries growing = sheared([](int i) { return 5 + 1.5 * i; });
    IntervalSeries saw =
        sheared([](int i) { return 300 + 0.8 * (i % 120) + 0.01 * (i % 2); }, 2400);
    std::vector<std::string> told = {stick_slip(saw).value_or("")};
    for (IntervalSeries* each : {&growing, &saw})
        each->torque = std::exchange(each->shear_stress, {});
    told.push_back(stress_growth(growing).value_or(""));
    told.push_back(stick_slip(saw).value_or(""));
    growing.lever_force = std::exchange(growing.torque, {});
    told.push_back(stress_growth(growing).value_or(""));
    expect_told(told);
}

TEST(KindsOfShear, AreStressGrowthAndStickSlip) {
    const auto noise = [](int i) { return std::sin(12.9898 * i * i); };
    const auto growing = sheared([&](int i) { return 5 + 1.5 * i + noise(i); });
    const auto level = sheared([&](int i) { return 300 * (1 - std::exp(-i / 10.0)) + noise(i); });
    const auto saw = sheared([&](int i) { return 300 + 8.0 * (i % 12) + noise(i); });
    const auto small = sheared([&](int i) { return 300 + 0.8 * (i % 12) + noise(i); });
    expect_told({stress_growth(growing).value_or(""), stick_slip(saw).value_or("")});
    EXPECT_TRUE(stress_growth(sheared([](int i) { return 300 * (1 - std::exp(-i / 100.0)); })));
    EXPECT_FALSE(stress_growth(level) || stick_slip(level));
    EXPECT_FALSE(stress_growth(saw) || stick_slip(growing));
    EXPECT_FALSE(stick_slip(small));  // less than a tenth
    // A load that rises with the stress is a ramp, not growth.
    IntervalSeries loaded = growing;
    for (std::size_t i = 0; i < loaded.size(); ++i)
        loaded.normal_stress[i] = 1000 + 5.0 * static_cast<double>(i);
    EXPECT_FALSE(stress_growth(loaded));
}

}  // namespace pendular::data_loci_test
