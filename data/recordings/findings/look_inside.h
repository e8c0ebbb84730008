#pragma once

#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/findings/drift.h"
#include "data/recordings/steps.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Searches the rows of all recordings of a study for faults that the means of steady shear do not
/// reveal, other than saturation, which decides what is averaged (`saturations`). All recordings
/// must be tested before the findings are requested, since the number of tests determines which
/// findings are significant.
class InsideRecordings {
  public:
    /// Tests the steps of one recording for wobble, stick-slip and an unfinished run-in, and keeps
    /// their trends for the test for drift. Steps with a shear strain below `least_strain` [1],
    /// such as consolidation and shear to failure, are not steady and are left out.
    void look_at(const std::string& file, std::vector<RecordedStep> steps, const AnnularCell& cell,
                 double least_strain);
    /// Returns the `significant_findings`, grouped by kind.
    /// @param from_recordings readings of the study that were made from recordings
    std::vector<Remark> findings(const std::vector<Reading>& from_recordings,
                                 const AnnularCell& cell) const;

  private:
    std::vector<Remark> wobbles_, slips_, run_ins_;
    std::vector<StepTrend> trends_;
};

}  // namespace pendular
