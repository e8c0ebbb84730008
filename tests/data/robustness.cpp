#include <fmt/format.h>

#include "data/files/columns.h"
#include "data/recordings/recording.h"
#include "data/recordings/steps.h"
#include "data/study/study.h"
#include "tests/support/data_support.h"

namespace pendular::data_robustness_test {

/// The text with a few random bytes replaced, inserted or removed, from those that mean something
/// to a reader and any other.
std::string damaged(std::string text, std::mt19937_64& random) {
    const std::string special = "\"#,;\t\r\n[]=.{}\\'\xFF\xC3-eE0";
    for (int edits = 1 + static_cast<int>(random() % 4); edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random() % text.size();
        const char byte =
            random() % 4 ? special[random() % special.size()] : static_cast<char>(random() % 256);
        switch (random() % 3) {
            case 0:
                text[at] = byte;
                break;
            case 1:
                text.insert(at, 1, byte);
                break;
            default:
                text.erase(at, 1 + random() % 5);
        }
    }
    return text;
}

/// Whatever a user's file holds, it is read or refused with its name; nothing else may happen.
void expect_read_or_refused(const std::string& name, const std::string& good,
                            const std::function<void(const std::filesystem::path&)>& read) {
    TemporaryFolder folder;
    folder.write("points.csv", "a\n1\n");
    EXPECT_NO_THROW(read(folder.write(name, good)));
    std::mt19937_64 random(17);
    for (int i = 0; i < 500; ++i) {
        const std::string content = damaged(good, random);
        try {
            read(folder.write(name, content));
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(folder.path().string())) << content;
        }
    }
}

TEST(DamagedFiles, AreRefusedByTheRecordingReader) {
    std::string good =
        "# rheometer\nTime [s],Torque [mN m],Normal force [N],Gap [mm],"
        "Angular velocity [rad/s],Interval\n";
    for (int i = 0; i < 5; ++i)
        good += fmt::format("{},30.5,\"5\",4.01,0.1,1\n", i);
    expect_read_or_refused("r.csv", good, [](const std::filesystem::path& path) {
        split_steps(read_recording(path));
    });
}

TEST(DamagedFiles, AreRefusedByTheStudyReader) {
    expect_read_or_refused("study.toml", R"([grains]
diameter = "500 um"      # mean
density = "1050 kg/m^3"
poisson_ratio = 0.3
[liquid]
surface_tension = "20.6 mN/m"
contact_angle = "5 deg"
[cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "60 g"
[[readings]]
file = "points.csv"
liquid_content = 0.0
[model]
calibrate = ["friction"]
effects = []
)",
                           [](const std::filesystem::path& path) { read_study(path); });
}

}  // namespace pendular::data_robustness_test
