#pragma once

#include <filesystem>
#include <vector>

#include "bench/hidden_effects/resolve.h"
#include "bench/hidden_effects/truth.h"
#include "bench/hidden_effects/walk.h"

namespace pendular::bench {

/// Writes hidden_effects.txt (rates, with how they are counted), hidden_effects_studies.csv (a row
/// for each study), hidden_effects_confusion.csv, hidden_effects_next.csv and a figure to a folder.
void write_report(const std::vector<Truth>& truths, const std::vector<Outcome>& outcomes,
                  const std::vector<Resolution>& resolutions, const std::filesystem::path& folder);

}  // namespace pendular::bench
