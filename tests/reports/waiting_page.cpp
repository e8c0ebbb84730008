// What a server shows before it has results of its own.
#include "reports/page/report_page.h"
#include "tests/support/golden.h"

namespace pendular::reports_waiting_page_test {

/// Returns the header of a waiting page, HTML that a reader sees above all sections.
std::string header_of(const EarlierResults& earlier = {}) {
    const std::string page = waiting_page("beads", "1.0", earlier);
    const std::size_t first = page.find("<header>");
    return page.substr(first, page.find("</header>") - first);
}

TEST(WaitingPage, SaysThatThereIsNothingYet) {
    expect_told({header_of()});
}

TEST(WaitingPage, ShowsWhatTheLadderSaysMarkedAsEarlier) {
    LadderStep step;
    step.effects = {"wall-friction"};
    step.chi2 = 40.2;
    step.dof = 49;
    step.parameters = {{.name = "friction", .unit = "1", .value = 0.0923, .standard_error = 0.004}};
    expect_told({header_of({.page = "", .when = "", .ladder = {step}})});
}

TEST(WaitingPage, TakesNothingOverFromAFileThatIsNoPage) {
    for (const char* text : {"<html>", "<script type=\"application/json\" id=\"texts\">{</script>",
                             "<script type=\"application/json\" id=\"texts\">{}</script>"
                             "<script type=\"application/json\" id=\"data\">{}</script>"})
        EXPECT_EQ(header_of({.page = text, .when = "", .ladder = {}}), header_of()) << text;
}

}  // namespace pendular::reports_waiting_page_test
