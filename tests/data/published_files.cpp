#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "data/files/formats/layouts.h"
#include "data/files/text_file.h"
#include "data/recordings/file_view.h"
#include "tests/support/golden.h"

namespace pendular::data_published_files_test {

using testing::DoubleNear;
using testing::SizeIs;

/// Name and unit of each column that is read as a quantity: "torque [mN·m]".
std::vector<std::string> used_columns(const Block& block) {
    std::vector<std::string> result;
    for (const BlockColumn& column : block.columns)
        if (!column.quantity.empty()) result.push_back(column.quantity + " [" + column.unit + "]");
    return result;
}

struct Published {
    std::string file, layout, encoding;
    char decimal;
    std::size_t blocks, rows;
    std::vector<std::string> columns;  ///< that are read, of the first block
};

void PrintTo(const Published& each, std::ostream* stream) {
    *stream << each.file;
}

class PublishedExports : public testing::TestWithParam<Published> {};

TEST_P(PublishedExports, AreReadWithTheirColumnsUnitsAndIntervals) {
    const Published& expected = GetParam();
    const auto path = published_sample(expected.file);
    if (!path) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
    const BlockFile file = read_blocks(*path);
    EXPECT_EQ(file.layout, expected.layout);
    EXPECT_EQ(file.encoding, expected.encoding);
    EXPECT_EQ(file.numbers.decimal, expected.decimal);
    EXPECT_EQ(file.blocks.size(), expected.blocks);
    std::size_t rows = 0;
    for (const Block& block : file.blocks)
        rows += series_of(block).size();
    EXPECT_EQ(rows, expected.rows);
    EXPECT_EQ(used_columns(file.blocks[0]), expected.columns);
}

const std::vector<Published> published_exports = {
    // Rows were counted by another program: lines that begin with a number, after a tab for
    // RheoCompass (and 4096 lines of an interval that numbers only every 513th point).
    {"antonpaar_powder/sauret_1mm_0p5pct_wet_preshear2kPa.csv",
     "rheocompass",
     "UTF-16LE",
     '.',
     5,
     1500,
     {"preshear_stress [Pa]", "normal_stress [Pa]", "shear_stress [Pa]", "height [mm]"}},
    {"antonpaar_powder/sauret_ccgm_3kPa_all_intervals.csv",
     "rheocompass",
     "UTF-16LE",
     '.',
     40,
     4630,
     {"preshear_stress [Pa]", "normal_stress [Pa]", "shear_stress [Pa]"}},
    {"antonpaar_powder/sauret_1mm_0p5pct_wet_yieldlocus_report.txt",
     "yield-locus-report",
     "UTF-8",
     '.',
     30,
     30,
     {"normal_stress [Pa]", "shear_stress [Pa]", "height [mm]"}},
    {"antonpaar_powder/sauret_ccgm_yieldlocus_report.txt",
     "yield-locus-report",
     "UTF-8",
     '.',
     12,
     12,
     {"normal_stress [Pa]", "shear_stress [Pa]", "height [mm]"}},
    {"antonpaar_powder/jank_flat_glass420_w10_3kPa.csv",
     "unit-row",
     "UTF-8",
     '.',
     3,
     1500,
     {"time [s]", "height [mm]", "normal_force [N]", "normal_stress [Pa]", "torque [mN·m]",
      "shear_stress [Pa]", "rotational_speed [1/min]"}},
    {"antonpaar/rheocompass_fr_utf16le_decimalcomma_LAOS.csv",
     "rheocompass",
     "UTF-16LE",
     ',',
     10,
     4542,
     {"time [s]", "shear_stress [Pa]", "shear_rate [1/s]", "torque [mN·m]", "normal_force [N]"}},
    {"antonpaar/rheocompass_steadyvisc_35C.csv",
     "rheocompass",
     "UTF-16LE",
     '.',
     12,
     300,
     {"time [s]", "shear_rate [1/s]", "shear_stress [Pa]", "torque [µN·m]"}},
    {"antonpaar/rheoplus_multiple_relaxation.csv",
     "rheocompass",
     "UTF-16LE",
     '.',
     2,
     606,
     {"time [s]", "shear_stress [Pa]", "torque [mN·m]"}},
    {"antonpaar/ciccone_sweep_diff_lengths.txt",
     "rheoplus",
     "UTF-8",
     '.',
     13,
     164,
     {"shear_stress [Pa]", "torque [µNm]", "time [s]", "normal_force [N]"}},
    {"ta_trios/trios_csv_2.csv",
     "trios",
     "UTF-8",
     '.',
     7,
     427,
     {"shear_stress [Pa]", "shear_rate [1/s]", "time [min]", "normal_stress [Pa]"}},
    {"ta_trios/trios_txt_steps_ARG2.txt",
     "trios",
     "UTF-8",
     '.',
     22,
     7042,
     {"time [s]", "shear_stress [Pa]", "shear_rate [1/s]"}},
    {"ta_trios/trios_LIMS_creep_experiment.txt",
     "trios",
     "UTF-8",
     '.',
     1,
     483,
     {"torque [µN.m]", "angular_velocity [rad/s]", "normal_force [N]", "height [µm]", "time [min]",
      "shear_stress [MPa]", "normal_stress [MPa]", "shear_rate [1/s]"}},
    {"malvern/rspace_semicolon_LAOS.csv",
     "rspace",
     "UTF-8",
     ',',
     17,
     6024,
     {"time [s]", "shear_stress [Pa]", "shear_rate [s-¹]", "normal_force [N]", "torque [N m]",
      "height [mm]"}},
    {"haake/petrus_dyncom_Fn_h.csv",
     "rheowin",
     "UTF-8",
     '.',
     6,
     588,
     {"normal_force [N]", "height [mm]", "time [s]"}},
    {"haake/petrus_freqsweep_raw.csv", "rheowin", "UTF-8", ',', 4, 125, {"time [s]"}}};

TEST(PublishedFiles, AreRefusedWithWhatToWrite) {
    std::vector<std::string> told;
    for (const char* const name :
         {"antonpaar_powder/jank_flat_glass230_original_3kPa_CORRUPT_TORQUE.csv",
          "antonpaar_powder/jank_mohr_coulomb_semicolon_nested.csv",
          "homebuilt_annular/headerless_time_torque.csv",
          "homebuilt_annular/one_row_time_then_torque.csv"}) {
        const auto path = published_sample(name);
        if (!path) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
        const std::string error = input_error([&] { read_blocks(*path); });
        told.push_back(error.substr(error.find(path->filename())));
    }
    expect_told(told);
}

TEST(PublishedFiles, WithoutHeaderAreReadAsStated) {
    for (const char* const name : {"homebuilt_annular/headerless_time_torque.csv",
                                   "homebuilt_annular/one_row_time_then_torque.csv"}) {
        const auto path = published_sample(name);
        if (!path) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
        FileFormat format;
        format.columns = {"Time [s]", "Torque [N m]"};
        const FileView view = view_of_file(*path, format);
        ASSERT_THAT(view.series, SizeIs(1));
        EXPECT_THAT(view.series[0].time.front(), DoubleNear(0.2, 1e-12));
        EXPECT_TRUE(std::ranges::is_sorted(view.series[0].time));
    }
}

const std::vector<std::string> columns_of_sheet = {
    "Point [1]",          "Time [s]",      "Gap [mm]",          "Normal Force [N]",
    "Normal Stress [Pa]", "Torque [mN m]", "Shear Stress [Pa]", "Rotational Speed [1/min]"};

/// A thousands separator was lost in torques between 1 and 10 mN m, so they are ten times too
/// large.
TEST(PublishedFiles, WithDamagedTorqueAreCaught) {
    const auto path =
        published_sample("antonpaar_powder/jank_flat_glass230_original_3kPa_CORRUPT_TORQUE.csv");
    if (!path) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
    FileFormat format;
    format.columns = columns_of_sheet;
    const FileView view = view_of_file(*path, format);
    const auto damage =
        std::ranges::find(view.findings, Remark::Kind::ratio_of_columns, &Remark::kind);
    ASSERT_NE(damage, view.findings.end());
    expect_told({text_of(*damage)});
    EXPECT_NEAR(*view.cell.inner_radius, 0.0105, 1e-9);
    // Every row that is listed has a stress of 1 to 10 mN m times the constant of the cup, 54.4
    // Pa/(mN m), and the stresses of failure are used.
    for (const auto& [first, last, file] : damage->lines)
        for (std::size_t k = 0; k < view.series.size(); ++k)
            for (std::size_t i = 0; i < view.series[k].size(); ++i) {
                const int line = view.series[k].line[i];
                if (line < first || line > last) continue;
                EXPECT_LT(view.series[k].shear_stress[i], 545);
            }
    EXPECT_FALSE(view.loci.empty());
}

/// The instrument's report on the same test, of its first level of preshear (2 kPa).
TEST(PublishedFiles, GiveTheYieldLocusOfTheInstrumentsReport) {
    const auto path = published_sample("antonpaar_powder/sauret_1mm_0p5pct_wet_preshear2kPa.csv");
    if (!path) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
    const FileView view = view_of_file(*path);
    ASSERT_THAT(view.loci, SizeIs(1));
    const YieldLocus& locus = view.loci[0];
    const std::vector<std::pair<std::string, std::string>> printed = {
        {"790", "770"}, {"1040", "1346"}, {"1356", "928.1"}, {"1491", "1962"}, {"1572", "1466"}};
    ASSERT_EQ(locus.points.size(), printed.size());
    for (std::size_t i = 0; i < printed.size(); ++i) {
        EXPECT_EQ(fmt::format("{:.4g}", locus.points[i].normal_stress), printed[i].first);
        EXPECT_EQ(fmt::format("{:.4g}", locus.points[i].shear_stress), printed[i].second);
    }
    EXPECT_NEAR(locus.line->cohesion, 106.5, 0.05);
    EXPECT_NEAR(locus.line->slope_angle * 180 / M_PI, 43.54, 0.005);
    EXPECT_NEAR(locus.line->tensile_strength, -112.1, 0.05);
    // Stresses in the file have five digits: errors of 0.02 Pa in the cohesion.
    EXPECT_NEAR(locus.line->unconfined_strength, 496.4, 0.1);
}

/// Results of each level that an instrument's report prints.
struct ReportedLevel {
    double cohesion = 0, tensile = 0, unconfined = 0, major = 0, effective = 0, slope = 0;
};

std::vector<ReportedLevel> reported_levels(const std::filesystem::path& path) {
    std::vector<ReportedLevel> levels;
    for (const std::string& line : read_lines(path)) {
        const std::size_t colon = line.find(": ");
        const double value = colon == std::string::npos ? 0 : std::atof(line.c_str() + colon + 1);
        const auto begins = [&](const char* key) {
            return line.find(key) != std::string::npos && line.find(key) < 4;
        };
        if (begins("Preshear level")) levels.emplace_back();
        if (levels.empty()) continue;
        ReportedLevel& level = levels.back();
        if (begins("Cohesion")) level.cohesion = value;
        if (begins("Tensile")) level.tensile = value;
        if (begins("Unconfined")) level.unconfined = value;
        if (begins("Major")) level.major = value;
        if (begins("Effective")) level.effective = value;
        if (begins("Slope")) level.slope = value;
    }
    return levels;
}

/// The reports print stresses to four digits. An error of 0.5 Pa in one of few points moves the
/// intercept by about 1 Pa and the slope by about 0.03 deg.
TEST(PublishedFiles, GiveTheResultsOfTheInstrumentsReportsFromItsPoints) {
    for (const char* const name : {"antonpaar_powder/sauret_1mm_0p5pct_wet_yieldlocus_report.txt",
                                   "antonpaar_powder/sauret_ccgm_yieldlocus_report.txt"}) {
        const auto path = published_sample(name);
        if (!path) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
        const auto levels = reported_levels(*path);
        EXPECT_THAT(levels.size(), testing::AnyOf(5u, 3u));
        const FileView view = view_of_file(*path);
        ASSERT_EQ(view.loci.size(), levels.size());
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const ReportedLevel& level = levels[k];
            const LinearYieldLocus& locus = view.loci[k].line.value();
            EXPECT_GT(view.loci[k].preshear.value().bulk_density.value(), 1000);
            EXPECT_NEAR(locus.cohesion, level.cohesion, 1.5);
            EXPECT_NEAR(locus.slope_angle * 180 / M_PI, level.slope, 0.05);
            EXPECT_NEAR(locus.tensile_strength, level.tensile, 4);
            EXPECT_NEAR(locus.unconfined_strength, level.unconfined, 6);
            EXPECT_NEAR(*locus.major_principal_stress / level.major, 1, 1e-3);
            EXPECT_NEAR(*locus.effective_angle * 180 / M_PI, level.effective, 0.02);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, PublishedExports, testing::ValuesIn(published_exports));

}  // namespace pendular::data_published_files_test
