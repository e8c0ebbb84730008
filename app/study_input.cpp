#include "app/study_input.h"

namespace pendular::app {

StudyInput read_input(const std::filesystem::path& path) {
    Study study = read_study(path);
    Measurements measurements = read_measurements(study);
    return {std::move(study), std::move(measurements)};
}

}  // namespace pendular::app
