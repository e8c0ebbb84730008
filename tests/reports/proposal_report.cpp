// Sentences on proposals, from results made up for the purpose.
#include "reports/proposal_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reports_proposal_test {

using namespace pendular;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Change of a quantity by a tenth at all readings.
Proposal change_of(const std::string& target) {
    Proposal proposal;
    proposal.shapes = {{.shape = {.quantity = {.target = target}}, .change = 0.1}};
    proposal.explanation.fit.dof = 10;
    return proposal;
}

TEST(ProposalLines, AreNumberedAsAddTakesThem) {
    const auto lines =
        proposal_lines({change_of("stress_ratio"), change_of("solid_fraction")}, 100, 10);
    EXPECT_THAT(lines.front(), StartsWith("Proposal 1, a change of unknown cause"));
    EXPECT_THAT(lines.back(), StartsWith("Proposal 2 would explain the readings as well"));
}

TEST(ProposalLines, AskToCheckTheSensorThatIsChanged) {
    EXPECT_THAT(proposal_lines({change_of("normal_force")}, 100, 10),
                Contains(HasSubstr("Check the load cell with known weights")));
    Proposal beads = change_of("stress_ratio");
    EXPECT_THAT(proposal_lines({beads}, 100, 10), Not(Contains(HasSubstr("Check"))));
    beads.alike = change_of("torque").shapes;  // would look the same
    EXPECT_THAT(proposal_lines({beads}, 100, 10),
                Contains(HasSubstr("Check the torque transducer")));
}

}  // namespace reports_proposal_test
