#pragma once

#include "data/files/formats/file_format.h"
#include "data/study/study_table.h"

namespace pendular {

/// Reads the keys layout, encoding, decimal, columns, intervals and repair of an entry
/// [[recording]] or [[readings]].
/// @throws InputError at the key for an unknown layout or role of an interval, and for a decimal
///         mark other than "." and ","
FileFormat read_file_format(const StudyTable& entry);

}  // namespace pendular
