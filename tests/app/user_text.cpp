// What users write (folders, names of effects, units) is shown in figures as they wrote it; gnuplot
// and the shell execute nothing of it.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "data/files/csv.h"
#include "data/study/study.h"
#include "reports/draw_figure.h"
#include "reports/figure.h"
#include "reports/misfit_figures.h"
#include "tests/support/app_support.h"

namespace reports_user_text_test {

using namespace pendular;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Every printable ASCII character, in such an order that none hides behind another.
std::string every_character() {
    std::string text;
    for (char c = '!'; c <= '~'; ++c) {
        text += c;
    }
    return text + " \\n \\101 \\U+00e9 {/:Bold x} ~a{.8-} %g";
}

void replace(std::string& text, const std::string& what, const std::string& by) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

/// Texts that an SVG file shows; sub- and superscripts are marked by '<' and '>'.
std::vector<std::string> words_in(const fs::path& svg) {
    const std::string drawing = content_of(svg);
    std::vector<std::string> words;
    for (auto at = drawing.find("<text>"); at != std::string::npos;
         at = drawing.find("<text>", at + 1)) {
        std::string text, marked = drawing.substr(at + 6, drawing.find("</text>", at) - at - 6);
        for (std::size_t k = 0; k < marked.size(); ++k) {
            if (marked[k] == '<') {
                const auto end = marked.find('>', k);
                const std::string tag = marked.substr(k, end - k);
                text += tag.find("dy=\"") != std::string::npos ? "<shifted>" : "";
                k = end;
            } else {
                text += marked[k];
            }
        }
        replace(text, "&lt;", "<");
        replace(text, "&gt;", ">");
        replace(text, "&quot;", "\"");
        replace(text, "&amp;", "&");
        words.push_back(text);
    }
    return words;
}

/// A folder to work in and a file in it, $MARK to a shell, that exists once anything was executed.
class UserText : public testing::Test {
  protected:
    UserText() : before_(fs::current_path()), mark_(folder_.path() / "executed") {
        setenv("MARK", mark_.c_str(), 1);
        fs::create_directory(folder_.path() / "work");
        fs::current_path(folder_.path() / "work");
    }
    ~UserText() override { fs::current_path(before_); }

    void expect_nothing_executed(const std::string& by) const {
        EXPECT_FALSE(fs::exists(mark_)) << by;
    }
    static Figure figure() {
        return {.name = "figure",
                .title = "σ_{22}",
                .panels = {{.x_label = "x", .y_label = "y", .curves = {{.x = {1}, .y = {2}}}}}};
    }

