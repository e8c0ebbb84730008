#pragma once

#include <optional>
#include <vector>

#include "data/recordings/file_view.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the flow function: unconfined strength against major principal stress of the yield loci
/// of files, with standard errors, and the lines between classes of flowability. Empty for fewer
/// than two loci that have both.
std::optional<Figure> flow_function_figure(const std::vector<FileView>& views);

/// Returns a figure for each wall yield locus of a file: points, and its line (`WallLocus::line`).
std::vector<Figure> wall_locus_figures(const FileView& view);

}  // namespace pendular
