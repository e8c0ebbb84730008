#include "app/study_input.h"

#include "sim/direct_measurement.h"

namespace pendular::app {

StudyInput read_input(const std::filesystem::path& path) {
    Study study = read_study(path);
    // What cannot be used is refused before any work.
    const EffectCatalogue catalogue(study);
    catalogue.active(study);
    direct_measurements(study, catalogue);
    if (study.rig) {
        for (const StatedDirect& stated : study.rig->direct) {
            direct_measurement(stated, study, catalogue);
        }
    }
    Measurements measurements = read_measurements(study);
    return {std::move(study), std::move(measurements)};
}

}  // namespace pendular::app
