#pragma once

#include <filesystem>
#include <vector>

#include "bench/hidden_effects/resolve.h"
#include "bench/hidden_effects/truth.h"
#include "bench/hidden_effects/walk.h"

namespace pendular::bench {

/// Writes the results of the benchmark to a folder: hidden_effects.txt (shares of right and wrong
/// verdicts, with the rules of counting), hidden_effects_studies.csv (one row for each study),
/// hidden_effects_confusion.csv (confusion matrix), hidden_effects_next.csv (results of further
/// measurements) and a figure.
void write_report(const std::vector<Truth>& truths, const std::vector<Outcome>& outcomes,
                  const std::vector<Resolution>& resolutions, const std::filesystem::path& folder);

}  // namespace pendular::bench
