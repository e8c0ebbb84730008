#pragma once

#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/findings/drift.h"
#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Tests of all recordings of a study for what their rows show besides the steady means. The tests
/// are collected first, since the number of tests decides which of them are significant.
class InsideRecordings {
  public:
    /// Adds the tests of one recording's steps for wobble, stick-slip, drift and run-in. Steps of
    /// less than `least_strain` [1] in the cell are left out: such as consolidation and shear to
    /// failure, they are meant to change.
    void look_at(const std::string& file, std::vector<RecordedStep> steps, const AnnularCell& cell,
                 double least_strain);
    /// Findings that are significant among all tests (`significant_findings`), by kind.
    /// @param from_recordings readings of the study that were made from recordings
    /// @param cell cell of the study, to convert shear stresses to torques
    std::vector<RecordingFinding> findings(const std::vector<Reading>& from_recordings,
                                           const AnnularCell& cell) const;

  private:
    std::vector<RecordingFinding> wobbles_, slips_, run_ins_;
    std::vector<StepTrend> trends_;
};

}  // namespace pendular
