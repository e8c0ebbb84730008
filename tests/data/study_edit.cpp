// The list of effects in a study's text, edited in place.
#include "data/study/study_edit.h"

#include <sys/stat.h>
#include <algorithm>

#include "data/files/text_file.h"
#include "data/study/study.h"
#include "tests/support/golden.h"

namespace pendular::study_edit_test {

std::string with(const std::string& text, const std::string& name = "x") {
    return with_effect(text, "study.toml", name);
}
std::string without(const std::string& text, const std::string& name = "x") {
    return without_effect(text, "study.toml", name);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

TEST(StudyEdit, AddsToAListOnOneLine) {
    EXPECT_EQ(with("[model]\neffects = []  # none\n"), "[model]\neffects = [\"x\"]  # none\n");
    EXPECT_EQ(with("[model]\neffects = [\"a\"]\n"), "[model]\neffects = [\"a\", \"x\"]\n");
    EXPECT_EQ(with("[model]\neffects=['a', 'b']\n"), "[model]\neffects=['a', 'b', 'x']\n");
    EXPECT_EQ(with("[model]\neffects = [ \"a\", ]\n"), "[model]\neffects = [ \"a\", \"x\", ]\n");
}

TEST(StudyEdit, AddsALineToAListOfLines) {
    EXPECT_EQ(with("[model]\neffects = [\n    'a', # first, that is\n    'b',\t# \"]\"\n]\n"),
              "[model]\neffects = [\n    'a', # first, that is\n    'b',\t# \"]\"\n    'x',\n]\n");
    EXPECT_EQ(with("[model]\neffects = [\n  \"a\", # one\n  \"b\"  # two\n  # end\n]\n"),
              "[model]\neffects = [\n  \"a\", # one\n  \"b\",  # two\n  \"x\"\n  # end\n]\n");
    EXPECT_EQ(with("[model]\n  effects = [\n    # none yet\n  ]\n"),
              "[model]\n  effects = [\n    # none yet\n    \"x\",\n  ]\n");
    EXPECT_EQ(with("[model]\neffects = [\n  \"a\" # c\n  ,\n]\n"),
              "[model]\neffects = [\n  \"a\", \"x\" # c\n  ,\n]\n");
}

TEST(StudyEdit, AddsTheKeyWhereItIsMissing) {
    EXPECT_EQ(with("[model] # choices\nbase = \"dem\" # yes\n\n[grains]\n"),
              "[model] # choices\nbase = \"dem\" # yes\neffects = [\"x\"]\n\n[grains]\n");
    EXPECT_EQ(with("[model]\n  calibrate = [\n  \"friction\"\n  ]\n"),
              "[model]\n  calibrate = [\n  \"friction\"\n  ]\n  effects = [\"x\"]\n");
    EXPECT_EQ(with("[model]\n[grains]\n"), "[model]\neffects = [\"x\"]\n[grains]\n");
    EXPECT_EQ(with("[model]\nbase = \"dem\""), "[model]\nbase = \"dem\"\neffects = [\"x\"]");
    EXPECT_EQ(with("model.base = \"dem\" # c\n[grains]\n"),
              "model.base = \"dem\" # c\nmodel.effects = [\"x\"]\n[grains]\n");
    EXPECT_EQ(with("model = { base = \"dem\" } # c\n"),
              "model = { base = \"dem\", effects = [\"x\"] } # c\n");
    EXPECT_EQ(with("model = {}\n"), "model = { effects = [\"x\"] }\n");
    EXPECT_EQ(with("model = { }\n"), "model = { effects = [\"x\"] }\n");
}

TEST(StudyEdit, AddsTheTableWhereItIsMissing) {
    EXPECT_EQ(with("[grains]\na = 1\n"), "[grains]\na = 1\n\n[model]\neffects = [\"x\"]\n");
    EXPECT_EQ(with("[grains]\na = 1"), "[grains]\na = 1\n\n[model]\neffects = [\"x\"]\n");
}

TEST(StudyEdit, KeepsLineEndsMarksAndCharacters) {
    EXPECT_EQ(
        with("\xEF\xBB\xBF# \u00b5\r\n[model]\r\neffects = [\r\n  \"\u00b5\", # \u00e9\r\n]\r\n"),
        "\xEF\xBB\xBF# \u00b5\r\n[model]\r\neffects = [\r\n  \"\u00b5\", # \u00e9\r\n  "
        "\"x\",\r\n]\r\n");
    EXPECT_EQ(with("[grains]\r\na = 1\r\n"),
              "[grains]\r\na = 1\r\n\r\n[model]\r\neffects = [\"x\"]\r\n");
    EXPECT_EQ(with("\xEF\xBB\xBFmodel.effects = []\n"), "\xEF\xBB\xBFmodel.effects = [\"x\"]\n");
    EXPECT_EQ(with("[model]\reffects = []\r"), "[model]\reffects = [\"x\"]\r");
}

TEST(StudyEdit, DropsFromAListOnOneLine) {
    const auto list = [](const std::string& elements) {
        return "[model]\neffects = [" + elements + "] # c\n";
    };
    EXPECT_EQ(without(list("\"x\"")), list(""));
    EXPECT_EQ(without(list("\"x\", \"a\"")), list("\"a\""));
    EXPECT_EQ(without(list("\"a\", 'x', \"b\"")), list("\"a\", \"b\""));
    EXPECT_EQ(without(list("\"a\", \"x\"")), list("\"a\""));
    EXPECT_EQ(without(list("\"a\", \"x\",")), list("\"a\","));
    EXPECT_EQ(without(list("\"x\",")), list(""));
}

TEST(StudyEdit, DropsALineOfAListOfLinesButNoComment) {
    EXPECT_EQ(without("[model]\neffects = [\n  \"a\", # one\n  \"x\",\n  \"b\", # two\n]\n"),
              "[model]\neffects = [\n  \"a\", # one\n  \"b\", # two\n]\n");
    EXPECT_EQ(without("[model]\neffects = [\n  \"a\",\n  \"x\", # why\n]\n"),
              "[model]\neffects = [\n  \"a\",\n  # why\n]\n");
    EXPECT_EQ(without("[model]\neffects = [\n  \"a\", # one\n  \"x\" # why\n]\n"),
              "[model]\neffects = [\n  \"a\", # one\n  # why\n]\n");
    EXPECT_EQ(without("[model]\neffects = [\n  \"x\" # why\n  , \"a\"]\n"),
              "[model]\neffects = [\n   # why\n   \"a\"]\n");
}

TEST(StudyEdit, RefusesWhatIsThereOrIsNot) {
    expect_told({input_error([] { with("[model]\neffects = [\"x\"]\n"); }), input_error([] {
                     without("[model]\neffects = [\"torque-offset\"]\n", "torq-offset");
                 }),
                 input_error([] { without("[grains]\n"); }), input_error([] { with("[model\n"); }),
                 input_error([] { with("model = 3\n"); }),
                 input_error([] { with("[model]\neffects = [3]\n"); })});
}

TEST(StudyEdit, SaysWhatToWriteWhereItCannotEdit) {
    expect_told({input_error([] { with("[model]\neffects = [\"\"\"a\"\"\"]\n"); }),
                 input_error([] { with("[model]\neffects = []\n", "a\"b"); })});
}

/// Texts before, inside and behind a list of effects, all of which the edits must keep.
std::vector<std::string> layouts() {
    const std::vector<std::string> heads = {"", "# \u00b5 [model] effects = [\n",
                                            "note = \"effects = ['x']\" # é\n"};
    const std::vector<std::string> models = {
        "",
        "[model]\n",
        "[model] # m\nbase = \"dem\"\n\n# end\n",
        "  [model]\n\tbase = \"dem\" # tab\n",
        "[model]\neffects = []\nbase = \"dem\"\n",
        "[model]\neffects = [ ] # none\n",
        "[model]\n\"effects\" = [\"a\"]\n",
        "[model]\neffects = [ 'a' , 'b' ]\n",
        "[model]\neffects = [\"a\", \"b\",]\n",
        "[model]\neffects = [\n  \"a\",\n  \"b\"\n]\n",
        "[model]\neffects = [\n  \"a\", # 'x',\n\n  \"b\", # ]\n  # end\n]\nbase = \"dem\"\n",
        "[model]\neffects = [\"a\", # one\n  \"b\"] # two\n",
        "[model]\neffects = [\n\"a\",\n\"b\" # c\n, # d\n]\n",
        "[model]\neffects = [ # \"none\"\n]\n",
        "[model]\neffects = [\n\"\\u0061\", 'b\\',\n]\n",
        "model.base = \"dem\"\n",
        "model.effects = ['a']\n",
        "model = {base = \"dem\"}\n",
        "model = { base = \"dem\", effects = [ \"a\" ] }\n"};
    std::vector<std::string> result;
    for (const std::string& head : heads)
        for (const std::string& model : models)
            for (const char* tail : {"", "[grains] # g\na = [1, 2,]\n", "[grains]\na = 1"})
                for (const char* line_end : {"\n", "\r\n"})
                    result.push_back(replaced(head + model + tail, "\n", line_end));
    return result;
}

/// Characters between the first and the last difference of two texts.
std::size_t changed(const std::string& before, const std::string& after) {
    const auto first = std::ranges::mismatch(before, after);
    const std::string left(first.in1, before.end()), right(first.in2, after.end());
    const auto last = std::mismatch(left.rbegin(), left.rend(), right.rbegin(), right.rend());
    return static_cast<std::size_t>(std::distance(last.second, right.rend()));
}

std::size_t comments_in(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count(text, '#'));
}

// with_effect and without_effect compare the parsed text themselves and refuse a wrong edit, so
// that no exception means nothing but the list has changed.
TEST(StudyEdit, AddingThenDroppingChangesNothingInAnyLayout) {
    for (const std::string& text : layouts()) {
        SCOPED_TRACE(text);
        const std::string added = with(text, "new-effect");
        EXPECT_THROW(with(added, "new-effect"), InputError);
        const std::string dropped = without(added, "new-effect");
        EXPECT_THROW(without(dropped, "new-effect"), InputError);
        EXPECT_EQ(comments_in(added), comments_in(text));
        EXPECT_LE(changed(text, added), 50u);  // the name, a comma, a new line, [model] if missing
        EXPECT_EQ(comments_in(dropped), comments_in(text));
        EXPECT_EQ(without(with(dropped, "new-effect"), "new-effect"), dropped);
        EXPECT_EQ(added.find('\r') == std::string::npos, text.find('\r') == std::string::npos);
    }
}

TEST(StudyEdit, ReplacesTheFileOfAStudy) {
    const TemporaryFolder folder;
    const std::string text =
        "[grains] # \xB5m\ndiameter = \"500 um\"\ndensity = \"1050 kg/m^3\"\n[[readings]]\n"
        "file = \"points.csv\"\n[model]\neffects = [] # none yet\n";
    folder.write("points.csv", "a\n1\n");
    const auto file = folder.write("study.toml", text);
    replace_study(file, with(read_text(file), "torque-offset"));
    EXPECT_EQ(read_study(folder.path()).model.effects.at(0).name, "torque-offset");
    expect_told({read_text(file)});
    replace_study(file, without(read_text(file), "torque-offset"));
    EXPECT_TRUE(read_study(folder.path()).model.effects.empty());
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

}  // namespace pendular::study_edit_test
