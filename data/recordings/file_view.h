#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/files/formats/layouts.h"
#include "data/recordings/file_checks.h"
#include "data/recordings/interval_roles.h"
#include "data/recordings/stated_cell.h"
#include "data/recordings/yield_locus.h"

namespace pendular {

/// Content of one file of measurements, with everything that is found in it without a study. One
/// element of `series` and `roles` belongs to each block of the file, an interval.
struct FileView {
    BlockFile file;
    std::vector<IntervalSeries> series;
    std::vector<IntervalRole> roles;
    CellFromColumns cell;  ///< from the columns
    StatedCell stated;     ///< from the header
    std::vector<Remark> findings;
    std::vector<YieldLocus> loci;
    /// Quantities that steady shear needs but no interval has, such as "torque or shear stress".
    std::vector<std::string> missing;
};

/// Reads and examines a file of measurements. A table with a column of interval numbers is divided
/// into intervals.
/// @param study_cell cell of a study, compared with the header of the file; empty: no comparison
/// @throws InputError if the file cannot be read, its layout or a value is malformed, or a unit is
///         missing or wrong
FileView view_of_file(const std::filesystem::path& path, const FileFormat& format = {},
                      const std::optional<AnnularCell>& study_cell = std::nullopt);

}  // namespace pendular
