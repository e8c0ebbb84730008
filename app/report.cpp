// `pendular report`: one page on a study, with switches for effects and sliders for parameters.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "app/study_page.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "workflow/json/commands.h"

namespace pendular::app {
namespace {

const char* const about_report =
    R"(Writes a page on a study: one HTML file that needs no other file and no network. The page shows the
verdict, measured values and model, the recordings with the rows that are averaged, where the model
fails, which effects explain the misfit and how they shift the friction coefficient, all models of the
study so far, what to do next, the fit with its correlations, and the sources of all effects.
Switches add the leading effects to the model or remove them, and sliders change the parameters. The
page then draws the changed curves and residuals and states chi2 and RMS errors. Every combination of
the leading effects is fitted beforehand, as 'pendular add' fits it without new simulations. Every
figure saves its numbers as CSV and its drawing as SVG. The files results.csv, results.tex (a table
for LaTeX) and methods.txt (a paragraph on methods and result, with the references) beside the page
have fitted parameters, cohesions and misfit to paste into a paper; the page has them too.)";

/// Writes the results as one copies them into a paper, and returns the names of the files.
std::vector<std::string> write_paste(const PasteTexts& paste, const std::filesystem::path& out) {
    if (paste.csv.empty()) return {};
    write_whole(out / "results.csv", paste.csv);
    write_whole(out / "results.tex", paste.latex);
    write_whole(out / "methods.txt", paste.methods);
    return {"results.csv", "results.tex", "methods.txt"};
}

}  // namespace

int report(const std::vector<std::string>& arguments) {
    Options options("report STUDY [options]", about_report,
                    "  pendular report my-study\n"
                    "  pendular report my-study --switches 4 --out results\n",
                    true);
    options.set_threads(0, "number of threads; each fits one model at a time");
    std::int64_t seed = 1;
    options.add("seed", &seed,
                "seed of the simulated random errors from which p values and power are computed "
                "(default 1)");
    std::size_t switches = 6;
    options.add(
        "switches", &switches,
        "largest number N of effects with a switch, 0 to 8 (default 6, or 5 for more than 60 "
        "readings); 2^N models are fitted");
    options.offer_runs_of();
    const auto common = options.parse(arguments);
    if (!common) return done;
    if (switches > 8) throw InputError("--switches must be from 0 to 8");
    Console console(*common);
    const OpenSession session(console, *common,
                              {"report.html", "results.csv", "results.tex", "methods.txt"}, seed);
    const StudyPage page = study_page(
        *session, *common, options.given("switches") ? std::optional(switches) : std::nullopt);
    console.end_progress();
    const auto file = common->out_folder() / "report.html";
    write_whole(file, page.html);
    const auto to_paste = write_paste(page.paste, common->out_folder());
    console.answer(page.answer);
    console.line(fmt::format("Page: {}", file.string()));
    const auto counted = [](std::size_t count, const char* one, const char* several) {
        return fmt::format("{} {}", count, count == 1 ? one : several);
    };
    console.line(fmt::format("It has {} ({}) and {}.",
                             counted(page.switches.size(), "switch", "switches"),
                             counted(page.models, "fitted model", "fitted models"),
                             counted(page.readings, "reading", "readings")));
    if (!to_paste.empty())
        console.line(fmt::format("To paste into a paper: {}.", fmt::join(to_paste, ", ")));
    for (const std::string& note : page.notes) {
        console.note(note);
    }
    console.json(page_json(file, page.verdict, page.switches, page.models, page.runs));
    console.next(page.next);
    return done;
}

}  // namespace pendular::app
