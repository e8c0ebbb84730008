#pragma once

#include "data/files/formats/block_file.h"

namespace pendular {

/// Leaves out the rows that a table itself rejects: by "no" in a column such as `Valid` or `Used
/// for fit`, by "yes" in one such as `Excluded`, or by a word such as "outlier" in a column of
/// remarks. They go to `file.skipped`. Columns that reject half of the rows or more mean something
/// else.
void leave_out_rejected_rows(BlockFile& file);

}  // namespace pendular
