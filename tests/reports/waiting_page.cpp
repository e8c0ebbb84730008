// What a server shows before it has results of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/page/report_page.h"

namespace pendular::reports_waiting_page_test {

using testing::HasSubstr;
using testing::Not;

TEST(WaitingPage, SaysThatThereIsNothingYet) {
    const std::string page = waiting_page("beads", "1.0");
    EXPECT_THAT(page, HasSubstr("<h1>There are no results on this study yet.</h1>"));
    EXPECT_THAT(page, Not(HasSubstr("earlier results")));
}

TEST(WaitingPage, ShowsWhatTheLadderSaysMarkedAsEarlier) {
    LadderStep step;
    step.effects = {"wall-friction"};
    step.chi2 = 40.2;
    step.dof = 49;
    step.parameters = {{.name = "friction", .unit = "1", .value = 0.0923, .standard_error = 0.004}};
    const std::string page =
        waiting_page("beads", "1.0", {.page = "", .when = "", .ladder = {step}});
    EXPECT_THAT(page, HasSubstr("<h1>The model with wall-friction has chi2/dof 0.82.</h1>"));
    EXPECT_THAT(page, HasSubstr("intergranular friction coefficient: 0.0923 ± 0.0040"));
    EXPECT_THAT(page, HasSubstr("These are earlier results. Pendular is computing new ones."));
}

TEST(WaitingPage, TakesNothingOverFromAFileThatIsNoPage) {
    for (const char* text : {"<html>", "<script type=\"application/json\" id=\"texts\">{</script>",
                             "<script type=\"application/json\" id=\"texts\">{}</script>"
                             "<script type=\"application/json\" id=\"data\">{}</script>"}) {
        const std::string page =
            waiting_page("beads", "1.0", {.page = text, .when = "", .ladder = {}});
        EXPECT_THAT(page, HasSubstr("There are no results on this study yet.")) << text;
    }
}

}  // namespace pendular::reports_waiting_page_test
