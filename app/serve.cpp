// `pendular serve`: the page of a study on live data, for browsers on this computer.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "app/serve/live_study.h"
#include "app/serve/page_server.h"
#include "app/serve/received_recording.h"
#include "app/study_page.h"
#include "app/terminal.h"
#include "data/files/text_file.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/study/study.h"
#include "reports/change_figure.h"
#include "reports/change_report.h"
#include "reports/draw_figure.h"
#include "reports/misfit_figures.h"
#include "reports/page/report_page.h"
#include "workflow/json/commands.h"
#include "workflow/json/fit.h"

namespace pendular::app {
namespace {

const char* const about_serve =
    R"(Shows the page of 'pendular report' in browsers on this computer and keeps it up to date: open the
address that the command prints. The page is made again whenever study.toml or a recording changes on
the disk, and says after each recording what to do next. A recording that is dragged onto the page
is stored in the study's folder, if it can be read and its name matches a 'file' pattern of a
[[recording]]. Buttons beside the switches add an effect to the study or remove it, as 'pendular add'
and 'pendular drop' do. After an error in a file, the page shows the error and the results from before
it, until the file is corrected.

The server answers only to this computer (127.0.0.1) and only to addresses with the random token that
the command prints. It reads and writes the study, its results folder and the store of simulations,
and nothing else. Ctrl-C ends it.)";

/// Options of the command.
struct ServeOptions {
    int port = 0;
    std::int64_t seed = 1;
    std::size_t switches = 6;
    bool switches_given = false;
    bool fidelity_given = false;
};

/// Adds an effect to the study or drops one, with the results of `pendular add`.
Answer change_study(Action action, const std::string& effect, const CommonOptions& common,
                    const ServeOptions& own, const std::stop_token& stop,
                    const Listener& listener) {
    OpenSession session(stop, listener, common, outputs_of_change(), own.seed,
                        OpenSession::Access::changes);
    const ChangedStudy changed =
        change_effects(*session, action, effect, FitOptions{}, !own.fidelity_given);
    Answer answer{changed.written ? 200 : 422, answer_on(changed)};
    if (!changed.written) return answer;
    for (const std::string& reason : changed.after.belief.reasons)
        answer.text += " Warning about the new fit: " + reason;
    try {
        draw_all({ladder_figure(changed.ladder), change_figure(changed)},
                 common.out_folder() / "figures");
    } catch (const std::exception& error) {
        answer.text += fmt::format(" The figure 'ladder' was not drawn: {}.", error.what());
    }
    return answer;
}

/// Writes the page to the results folder, so that the next server shows it at once. A folder that
/// cannot be written only means that the next server shows nothing at first.
void keep_page(const StudyPage& page, const std::filesystem::path& out) {
    try {
        write_whole(out / "report.html", page.alone);
    } catch (const InputError&) {
        return;
    }
}

/// Results from before in a results folder.
EarlierResults earlier_results(const std::filesystem::path& out) {
    EarlierResults earlier;
    try {
        earlier.ladder = read_ladder(out / "ladder.json");
    } catch (const InputError&) {
        earlier.ladder = {};  // none, or none that can be read: a first page has less
    }
    try {
        constexpr std::size_t largest_page = 16 << 20;  // pages have about a megabyte
        earlier.page = read_text(out / "report.html", largest_page);
        struct stat status {};
        if (stat((out / "report.html").c_str(), &status) == 0)
            earlier.when = fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(status.st_mtime));
    } catch (const InputError&) {
        return earlier;
    }
    return earlier;
}

StudyWork work_on(const CommonOptions& common, const ServeOptions& own, Console& console) {
    const auto watch = std::make_shared<StudyWatch>(common.study, common.out_folder());
    return {.look = [watch] { return watch->look(); },
            .page =
                [&](std::size_t version, const std::stop_token& stop, const Listener& listener) {
                    const OpenSession session(stop, listener, common, {}, own.seed);
                    StudyPage page = study_page(
                        *session, common,
                        own.switches_given ? std::optional(own.switches) : std::nullopt, version);
                    keep_page(page, common.out_folder());
                    return page;
                },
            .store =
                [&](const std::string& name, const std::string& bytes) {
                    return store_recording(common.study, name, bytes);
                },
            .change =
                [&](Action action, const std::string& effect, const std::stop_token& stop,
                    const Listener& listener) {
                    return change_study(action, effect, common, own, stop, listener);
                },
            .print = [&console](const std::string& line) { console.line(line); }};
}

/// Writes the address as JSON. Only the user can read a new file, since it has the token.
void write_address(Console& console, const ServerAddress& address) {
    const mode_t before = umask(077);
    console.json(address_json(address.text(), address.port));
    umask(before);
    std::fflush(stdout);
}

}  // namespace

int serve(const std::vector<std::string>& arguments) {
    Options options(
        "serve STUDY [options]", about_serve,
        "  pendular serve my-study\n"
        "  pendular serve my-study --port 8080 --switches 3   # a fixed port, switches for three "
        "effects\n",
        true);
    options.set_threads(0, "number of threads; each fits one model at a time");
    ServeOptions own;
    options.add("port", &own.port, "port of the address (default: any free one)");
    options.add("seed", &own.seed,
                "seed of the simulated random errors from which p values and power are computed "
                "(default 1)");
    options.add(
        "switches", &own.switches,
        "largest number N of effects with a switch, 0 to 8 (default 6, or 5 for more than 60 "
        "readings); 2^N models are fitted");
    const auto common = options.parse(arguments);
    if (!common) return done;
    if (own.switches > 8) throw InputError("--switches must be from 0 to 8");
    if (own.port < 0 || own.port > 65535) throw InputError("--port must be from 1 to 65535");
    checked_seed(own.seed);
    own.fidelity_given = options.given("fidelity");
    own.switches_given = options.given("switches");
    read_patterns(common->study);  // refuses what is no study; one without recordings is welcome
    Console console(*common);
    const InterruptGuard guard;
    LiveStudy study(work_on(*common, own, console),
                    waiting_page(study_name(common->study), PENDULAR_VERSION,
                                 earlier_results(common->out_folder())));
    PageServer server(own.port);
    server.start(study);
    console.answer(fmt::format("Open {} in a browser on this computer.", server.address().text()));
    console.line("Ctrl-C ends the server.");
    write_address(console, server.address());
    study.run(guard.token());
    return done;
}

}  // namespace pendular::app
