#include "data/input_error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pendular::data_nearest_test {

const std::vector<std::string> keys = {"diameter", "density", "youngs_modulus"};

TEST(Nearest, CountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(edit_distance("gap", "gap"), 0);
    EXPECT_EQ(edit_distance("Gap", "gap"), 0);
    EXPECT_EQ(edit_distance("diametre", "diameter"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(InputError, KeepsItsPlaceBesideItsText) {
    const InputError error({"study.toml", 3, 7}, "unknown key");
    EXPECT_EQ(error.position().file, "study.toml");
    EXPECT_EQ(error.position().line, 3);
    EXPECT_EQ(error.position().column, 7);
    const InputError copy = error;
    EXPECT_EQ(copy.position().line, 3);
    EXPECT_TRUE(InputError("unknown option").position().file.empty());
}

TEST(Nearest, FindsTheWordMeant) {
    EXPECT_EQ(nearest("diametre", keys), "diameter");
    EXPECT_EQ(nearest("young_modulus", keys), "youngs_modulus");
}

TEST(Nearest, IsSilentAboutStrangers) {
    EXPECT_EQ(nearest("colour", keys), std::nullopt);
}

TEST(Nearest, AsksOrListsWhatIsKnown) {
    EXPECT_EQ(did_you_mean("desnity", keys), "did you mean 'density'?");
    EXPECT_EQ(did_you_mean("Youngs", keys), "did you mean 'youngs_modulus'?");
    EXPECT_EQ(nearest("youngs", keys), std::nullopt);  // a guess too far to refuse a column for
    EXPECT_EQ(did_you_mean("colour", keys), "known are 'diameter', 'density', 'youngs_modulus'");
}

TEST(Position, LeavesOutWhatIsNotKnown) {
    EXPECT_EQ(to_string({"a.csv", 3, 7}), "a.csv:3:7");
    EXPECT_EQ(to_string({"a.csv", 3, 0}), "a.csv:3");
    EXPECT_EQ(to_string({"a.csv", 0, 0}), "a.csv");
    EXPECT_STREQ(InputError({"a.csv", 3, 7}, "wrong; mend it").what(), "a.csv:3:7: wrong; mend it");
    EXPECT_STREQ(InputError("wrong").what(), "wrong");
}

}  // namespace pendular::data_nearest_test
