#include "app/study_input.h"

#include "sim/effect_catalogue.h"

namespace pendular::app {

StudyInput read_input(const std::filesystem::path& path) {
    Study study = read_study(path);
    EffectCatalogue(study).active(study);  // refuses a list that cannot be used before any work
    Measurements measurements = read_measurements(study);
    return {std::move(study), std::move(measurements)};
}

}  // namespace pendular::app
