#include "app/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "data/input_error.h"
#include "reports/next_steps.h"
#include "reports/page/page_curves.h"
#include "reports/page/report_page.h"
#include "reports/verdict_report.h"
#include "workflow/json/fit.h"
#include "workflow/json/training_runs.h"
#include "workflow/switched_models.h"

namespace pendular::app {
namespace {

/// Lines on the planned readings; none where no reading can be planned.
std::vector<std::string> planned(const Session& session, const StudyDiagnosis& diagnosis) {
    try {
        return plan_lines(session.next(diagnosis));
    } catch (const InputError&) {
        return {};  // the steps name the command that says why
    }
}

/// The calibration in the results folder; empty where there is none of the study as it is now.
std::optional<FittedStudy> calibration_of(const Session& session) {
    try {
        return session.compare();
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace

std::string study_name(const std::filesystem::path& file) {
    const std::filesystem::path whole = std::filesystem::canonical(file);
    return (is_directory(whole) ? whole : whole.parent_path()).filename().string();
}

StudyPage study_page(const Session& session, const CommonOptions& common,
                     std::optional<std::size_t> switches, std::optional<std::size_t> version) {
    const StudyDiagnosis d = session.diagnose();
    const std::vector<PagePanel> panels = page_panels(d.readings, session.study());
    // A page is to stay below 1 MB: that of 89 readings has 1.05 MB with six switches, made in 9 s
    // on two cores, and 0.59 MB with five, in 7 s.
    constexpr std::size_t usual = 6, many_readings = 60;
    const std::size_t most =
        switches.value_or(d.readings.size() > many_readings ? usual - 1 : usual);
    const SwitchOptions switching{.most = most, .along = points_of_curves(panels)};
    const auto folder = common.out_folder();
    std::vector<std::string> notes;
    const auto impacts = impacts_of(d, static_cast<std::size_t>(session.options().threads));
    const std::vector<NextStep> steps =
        next_steps(d, impacts, session.resolved(), common.study_word());
    const auto runs = runs_json(d.models->simulation().emulator().runs());
    PageContent content{
        .study = study_name(session.study().file),
        .study_argument = common.study_word(),
        .resolved = session.resolved(),
        .measurements = session.measurements(),
        .diagnosis = d,
        .checks = checks_of(d, session.options().seed),
        .impacts = impacts,
        .ladder = read_ladder(folder / "ladder.json"),
        .steps = step_lines(steps, planned(session, d)),
        .command = is_of_fitting_model(d.diagnosis.verdict)
                       ? "pendular next " + common.study_word()  // not the one that made the page
                       : next_command(d.diagnosis, steps, common.study_word()),
        .switched = switched_models(session.resolved(), d, session.options(), switching),
        .panels = panels,
        .version = PENDULAR_VERSION,
        .options = session.options(),
        .runs = d.models->simulation().emulator().runs().size(),
        .runs_hash = runs.at("hash"),
        .calibrated = calibration_of(session),
        .served_version = version,
        .recordings =
            recordings_of(session, [&](const std::string& note) { notes.push_back(note); })};
    const SwitchedModels& fits = content.switched;
    std::string html = report_page(content), alone;
    if (version) {
        content.served_version.reset();
        alone = report_page(content);
    }
    return {.html = std::move(html),
            .alone = std::move(alone),
            .answer = verdict_line(d.diagnosis, *d.models, content.checks),
            .paste = paste_texts(content),
            .verdict = std::string(to_string(d.diagnosis.verdict)),
            .next = content.command,
            .measure = first_step(content.steps),
            .switches = fits.switches,
            .models = static_cast<std::size_t>(
                std::ranges::count_if(fits.models, [](const auto& m) { return !!m; })),
            .readings = d.readings.size(),
            .runs = runs,
            .notes = std::move(notes)};
}

void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take) {
    for (const Source& source : study.sources) {
        if (source.kind != Source::Kind::recording) continue;
        for (const std::filesystem::path& path : source.files) {
            try {
                take(view_of_file(path, source.format, study.cell));
            } catch (const InputError& error) {
                note(fmt::format("There is no figure of this recording: {}", error.what()));
            }
        }
    }
}

std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note) {
    std::size_t count = 0;
    for (const Source& source : session.study().sources) {
        if (source.kind == Source::Kind::recording) count += source.files.size();
    }
    const std::size_t most = points_of_recordings(count);
    const Measurements& measurements = session.measurements();
    const std::vector<Remark> left_out = measurements.left_out();
    std::vector<PageRecording> recordings;
    for_each_recording(session.study(), note, [&](const FileView& view) {
        recordings.push_back(page_recording(view, measurements.readings, left_out, most));
    });
    return recordings;
}

}  // namespace pendular::app
