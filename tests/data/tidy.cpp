// Tables that `import --tidy` wrote, read again.
#include <fmt/format.h>

#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_tidy_test {

using testing::SizeIs;

const std::string recorded =
    "test,interval,role,line,time,torque,normal_force,height,angular_velocity\n"
    ",1,,1,s,N m,N,m,rad/s\n";

/// Rows of steady shear of one interval.
std::string rows(int interval) {
    std::string text;
    for (int i = 0; i < 30; ++i)
        text += fmt::format(",{},steady,{},{},0.02,5,0.0062,0.5\n", interval, i + 2, 0.1 * i);
    return text;
}

TEST(TidyTable, OfOneIntervalIsRead) {
    const TemporaryFolder folder;
    const auto one = folder.write("one.csv", recorded + rows(3));
    const FileView view = view_of_file(one);
    ASSERT_THAT(view.file.blocks, SizeIs(1));
    EXPECT_EQ(view.file.blocks[0].number, 3);
    EXPECT_EQ(view.roles[0].role, "steady");
    EXPECT_EQ(read_recording(one).size(), 30u);
    const Recording both = read_recording(folder.write("two.csv", recorded + rows(3) + rows(7)));
    EXPECT_EQ(both.size(), 60u);
    EXPECT_EQ(both.interval.back(), 7);
}

TEST(TidyTable, IsRefusedAtARowThatSaysNoRole) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& row) {
        const auto path = folder.write("t.csv", recorded + rows(1) + row);
        return input_error([&] { view_of_file(path); });
    };
    expect_told({refusal(",2,peaks,9,0,0.02,5,0.0062,0.5\n"), refusal(",2\n")});
    EXPECT_EQ(view_of_file(folder.write("b.csv", recorded + rows(1) + ",,\n")).roles.size(), 1u);
}

TEST(TidyTable, TellsThePreshearsOfItsPoints) {
    const TemporaryFolder folder;
    std::string text =
        "test,interval,role,line,shear_stress,normal_stress,preshear_stress,preshear_shear_stress,"
        "bulk_density\n,1,,1,Pa,Pa,Pa,Pa,kg/m^3\n";
    for (const double pre : {2000.0, 4000.0})
        for (const int k : {1, 2, 3})
            text += fmt::format(",{},failure,9,{},{},{},{},{}\n", k + (pre > 3000 ? 3 : 0),
                                0.1 * pre + 0.1 * k * pre, 0.25 * k * pre, pre, 0.5 * pre + k,
                                1400 + k);
    const FileView view = view_of_file(folder.write("t.csv", text));
    ASSERT_THAT(view.loci, SizeIs(2));
    EXPECT_NEAR(view.loci[1].line->cohesion, 400, 1e-9);
    // As of a table of points, the mean over all rows.
    EXPECT_NEAR(view.loci[1].preshear->shear_stress, 2002, 1e-9);
    EXPECT_NEAR(view.loci[1].preshear->bulk_density.value(), 1402, 1e-9);
    EXPECT_NEAR(view.loci[1].preshear->shear_stress_error.value(), 1 / std::sqrt(3.0), 1e-9);
}

}  // namespace pendular::data_tidy_test
