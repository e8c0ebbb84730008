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

/// File of measurements as the program understands it by itself, without a study.
struct FileView {
    BlockFile file;
    std::vector<IntervalSeries> series;  ///< one for each block of the file
    std::vector<IntervalRole> roles;     ///< one for each block of the file
    CellFromColumns cell;
    StatedCell stated;  ///< what the header states about the cell
    std::vector<FileFinding> findings;
    std::vector<YieldLocus> loci;
    /// Quantities that steady shear needs and no interval has: "height" for example.
    std::vector<std::string> missing;
};

/// Reads a file of measurements and everything that it shows by itself.
/// @param study_cell cell of a study beside the file, with which the header is compared
/// @throws InputError as `read_blocks` and `series_of` do
FileView view_of_file(const std::filesystem::path& path, const FileFormat& format = {},
                      const std::optional<AnnularCell>& study_cell = std::nullopt);

}  // namespace pendular
