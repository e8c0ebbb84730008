#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Notes on recordings that end before their replicates do: files of one entry of the study whose
/// steps are the first ones of a longer file, without excluded rows after the last step.
std::vector<std::string> notes_on_cut_files(const Study& study, const Measurements& measurements);

}  // namespace pendular
