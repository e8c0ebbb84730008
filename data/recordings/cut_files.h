#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note for the user on each recording that was probably cut off: its steps have the same
/// conditions as the first steps of a longer file of the same entry of study.toml, and no rows
/// after its last step were excluded.
std::vector<std::string> notes_on_cut_files(const Study& study, const Measurements& measurements);

}  // namespace pendular
