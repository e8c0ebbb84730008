// Sentences on proposals, from results made up for the purpose.
#include "reports/proposal_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reports_proposal_test {

using namespace pendular;
using testing::StartsWith;

/// Change of a quantity by a tenth at all readings.
Proposal change_of(const std::string& target) {
    Proposal proposal;
    proposal.shapes = {{.shape = {.quantity = {.target = target}}, .change = 0.1}};
    proposal.shapes.front().effect.name = target + "-change";
    proposal.model.fit.dof = 10;
    return proposal;
}

TEST(ProposalLines, AreNumberedAsAddTakesThem) {
    const auto lines =
        proposal_lines({change_of("stress_ratio"), change_of("solid_fraction")}, 100, 10);
    EXPECT_THAT(lines.front(),
                StartsWith("Proposal 1 (stress_ratio-change), a change of unknown cause"));
    EXPECT_THAT(lines.back(), StartsWith("Proposal 2 (solid_fraction-change) would explain"));
}

}  // namespace reports_proposal_test
