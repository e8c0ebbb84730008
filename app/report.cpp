// `pendular report`: one page on a study, with switches for effects and sliders for parameters.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/diagnosis/study_evidence.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "reports/diagnosis_report.h"
#include "reports/next_report.h"
#include "reports/page/page_curves.h"
#include "reports/page/report_page.h"
#include "workflow/ladder_file.h"
#include "workflow/switched_models.h"

namespace pendular::app {
namespace {

const char* const about_report =
    R"(Writes a page on a study: one HTML file that needs no other file and no network. It shows the
verdict, measured values and model, where the model fails, which effects explain it, what they do to
the friction, the ladder of models, what to measure next, the fit with its correlations, and the
sources of all effects. Switches add the leading effects to the model and remove them, sliders move
the parameters; curves, residuals, chi2 and RMS errors follow. Every combination of the leading
effects is fitted beforehand, as 'pendular add' fits it without new simulations. Every figure saves
its numbers as CSV and its drawing as SVG.)";

/// Lines on the next measurement; one line that says why there is none.
std::vector<std::string> lines_on_next(const Session& session, const StudyDiagnosis& diagnosis) {
    try {
        return next_lines(session.next(diagnosis));
    } catch (const InputError& error) {
        return {error.what()};
    }
}

}  // namespace

int report(const std::vector<std::string>& arguments) {
    Options options("report STUDY [options]", about_report,
                    "  pendular report my-study\n"
                    "  pendular report my-study --switches 4 --out results\n",
                    true);
    options.set_threads(0, "number of refits at a time");
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the random errors of the diagnosis (default 1)");
    std::size_t switches = 6;
    options.add("switches", &switches,
                "largest number N of effects with a switch, 0 to 8 (default 6); 2^N models are "
                "fitted");
    const auto common = options.parse(arguments);
    if (!common) return done;
    if (switches > 8) throw InputError("--switches must be from 0 to 8");
    Console console(*common);
    const OpenSession session(console, *common, {"report.html"}, seed);
    const StudyDiagnosis d = session->diagnose();
    const std::vector<PagePanel> panels = page_panels(d.readings, session->study());
    const SwitchOptions switching{.most = switches, .along = points_of_curves(panels)};
    const auto folder = common->out_folder();
    std::error_code error;
    const PageContent content{
        .study = std::filesystem::absolute(session->study().file).parent_path().filename().string(),
        .study_argument = common->study_word(),
        .resolved = session->resolved(),
        .measurements = session->measurements(),
        .diagnosis = d,
        .checks = checks_of(d, session->options().seed),
        .impacts = impacts_of(d, static_cast<std::size_t>(session->options().threads)),
        .ladder = read_ladder(folder / "ladder.json"),
        .next = lines_on_next(*session.operator->(), d),
        .switched = switched_models(session->resolved(), d, session->options(), switching),
        .panels = panels,
        .version = PENDULAR_VERSION,
        .options = session->options(),
        .runs = d.models->simulation().emulator().runs().size(),
        .calibrated = std::filesystem::exists(folder / "fit.json", error)};
    console.end_progress();
    const auto file = folder / "report.html";
    write_whole(file, report_page(content));
    const SwitchedModels& fits = content.switched;
    console.answer(verdict_line(d.diagnosis, *d.models, content.checks));
    console.line(fmt::format("Page: {}", file.string()));
    const auto models = std::ranges::count_if(fits.models, [](const auto& m) { return !!m; });
    const auto counted = [](std::ptrdiff_t count, const char* one, const char* several) {
        return fmt::format("{} {}", count, count == 1 ? one : several);
    };
    console.line(fmt::format("It has {} ({}) and {}.",
                             counted(std::ssize(fits.switches), "switch", "switches"),
                             counted(models, "fitted model", "fitted models"),
                             counted(std::ssize(d.readings), "reading", "readings")));
    console.json({{"page", file.string()},
                  {"verdict", to_string(d.diagnosis.verdict)},
                  {"switches", fits.switches},
                  {"models", models}});
    console.next(next_step(d.diagnosis, common->study_word(), !d.proposals.empty()));
    return done;
}

}  // namespace pendular::app
