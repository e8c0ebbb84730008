#include "workflow/session.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "calib/model/mohr_coulomb.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "workflow/confirm_diagnosis.h"
#include "workflow/json/fit.h"
#include "workflow/rivals.h"

namespace pendular {

namespace {

/// Places for output, with the session's default folder and files where none are given.
OutputPlaces with_own_files(const std::filesystem::path& study, OutputPlaces places) {
    if (places.folder.empty()) places.folder = study_folder(study) / "out";
    if (places.files.empty()) places.files = {"fit.json", "fit_runs.csv", "ladder.json"};
    return places;
}

}  // namespace

Session::Session(const std::filesystem::path& study, SessionOptions options, OutputPlaces outputs)
    : Session(read_input(study, with_own_files(study, outputs)), std::move(options),
              with_own_files(study, outputs).folder) {}

Session::Session(StudyInput input, SessionOptions options, std::filesystem::path folder)
    : options_(std::move(options)), folder_(std::move(folder)), input_(std::move(input)) {}

FittedStudy Session::calibrate(const FitOptions& fit) const {
    FittedStudy result =
        fitted(input_.study, fit_study(input_.study, measurements(), options_, fit));
    result.belief = belief_in(result, input_.study, measurements());
    write_calibration(folder_, result.calibration, result.comparison, result.belief);
    return result;
}

FittedStudy Session::compare() const {
    demand_readings(study(), measurements());
    FittedStudy result = fitted(input_.study, read_calibration(folder_ / "fit.json", input_.study,
                                                               readings_to_fit(measurements())));
    add_cohesion_lines(result.model->model(), result.calibration);
    result.belief = belief_in(result, input_.study, measurements());
    return result;
}

Prediction Session::predict(const std::vector<Condition>& conditions) const {
    const Calibration c =
        read_calibration(folder_ / "fit.json", input_.study, readings_to_fit(measurements()));
    std::vector<Reading> wanted;
    for (const Condition& condition : conditions) {
        wanted.push_back(
            {.origin = {"condition " + std::to_string(wanted.size() + 1)}, .condition = condition});
    }
    check_range(wanted, study(), c.fidelity);
    const StudyModel model(input_.study, c);
    check_parameters(c, model.model());
    return predict_unseen(model.model(), c, conditions);
}

StudyDiagnosis Session::diagnose(std::optional<double> confirming_seconds) const {
    const Ladder ladder = read_ladder(folder_ / "ladder.json");  // throws before any work
    StudyDiagnosis diagnosis =
        confirming_seconds
            ? confirm_diagnosis(input_.study, measurements(), options_, *confirming_seconds)
            : diagnose_study(input_.study, measurements(), options_);
    diagnosis.rivals = rivals_not_ruled_out(diagnosis, input_.study, ladder);
    return diagnosis;
}

NextMeasurement Session::next(const StudyDiagnosis& diagnosis) const {
    return next_measurement(input_.study, diagnosis);
}

ChangedStudy Session::add(const std::string& effect, const ChangeOptions& options) {
    return change(Action::add, effect, options);
}

ChangedStudy Session::drop(const std::string& effect, const ChangeOptions& options) {
    return change(Action::drop, effect, options);
}

ChangedStudy Session::change(Action action, const std::string& effect,
                             const ChangeOptions& options) {
    const std::filesystem::path file = study().file;
    if (read_text(file, largest_settings) != input_.text) {
        throw InputError({file.string()},
                         "has changed since it was read; nothing was written: give the same "
                         "command again, or open another session");
    }
    ChangedStudy result =
        change_study(input_.study, measurements(), action, effect, options_, options, folder_);
    if (result.written) {
        // Read again, since result.change.study has the places of effects in the old text.
        input_.study = with_strengths(read_study(file), measurements().readings);
        input_.text = result.change.new_text;
    }
    return result;
}

}  // namespace pendular
