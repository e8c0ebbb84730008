#include "workflow/odd_recording.h"

namespace pendular {

const FittedModel& explaining_model(const Diagnosis& d) {
    if (d.leaders) return d.leaders->model;
    const FittedModel* best = nullptr;
    for (const FittedModel& each : d.confidence_set) {
        if (each.suspect) continue;
        if (each.chosen.empty()) return each;
        if (!best || each.fit.chi2 < best->fit.chi2) best = &each;
    }
    return best ? *best : d.base;
}

std::optional<OddFile> odd_recording(const StudyDiagnosis& d) {
    if (d.readings.size() != d.measured) return std::nullopt;
    return odd_file(d.readings, explaining_model(d.diagnosis).fit.prediction.value);
}

}  // namespace pendular
