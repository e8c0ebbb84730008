#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/import_file.h"
#include "app/open_session.h"
#include "app/options.h"
#include "app/study_page.h"
#include "data/recordings/measurements.h"
#include "data/remarks/wording.h"
#include "reports/file_report.h"
#include "reports/recording_figures.h"
#include "workflow/json/measurements.h"
#include "workflow/study_input.h"

namespace pendular::app {
namespace {

/// A figure of each recording of a study, with the rows that its readings average.
std::vector<Figure> figures_of_recordings(const StudyInput& input, Console& console) {
    std::vector<Figure> figures;
    const auto note = [&](const std::string& text) { console.note(text); };
    for_each_recording(input.study.study(), note, [&](const FileView& view) {
        Figure figure =
            recording_figure(view, input.measurements.readings, input.measurements.left_out());
        figure.name = unused_name(figure.name, figures);
        figures.push_back(std::move(figure));
    });
    return figures;
}

}  // namespace

int import(const std::vector<std::string>& arguments) {
    ImportFileOptions file;
    Options options(
        "import STUDY | FILE... [options]",
        "Turns the recordings of a study into readings. A reading is the mean shear stress and "
        "solid fraction\n"
        "over the steady part of a step, with standard errors. Writes readings.csv and "
        "excluded.csv to the\n"
        "results folder; excluded.csv lists each range of rows that was not averaged, with the "
        "reason.\n"
        "Reports faults that the recorded values show, such as a saturated torque or a tilted lid."
        "\n\n"
        "For a single FILE that an instrument exported, prints how the file is understood: layout, "
        "encoding,\n"
        "columns with units, intervals and what each is used for, checks, and peaks (failure "
        "points).\n"
        "Several files are read one after the other: yield loci after several preshears give a "
        "flow "
        "function.\n"
        "--figures draws the recordings with the rows that are averaged, and yield loci with their "
        "Mohr\ncircles.",
        "  pendular import examples/dry-recordings\n"
        "  pendular import my-study --json -\n"
        "  pendular import export.csv --study my-study\n"
        "  pendular import exports/ --study my-study\n"
        "  pendular import export.csv --figures figures\n"
        "  pendular import 3kPa.csv 6kPa.csv --loci strengths.csv\n",
        true);
    options.set_first_word("STUDY or FILE (the folder of a study, or a file of an instrument)");
    options.leave_out({"fidelity", "store", "threads", "quiet"});
    file.declare(options);
    options.take(&file.more, a_file());
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const bool begins = !file.study.empty() && is_folder_of_files(common->study);
    if (begins || is_bare_file(common->study)) return import_file(common->study, file, console);
    if (!is_folder_of_files(common->study)) file.refuse_for_studies(options);
    if (!file.more.empty())
        throw InputError(fmt::format("unexpected argument \"{}\": a study is imported alone",
                                     file.more.front()));
    const StudyInput input =
        read_input(common->study, places_of(*common, {"readings.csv", "excluded.csv"}));
    const Measurements& measurements = input.measurements;
    write_readings(common->out_folder() / "readings.csv", measurements);
    write_excluded(common->out_folder() / "excluded.csv", measurements);
    console.print(
        import_output(measurements, common->out_folder(), common->study_word(), console.all()));
    if (!measurements.readings.empty())
        console.next(fmt::format("pendular calibrate {}", common->study_word()));
    console.json(to_json(measurements));
    if (!file.figures.empty()) console.figures(file.figures, figures_of_recordings(input, console));
    return mostly_set_aside(measurements) ? not_converged : done;
}

}  // namespace pendular::app
