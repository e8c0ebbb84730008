#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note for the user on each recording that was probably cut off, so that its last steps
/// are missing. A recording was probably cut off if its steps have the conditions of the first
/// steps of a longer file in the recording's entry of study.toml, and if no rows after the last
/// step of the recording were excluded.
std::vector<std::string> notes_on_cut_files(const Study& study, const Measurements& measurements);

}  // namespace pendular
