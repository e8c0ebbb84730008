#pragma once

#include "data/files/formats/file_format.h"
#include "data/study/study_table.h"

namespace pendular {

/// Reads the settings for reading the files of an entry [[recording]] or [[readings]] of study.toml
/// from the keys layout, encoding, decimal, sheet, columns, intervals and repair.
/// @throws InputError at the key for an unknown layout or role of an interval, and for a decimal
///         mark other than "." and ","
FileFormat read_file_format(const StudyTable& entry);

}  // namespace pendular
