#pragma once

#include "data/files/formats/table_parts.h"

namespace pendular {

/// Whether a text is one of measurements of LabVIEW (.lvm).
bool is_labview(const SourceLines& source);

/// Returns the segments of such a text, each as a table with its units in its line of names: in the
/// file they stand in the line `Y_Unit_Label` above it. A table without times (`X_Columns No`) gets
/// those that begin and distance give. What the header states becomes facts of the file.
/// @throws InputError for more segments than are read, or a quote that is not closed
SeveralTables labview_segments(const SourceLines& source, BlockFile& file);

}  // namespace pendular
