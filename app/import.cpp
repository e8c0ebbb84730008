#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/misfit/believable.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "data/files/write_tables.h"
#include "reports/tables.h"
#include "workflow/json.h"
#include "workflow/study_input.h"

namespace pendular::app {
namespace {

/// " (readings or rows were set aside for 2 doubts)"; empty where none was.
std::string set_aside_text(const Measurements& measurements) {
    const std::size_t count = doubts_that_set_aside(measurements);
    return count == 0 ? ""
                      : fmt::format(" (readings or rows were set aside for {} doubt{})", count,
                                    count == 1 ? "" : "s");
}

}  // namespace

int import(const std::vector<std::string>& arguments) {
    Options options("import STUDY [options]",
                    "Turns the recordings of a study into readings: shear stress and solid "
                    "fraction of each steady\n"
                    "step, with standard errors. Writes readings.csv and excluded.csv to the "
                    "results folder; what\n"
                    "was left out is listed with its lines and the reason.",
                    "  pendular import examples/dry-recordings\n"
                    "  pendular import my-study --json -\n",
                    true);
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const Measurements measurements =
        read_input(common->study, places_of(*common, {"readings.csv", "excluded.csv"}))
            .measurements;
    const auto readings = common->out_folder() / "readings.csv";
    write_readings(readings, measurements);
    write_excluded(common->out_folder() / "excluded.csv", measurements);
    console.line(fmt::format(
        "readings: {}{}, ranges of rows excluded: {}; see {} and excluded.csv beside it",
        measurements.readings.size(), set_aside_text(measurements), measurements.excluded.size(),
        readings.string()));
    for (const Doubt& doubt : measurements.doubts) {
        console.line(fmt::format("doubt: {} {}", doubt.what,
                                 doubt.set_aside ? "Set aside; see excluded.csv." : "Kept."));
    }
    for (const auto& line : readings_table(measurements)) {
        console.line(line);
    }
    for (const auto& line : scatter_table(measurements)) {
        console.line(line);
    }
    for (const auto& note : measurements.notes) {
        console.note(note);
    }
    console.json(to_json(measurements));
    return done;
}

}  // namespace pendular::app
