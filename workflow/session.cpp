#include "workflow/session.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "workflow/belief.h"
#include "workflow/fit_file.h"

namespace pendular {

Session::Session(const std::filesystem::path& study, SessionOptions options, OutputPlaces outputs)
    : options_(std::move(options)),
      folder_(outputs.folder.empty() ? study_folder(study) / "out" : outputs.folder),
      input_(read_input(study, {folder_, std::move(outputs.files), std::move(outputs.json)})) {}

CalibratedStudy Session::calibrate(const FitOptions& fit) const {
    CalibratedStudy result{.calibration = fit_study(study(), measurements(), options_, fit),
                           .comparison = {},
                           .belief = {}};
    result.comparison = pendular::compare(result.calibration);
    result.belief = belief_in(study(), measurements(), result.calibration, result.comparison);
    write_calibration(folder_, result.calibration, result.comparison, result.belief);
    return result;
}

ComparedStudy Session::compare(const std::optional<CohesionOptions>& cohesion) const {
    Calibration c = read_calibration(folder_ / "fit.json", study(), dry_first(measurements()));
    StudyModel model(study(), c);
    c.prediction = predict_readings(model.model(), c);
    Comparison comparison = pendular::compare(c);
    if (cohesion) c.cohesion = *cohesion;
    draw_cohesion_lines(c);
    // Without the errors of the fitted parameters, which the checks take out themselves.
    const Prediction at_fit =
        model.model().predict_conditions(c.fit.parameters, conditions_of(c.readings));
    WhereItFails where =
        where_it_fails(c.readings, measurements().scatter,
                       model.model().with_direct(c.fit.parameters, at_fit), c.parameters, c.direct);
    Belief belief = belief_in(study(), measurements(), c, comparison);
    return {std::move(c), std::move(model), std::move(comparison), std::move(where),
            std::move(belief)};
}

StudyDiagnosis Session::diagnose() const {
    return diagnose_study(study(), measurements(), options_);
}

NextMeasurement Session::next(const StudyDiagnosis& diagnosis) const {
    return next_measurement(study(), diagnosis);
}

ChangedStudy Session::add(const std::string& effect, const FitOptions& fit,
                          bool same_fidelity) const {
    return change(Action::add, effect, fit, same_fidelity);
}

ChangedStudy Session::drop(const std::string& effect, const FitOptions& fit,
                           bool same_fidelity) const {
    return change(Action::drop, effect, fit, same_fidelity);
}

ChangedStudy Session::change(Action action, const std::string& effect, const FitOptions& fit,
                             bool same_fidelity) const {
    return change_study(study(), measurements(), action, effect, options_,
                        {.fit = fit, .same_fidelity = same_fidelity, .folder = folder_});
}

}  // namespace pendular
