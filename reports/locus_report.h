#pragma once

#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns tables of the yield loci; empty if there are none. Each lists normal and shear stress
/// [Pa] of the points of failure, at the data point of largest shear stress and at the smoothed
/// peak, then results of the fitted line, such as cohesion and unconfined strength [Pa], with their
/// standard errors, and says whether the points are prorated.
std::vector<std::string> yield_locus_lines(const FileView& view);

/// Returns the flow function as a table: major principal stress of the preshear and unconfined
/// strength [Pa] of each yield locus of the files with their standard errors, and their ratio.
/// Empty for fewer than two loci.
std::vector<std::string> flow_function_table(const std::vector<FileView>& views);

/// Returns the points of wall yield loci, their angle of wall friction with its error, and the
/// lines of study.toml that state it as a direct measurement; empty if there are none.
std::vector<std::string> wall_locus_lines(const FileView& view);

}  // namespace pendular
