#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note for the user on each recording that was probably cut off before its last steps. A
/// recording counts as cut off if two things hold: a longer file of the same entry of study.toml
/// begins with steps at the conditions (normal stress, inertial number and liquid content) of all
/// steps of the recording, and no rows after the last step of the recording were excluded.
std::vector<std::string> notes_on_cut_files(const Study& study, const Measurements& measurements);

}  // namespace pendular
