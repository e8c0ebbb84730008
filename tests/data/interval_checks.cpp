// Checks of one file: values far above all others, and tests whose steps no column numbers.
#include "data/recordings/interval_checks.h"

#include "data/recordings/file_view.h"
#include "data/remarks/wording.h"
#include "tests/support/golden.h"

namespace pendular::data_interval_checks_test {

std::vector<std::string> told(const std::string& text) {
    const TemporaryFolder folder;
    std::vector<std::string> texts;
    for (const Remark& finding : view_of_file(folder.write("r.csv", text)).findings)
        texts.push_back(with_lines(finding, 9));
    return texts;
}

/// A recording of 40 rows; some torques are replaced.
std::string recording(const std::map<int, std::string>& torques) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::string text = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 40; ++i) {
        const std::string torque = fmt::format("{:.3f}", 30 + 0.3 * normal(random));
        text +=
            fmt::format("{},{},{:.3f},6.{:03},2\n", i, torques.contains(i) ? torques.at(i) : torque,
                        5 + 0.01 * normal(random), 100 + i % 3);
    }
    return text;
}

TEST(FarValues, AreTold) {
    std::vector<std::string> texts;
    for (const auto& torques :
         {std::map<int, std::string>{{7, "-999"}, {20, "-999"}},
          std::map<int, std::string>{{0, "999"}, {1, "999"}, {2, "999"}, {39, "999"}},
          std::map<int, std::string>{{9, "999.9"}}, std::map<int, std::string>{{9, "300"}},
          std::map<int, std::string>{}})
        for (const std::string& text : told(recording(torques)))
            texts.push_back(text);
    expect_told(texts);
}

/// A step at 999 is a step.
TEST(FarValues, AreNoSteps) {
    std::map<int, std::string> loaded;
    for (int row = 20; row < 40; ++row)
        loaded[row] = "999";
    EXPECT_THAT(told(recording(loaded)), testing::IsEmpty());
}

/// Preshears at 1 kPa and shear to failure at 0.7, 0.5 and 0.3 kPa, after rests.
TEST(CyclesInOneInterval, AreTold) {
    std::string text = "Time [s],Normal stress [Pa],Shear stress [Pa],Gap [mm],Speed [rpm]\n";
    int time = 0;
    const auto add = [&](int rows, double normal, double shear, double speed) {
        for (int i = 0; i < rows; ++i)
            text += fmt::format("{},{},{},6.16,{}\n", time++, normal + i % 3,
                                shear * (1 - std::exp(-0.3 * (i + 1))), speed);
    };
    for (const double load : {700, 500, 300}) {
        add(40, 1000, 600, 0.1);
        add(10, load, 5, 0);
        add(30, load, 0.7 * load, 0.1);
    }
    expect_told(told(text));
}

}  // namespace pendular::data_interval_checks_test
