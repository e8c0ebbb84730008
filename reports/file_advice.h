#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Whether a file is a table of readings.
bool shows_readings(const FileView& view);

/// Whether no interval of a file has a quantity of steady shear.
/// @param name one of `FileView::missing`
bool lacks(const FileView& view, std::string_view name);

/// Returns the quantities that readings of steady shear need but the file lacks, such as the gap
/// height, and asks the user to export them; with yield loci it says that points of failure need
/// only the stresses. If all intervals are of other tests, it says that nothing is read. Empty if
/// nothing is lacking or the file is a report of yield loci.
std::string missing_sentence(const FileView& view);

/// Returns a sentence for each unused column of corrected values beside the used one of raw values,
/// such as "Torque tared" beside "Torque", with the line that makes it the used one.
std::vector<std::string> corrected_sentences(const FileView& view);

}  // namespace pendular
