#include <gmock/gmock.h>

#include "data/files/text_pattern.h"

namespace pendular {
namespace {

using testing::ElementsAre;

TEST(TextPattern, FindsParts) {
    const TextPattern pattern("(a+)(b)?");
    const auto whole = pattern.whole("aab");
    ASSERT_TRUE(whole);
    EXPECT_THAT(whole->parts, ElementsAre("aab", "aa", "b"));
    EXPECT_FALSE(pattern.whole("aabc"));

    const auto first = pattern.first("xaay");
    ASSERT_TRUE(first);
    EXPECT_EQ(first->begin, 1);
    EXPECT_EQ(first->end, 3);
    EXPECT_THAT(first->parts, ElementsAre("aa", "aa", ""));
    EXPECT_FALSE(pattern.first("xy"));
}

TEST(TextPattern, FindsAllFromLeftToRight) {
    std::vector<std::size_t> begins;
    for (const PatternMatch& match : TextPattern("ab").all("ab_abab"))
        begins.push_back(match.begin);
    EXPECT_THAT(begins, ElementsAre(0, 3, 5));
    EXPECT_TRUE(TextPattern("ab").all("").empty());
}

}  // namespace
}  // namespace pendular
