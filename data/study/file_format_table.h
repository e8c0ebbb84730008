#pragma once

#include "data/files/formats/file_format.h"
#include "data/study/study_table.h"

namespace pendular {

/// Returns the file format that an entry [[recording]] or [[readings]] of study.toml states for its
/// files, by the keys layout, encoding, decimal, sheet, columns, intervals and repair.
/// @throws InputError at the key if the layout is unknown, if the role of a measuring interval
///         (such as "failure") is unknown, or if the decimal mark is neither "." nor ","
FileFormat read_file_format(const StudyTable& entry);

}  // namespace pendular
