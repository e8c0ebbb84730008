#pragma once

#include "data/files/formats/file_format.h"
#include "data/study/study_table.h"

namespace pendular {

/// Returns the file format that an entry [[recording]] or [[readings]] of study.toml states, by the
/// keys layout, encoding, decimal, sheet, columns, intervals and repair.
/// @throws InputError at the key for an unknown layout, role of an interval or decimal mark
FileFormat read_file_format(const StudyTable& entry);

}  // namespace pendular
