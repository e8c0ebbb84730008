#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/import_file.h"
#include "app/open_session.h"
#include "app/options.h"
#include "app/recording_views.h"
#include "data/files/write_tables.h"
#include "data/remarks/wording.h"
#include "reports/recording_figures.h"
#include "reports/tables.h"
#include "workflow/json.h"
#include "workflow/study_input.h"

namespace pendular::app {
namespace {

/// Heading and sentences on the findings inside the recordings; empty if there are none.
/// Saturations are left out without `all`, since warnings name them.
std::vector<std::string> findings_lines(std::vector<Remark> findings, bool all) {
    if (!all) {
        std::erase_if(findings,
                      [](const Remark& each) { return each.kind == Remark::Kind::saturation; });
    }
    std::vector<std::string> lines;
    for (const std::string& sentence : sentences(findings, all))
        lines.push_back("  " + sentence);
    if (!lines.empty()) lines.insert(lines.begin(), "The recordings themselves show:");
    return lines;
}

/// Heading and sentences on the files' headers and set points; empty for nothing.
std::vector<std::string> file_findings_lines(const std::vector<Remark>& findings, bool all) {
    std::vector<std::string> lines;
    for (const Remark& finding : findings)
        lines.push_back(fmt::format("  {}: {}",
                                    std::filesystem::path(finding.file()).filename().string(),
                                    with_lines(finding, all ? finding.lines.size() : 8)));
    if (!lines.empty()) lines.insert(lines.begin(), "Checks of the files show:");
    return lines;
}

/// A figure of each recording of a study, with the rows that its readings average.
std::vector<Figure> figures_of_recordings(const StudyInput& input, Console& console) {
    std::vector<Figure> figures;
    const auto note = [&](const std::string& text) { console.note(text); };
    for_each_recording(input.study.study(), note, [&](const FileView& view) {
        Figure figure =
            recording_figure(view, input.measurements.readings, input.measurements.left_out());
        const std::string name = figure.name;
        for (int k = 2; std::ranges::find(figures, figure.name, &Figure::name) != figures.end();
             ++k)
            figure.name = fmt::format("{}_{}", name, k);
        figures.push_back(std::move(figure));
    });
    return figures;
}

}  // namespace

int import(const std::vector<std::string>& arguments) {
    ImportFileOptions file;
    Options options(
        "import STUDY | FILE [options]",
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
        "--figures draws the recordings with the rows that are averaged, and yield loci with their "
        "Mohr\ncircles.",
        "  pendular import examples/dry-recordings\n"
        "  pendular import my-study --json -\n"
        "  pendular import export.csv --study my-study\n"
        "  pendular import export.csv --figures figures\n",
        true);
    options.set_first_word("STUDY or FILE (the folder of a study, or a file of an instrument)");
    options.leave_out({"fidelity", "store", "threads", "quiet"});
    file.declare(options);
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    if (is_bare_file(common->study)) return import_file(common->study, file, console);
    file.refuse_for_studies(options);
    const StudyInput input =
        read_input(common->study, places_of(*common, {"readings.csv", "excluded.csv"}));
    const Measurements& measurements = input.measurements;
    const auto readings = common->out_folder() / "readings.csv";
    write_readings(readings, measurements);
    write_excluded(common->out_folder() / "excluded.csv", measurements);
    const std::string left_out = excluded_text(measurements);
    const std::string reason = common_reason(measurements).value_or("");
    console.answer(fmt::format("{} written to {}.{}{}{}",
                               measurements.readings.size() == 1
                                   ? "1 reading"
                                   : fmt::format("{} readings", measurements.readings.size()),
                               readings.string(),
                               left_out.empty()
                                   ? ""
                                   : fmt::format(" Excluded: {} (listed in {}).", left_out,
                                                 (common->out_folder() / "excluded.csv").string()),
                               reason.empty() ? "" : " ", reason));
    for (const Remark& doubt : measurements.doubts()) {
        console.line(fmt::format("Warning: {} {}", text_of(doubt),
                                 doubt.outcome == Remark::Outcome::set_aside
                                     ? "The affected readings are excluded."
                                     : "The affected readings are kept."));
    }
    console.table(findings_lines(measurements.faults(true), console.all()), 6);
    console.table(file_findings_lines(measurements.faults(false), console.all()), 6);
    if (!measurements.readings.empty()) console.table(readings_table(measurements), 7);
    if (console.all()) console.table(excluded_table(measurements), 0);
    console.table(scatter_table(measurements), 5);
    for (const Remark& note : measurements.notes()) {
        console.note(text_of(note));
    }
    if (measurements.readings.empty()) {
        console.note(
            fmt::format("No step of the recordings gave a reading. 'pendular import {} --all' "
                        "lists the excluded rows with the reasons.",
                        common->study_word()));
    } else {
        console.next(fmt::format("pendular calibrate {}", common->study_word()));
    }
    console.json(to_json(measurements));
    if (!file.figures.empty())
        draw_all(figures_of_recordings(input, console), file.figures, console);
    return mostly_set_aside(measurements) ? not_converged : done;
}

}  // namespace pendular::app