    const fs::path before_;
    const TemporaryFolder folder_;
    const fs::path mark_;
};

const std::vector<std::string> hostile = {"st`touch $MARK`udy",
                                          "st$(touch $MARK)udy",
                                          "\"; system \"touch $MARK\" #",
                                          "'; system 'touch $MARK' #",
                                          "|touch $MARK; cat >",
                                          "two\nsystem \"touch $MARK\"\nlines",
                                          "EOD\nsystem 'touch $MARK'",
                                          "@HOME \\",
                                          "~",
                                          "%d {a}_b^c&"};

TEST_F(UserText, InTheNameOfAFolderIsNotExecuted) {
    for (const std::string& name : hostile) {
        draw(figure(), name);
        expect_nothing_executed(name);
        for (const char* extension : {"svg", "png", "pdf", "csv"}) {
            EXPECT_TRUE(fs::exists(fs::path(name) / fmt::format("figure.{}", extension))) << name;
        }
    }
    EXPECT_EQ(std::distance(fs::directory_iterator("."), {}),
              static_cast<std::ptrdiff_t>(hostile.size()));
}

TEST_F(UserText, AtALogarithmicAxisDoesNotTouch) {
    const Panel narrow{.x_label = "x",
                       .y_label = "y",
                       .log_x = true,
                       .curves = {{.x = {300, 1000, 3000}, .y = {1, 2, 3}}},
                       .x_range = {{240, 3700}}};
    draw({.name = "figure", .title = "", .panels = {narrow, narrow, narrow}, .columns = 3}, ".");
    const std::vector<std::string> shown = words_in("figure.svg");
    EXPECT_THAT(shown, testing::Contains("3000"));
    EXPECT_THAT(shown, testing::Not(testing::Contains("400")));
}

TEST_F(UserText, InALadderIsShownAsItIs) {
    for (const std::string& name : hostile) {
        Ladder ladder(2);
        for (LadderStep& ladder_step : ladder) {
            ladder_step.chi2 = 5, ladder_step.dof = 4, ladder_step.rms_percent = {3, 2};
        }
        ladder[1].change = "add";
        ladder[1].effect = name;
        draw(ladder_figure(ladder), "figures");
        expect_nothing_executed(name);
        std::string shown = fmt::format("{}", fmt::join(words_in("figures/ladder.svg"), "")),
                    wanted = "+ " + name;
        std::erase(wanted, '\n');  // begins a new line, which is a text of its own
        std::erase(wanted, ' ');   // blanks at the ends of lines are not drawn
        std::erase(shown, ' ');
        EXPECT_THAT(shown, HasSubstr(wanted));
    }
}

TEST_F(UserText, IsNoMarkupWhereverItStands) {
    const std::string text = every_character();
    Figure drawn = figure();
    drawn.title = plain_text(text);
    drawn.panels[0].x_label = plain_text(text + " along x, σ_{22}");
    drawn.panels[0].curves[0].label = plain_text(text + " in the key");
    drawn.panels[0].y_label = "σ_{22}";
    drawn.panels[0].key = true;
    draw(drawn, ".");
    const auto words = words_in("figure.svg");
    for (const std::string& wanted :
         {text, text + " along x, σ_{22}", text + " in the key", std::string("σ<shifted>22")}) {
        EXPECT_THAT(words, Contains(HasSubstr(wanted)));
    }
}

TEST_F(UserText, OfTheirGnuplotSettingsIsNotRead) {
    const std::string home = std::getenv("HOME");
    const auto settings = folder_.write(".gnuplot", "system \"touch $MARK\"\n");
    setenv("HOME", folder_.path().c_str(), 1);
    draw(figure(), ".");
    setenv("HOME", home.c_str(), 1);
    expect_nothing_executed(settings);
}

TEST_F(UserText, InAWrittenEffectIsRefusedWhereItIsNoNameOrUnit) {
    const std::string effect =
        "[[effect]]\nname = \"{}\"\nparameter = \"{}\"\nunit = \"{}\"\nlower = 0\nupper = 1\n"
        "torque = \"torque + size\"\n";
    const std::vector<std::array<std::string, 3>> all = {{"st`touch $MARK`", "size", "N m"},
                                                         {"own", "`touch $MARK`", "N m"},
                                                         {"own", "size", "N m `touch $MARK`"},
                                                         {"own", "size", "N m $(touch $MARK)"}};
    for (const auto& [name, parameter, unit] : all) {
        const auto file = folder_.write(
            "study.toml", grains_table + fmt::format(fmt::runtime(effect), name, parameter, unit));
        expect_told({input_error([&] { read_study(file); })});
        expect_nothing_executed(name + parameter + unit);
    }
}

TEST_F(UserText, FromTheProgramsOwnFoldersIsNotExecuted) {
    const std::string folder = "runs `touch $MARK`\n$(touch $MARK)";
    const Outcome run = run_pendular("runs plot --atlas --x friction --out '" + folder + "'");
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_nothing_executed(folder);
    EXPECT_TRUE(fs::exists(fs::path(folder) / "stress_ratio_by_friction.png"));
}

TEST(FigureNumbers, AreATableWhateverTheLabels) {
    const TemporaryFolder folder;
    const std::string label = "\"a\", b; c_{1}";
    Panel panel{.x_label = plain_text("own_unit [N, m]"), .y_label = "y [1]"};
    panel.references = {{.label = "limit", .value = 3, .error = 0.5}};
    panel.curves = {{.label = plain_text(label), .x = {1}, .y = {2}, .y_error = {0.25}}};
    panel.x_names = {broken_name("torque-own_name"), broken_name("none")};
    draw({.name = "figure", .title = "", .panels = {panel}}, folder.path());
    const Table table = read_table(folder.path() / "figure.csv");
    EXPECT_EQ(content_of(folder.path() / "figure.csv").find('#'), std::string::npos);
    const auto texts = [](const Row& row) {
        std::vector<std::string> cells;
        for (const Cell& cell : row.cells) {
            cells.push_back(cell.text);
        }
        return cells;
    };
    EXPECT_THAT(texts(table.header),
                ElementsAre("panel", "curve", "x", "y", "y_error", "x_name", "x_label", "y_label"));
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_THAT(texts(table.rows[0]),
                ElementsAre("1", "limit", "", "3", "0.5", "", "own_unit [N, m]", "y [1]"));
    EXPECT_THAT(texts(table.rows[1]), ElementsAre("1", label, "1", "2", "0.25", "torque-own_name",
                                                  "own_unit [N, m]", "y [1]"));
    EXPECT_THAT(texts(table.rows[2]),
                ElementsAre("1", "", "2", "", "", "none", "own_unit [N, m]", "y [1]"));
}

// OWASP, CSV Injection: a spreadsheet executes a cell that begins with one of these characters.
TEST(FigureNumbers, ContainNoFormula) {
    const TemporaryFolder folder;
    for (const std::string begin : {"=", "+", "-", "@"}) {
        const std::string label = begin + "HYPERLINK(\"http://x\")";
        Panel panel{.x_label = plain_text(label), .y_label = plain_text(label)};
        panel.curves = {{.label = plain_text(label), .x = {1}, .y = {-2}}};
        panel.x_names = {{plain_text(label)}};
        draw({.name = "figure", .title = "", .panels = {panel}}, folder.path());
        const Table table = read_table(folder.path() / "figure.csv");
        ASSERT_EQ(table.rows.size(), 1u);
        for (const std::size_t text : {1u, 5u, 6u, 7u})
            EXPECT_EQ(table.rows[0].cells[text].text.front(), '\'') << begin << text;
        EXPECT_EQ(table.rows[0].cells[3].text, "-2");  // a number stays one
    }
    EXPECT_EQ(csv_text_cell("\t=1+1"), "\"'\t=1+1\"");  // of a figure, a blank by now
    EXPECT_EQ(csv_text_cell("\r=1+1").substr(0, 2), "\"'");
    EXPECT_EQ(csv_text_cell("-12.5"), "-12.5");
    EXPECT_EQ(csv_text_cell("=1+1"), "'=1+1");
    EXPECT_EQ(csv_text_cell("@a,b"), "\"'@a,b\"");
    EXPECT_EQ(csv_text_cell("dry_1.csv"), "dry_1.csv");
}

TEST(BrokenName, EndsNoLineInTheMiddleOfACharacter) {
    EXPECT_THAT(broken_name("capillary-shear-stress"),
                ElementsAre("capillary-", "shear-", "stress"));
    EXPECT_THAT(broken_name("a_b\nc"), ElementsAre("a\\_b ", "c"));
    std::string longest;
    for (int k = 0; k < 30; ++k) {
        longest += "μ";
    }
    EXPECT_THAT(broken_name(longest), ElementsAre(longest.substr(0, 48), longest.substr(48)));
}

}  // namespace reports_user_text_test
