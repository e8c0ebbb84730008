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

/// Content of one file of measurements, with everything that the program finds in the file without
/// a study.
struct FileView {
    BlockFile file;  ///< content of the file of measurements
    /// Columns of each block (interval) of the file, in SI units.
    std::vector<IntervalSeries> series;
    /// Role of each block (interval) of the file in the test, such as "failure".
    std::vector<IntervalRole> roles;
    CellFromColumns cell;               ///< ratios of stress to torque and to force in the columns
    StatedCell stated;                  ///< radii and constants of the cell in the file's header
    std::vector<FileFinding> findings;  ///< faults of the file, such as contradictory columns
    /// Yield loci of the file: points of failure after each preshear, with the fitted straight
    /// lines.
    std::vector<YieldLocus> loci;
    /// Names of quantities that are needed to evaluate steady shear but are in no interval of the
    /// file, such as "gap" or "torque or shear stress".
    std::vector<std::string> missing;
};

/// Reads a file of measurements and examines the file without a study: columns, roles of the
/// intervals (steps of a test), constants of the cell, faults and yield loci. A table with a column
/// of interval numbers is divided into intervals.
/// @param format settings of the user for reading the file, such as layout and decimal mark
/// @param study_cell cell of a study, which is compared with the header of the file; empty: no
///         comparison
/// @throws InputError if the file cannot be read, its layout or a value is malformed, or a unit is
///         missing or wrong
FileView view_of_file(const std::filesystem::path& path, const FileFormat& format = {},
                      const std::optional<AnnularCell>& study_cell = std::nullopt);

}  // namespace pendular
