#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "bench/hidden_effects/walk.h"

namespace pendular::bench {

/// Study of a laboratory: what it hides, and the result of its diagnosis.
struct LabStudy {
    const Truth* truth;
    const Outcome* outcome;
};
using Studies = std::vector<LabStudy>;

bool verdict_is(const LabStudy& study, std::string_view verdict);

/// Whether the diagnosis calls the model incomplete.
bool alarms(const LabStudy& study);

/// Whether the verdict says that something outside the catalogue is missing, or that a part of the
/// measurement is wrong.
bool flagged(const LabStudy& study);

/// Whether a hidden effect is among those that the verdict points at.
bool points_at_truth(const LabStudy& study);

/// Whether the verdict names exactly the effects that are hidden.
bool right(const LabStudy& study);

/// Whether a user who believes the verdict is misled: another effect is named, or the model is
/// called complete although something is hidden.
bool confidently_wrong(const LabStudy& study);

/// Column of the confusion matrix to which a study belongs: "nothing", the names of the missing
/// effects, or the verdict.
std::string confusion_column(const LabStudy& study);

/// Writes the confusion matrix as a CSV file: a row for each of these truths, a column for each
/// verdict, and the number of studies.
void write_confusion(const std::filesystem::path& file, const std::vector<std::string>& truths,
                     const Studies& studies);

}  // namespace pendular::bench
