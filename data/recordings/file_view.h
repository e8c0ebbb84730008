#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/layouts.h"
#include "data/recordings/interval_roles.h"
#include "data/recordings/interval_series.h"
#include "data/recordings/stated_cell.h"
#include "data/recordings/wall_locus.h"
#include "data/recordings/yield_locus.h"

namespace pendular {

/// Constants with which an instrument converts torque and normal force to stresses, deduced from
/// the columns of a file.
struct CellFromColumns {
    double stress_per_torque = 0;  ///< [Pa/(N m)]; 0: unknown
    double stress_per_force = 0;   ///< [1/m^2]; 0: unknown
    /// Radii [m] of the commercial cup that has these ratios; empty if no known cup has them.
    std::optional<double> inner_radius, outer_radius;
};

/// Returns the constants of the cell: the most frequent ratios in the rows of a file. If the ratio
/// for normal stress is that of a commercial cup, and at least one row has the cup's ratio for
/// shear stress, the result has the radii of the cup and its ratio for shear stress. If the file
/// has only one of the two ratios, it must be that of the cup.
CellFromColumns cell_from_columns(const std::vector<IntervalSeries>& series);

/// Checks a file for contradictions within itself, and returns faults:
/// - ratio of shear stress to torque, or of normal stress to normal force, not constant to 5 %
/// - headers of two columns exchanged
/// - number of rows of an interval not as declared
/// - time that goes back within an interval
/// - normal force or stress negative in more than 90 % of the rows
/// - rows that repeat the preceding row
/// - several tests in one file
/// - constants or radii in the header that contradict the columns
/// - columns of which some rows have no value
/// - rows that a workbook hides
/// - measured values that do not follow their set points
/// @param series in the order of the file's blocks
/// @param cell from `cell_from_columns`; not used for a file with several tests
std::vector<Remark> check_file(const BlockFile& file, const std::vector<IntervalSeries>& series,
                               const CellFromColumns& cell);

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
    std::vector<WallLocus> walls;
    /// Quantities that steady shear needs but no interval has, such as "torque or shear stress".
    std::vector<std::string> missing;
    /// Columns that are not used although their unit or their name is that of a missing quantity,
    /// each with that quantity in place of the one that the file names. Only of tables of people's
    /// own: exports of instruments name what they have.
    std::vector<BlockColumn> candidates;
    /// Columns that are read as a quantity by their unit alone (`columns_by_unit`), by quantity. A
    /// study reads them where its `columns` name them.
    std::map<std::string, std::string> by_unit;
};

/// Returns the quantities that a column of `FileView::candidates` may be: a stress may be each of
/// two that are missing, and a column in an unknown unit any of them.
std::vector<std::string_view> possible_quantities(const BlockColumn& candidate,
                                                  const FileView& view);

/// Reads and examines a file of measurements. A table with a column of interval numbers is divided
/// into intervals.
/// @param study_cell cell of a study, compared with the header of the file, whose lever arm turns
///        forces on a lever into torques and stresses; empty: neither
/// @throws InputError if the file cannot be read, its layout or a value is malformed, a unit is
///         missing or wrong, or no column is read
FileView view_of_file(const std::filesystem::path& path, const FileFormat& format = {},
                      const std::optional<AnnularCell>& study_cell = std::nullopt);

}  // namespace pendular
