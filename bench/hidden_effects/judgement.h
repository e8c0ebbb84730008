#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "bench/hidden_effects/walk.h"

namespace pendular::bench {

/// Study of a virtual laboratory: the hidden truth (true friction and effects), and the outcome of
/// the diagnosis.
struct LabStudy {
    const Truth* truth;
    const Outcome* outcome;
};
using Studies = std::vector<LabStudy>;

bool verdict_is(const LabStudy& study, std::string_view verdict);

/// Whether the diagnosis says that something is wrong with the model or the measurement: its
/// verdict is neither "nothing-missing" nor "inconclusive".
bool alarms(const LabStudy& study);

/// Whether the verdict is that no known effect explains the misfit ("unknown"), or that a part of
/// the measurement is wrong ("suspect-measurement").
bool flagged(const LabStudy& study);

/// Whether the verdict names at least one of the hidden effects, alone or together with other
/// effects.
bool points_at_truth(const LabStudy& study);

/// Whether the verdict is "missing" and names exactly the hidden effects.
bool right(const LabStudy& study);

/// Whether the verdict misleads a user who believes it. A misleading verdict is "missing" with an
/// effect that is not hidden, or "nothing-missing" although an effect is hidden.
bool confidently_wrong(const LabStudy& study);

/// Returns the column of the confusion matrix to which a study belongs: "nothing" if the diagnosis
/// raises no alarm (`alarms`), the names of the missing effects if the verdict is "missing", the
/// name of the verdict otherwise.
std::string confusion_column(const LabStudy& study);

/// Writes the confusion matrix of the diagnoses as a CSV file. A cell contains the number of
/// studies with the hidden truth of its row and the verdict of its column (`confusion_column`).
/// @param truths names of the hidden truths, one for each row
void write_confusion(const std::filesystem::path& file, const std::vector<std::string>& truths,
                     const Studies& studies);

}  // namespace pendular::bench
