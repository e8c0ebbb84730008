// `pendular next`: plans the most informative next measurement.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "reports/diagnosis_report.h"
#include "reports/draw_figure.h"
#include "reports/next_report.h"
#include "reports/proposal_report.h"
#include "workflow/json.h"
#include "workflow/next_json.h"
#include "workflow/rival_effects.h"

namespace pendular::app {
namespace {

const char* const about_next =
    R"(Diagnoses the study and plans the next measurement. If several models explain the readings equally
well, the command looks for the condition at which their predictions differ most compared with the
errors, and states how many readings tell the models apart. If no single condition does, it combines
several conditions, or states that the rheometer cannot tell the models apart. If only one model fits,
the command looks for the condition that reduces the standard errors of its parameters most. The
section [rig] of study.toml lists the settings that the rheometer can reach; without this section, the
plan stays within the range of the readings:

  [rig]
  normal_stress = ["0.1 kPa", "5 kPa"]
  inertial_number = [0.003, 0.1]          # or shear_rate = ["0.05 1/s", "5 1/s"]
  liquid_contents = [0, 0.007, 0.03]
  bead_mass = ["30 g", "60 g"]            # fillings of the cell
  repeats = 5                             # largest number of readings at one condition (default 5)
  readings = 12                           # largest number at several conditions together (default 12)
  wet_cost = 2                            # cost of a wet reading, in units of a dry reading (default 1)
  filling_cost = 3                        # cost of each further filling, in units of a dry reading (default 0)
  wait = ["0 h", "4 h"]                   # waiting time after the last reading (default 0)
  hour_cost = 0.5                         # cost of waiting an hour, in units of a dry reading (default 1)

  [[rig.direct]]                          # an effect that can be measured directly, here the
  effect = "torque-offset"                # drag, from the torque of the empty cell
  error = "0.05 mN m"                     # standard error of one such measurement
  cost = 0.5                              # cost of one, in units of a dry reading (default 1)

If a parameter is measured directly, such as the torque of the empty cell, write its value into
study.toml; every fit and diagnosis then uses the value:

  [[direct]]
  effect = "torque-offset"
  value = "0.42 mN m"
  error = "0.05 mN m")";

}  // namespace

int next(const std::vector<std::string>& arguments) {
    Options options("next STUDY [options]", about_next,
                    "  pendular next my-study\n"
                    "  pendular next my-study --json - --quiet\n",
                    true);
    options.set_threads(0, "number of threads; each fits one model at a time");
    std::int64_t seed = 1;
    options.add("seed", &seed,
                "seed of the simulated random errors from which p values and power are computed "
                "(default 1)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const OpenSession session(console, *common, {"next.json", "figures"}, seed);
    const StudyDiagnosis d = session->diagnose();
    const NextMeasurement next = session->next(d);
    auto json = to_json(next);
    json["verdict"] = to_string(d.diagnosis.verdict);
    write_json(common->out_folder() / "next.json", json);
    const std::vector<std::string> lines = next_lines(next, d.diagnosis);
    const bool orders = orders_readings(next, d.diagnosis);
    const std::string& assumed = next.rivals.front().name;
    if (next.plans.empty() && assumed != present_model && orders) {
        console.answer(fmt::format(
            "Add {} to the model before you take readings: the diagnosis found it missing.",
            assumed));
        console.line(fmt::format("The plan for a model with {}:", assumed));
    }
    console.answer(lines.front());
    for (std::size_t k = 1; k < lines.size(); ++k) {
        console.line(lines[k]);
    }
    if (d.diagnosis.verdict == Verdict::inconclusive && next.plans.empty()) {
        console.line(
            "The plan does not aim to rule out the effects that, according to 'pendular diagnose', "
            "could go undetected.");
    }
    const std::string check = sensor_line(d.proposals);
    if (d.diagnosis.verdict == Verdict::unknown && !check.empty()) console.line(check);
    if (!orders) {
        if (const std::string methods =
                direct_methods(d.diagnosis.effects, session->resolved().catalogue());
            !methods.empty()) {
            console.line(fmt::format("Measure directly instead: {}.", methods));
            console.line(fmt::format(
                "Then write each value as [[direct]] into study.toml ('pendular next --help' shows "
                "an example), and run: pendular diagnose {}",
                common->study_word()));
        }
    }
    const bool planned = d.diagnosis.verdict != Verdict::unknown &&
                         d.diagnosis.verdict != Verdict::suspect_measurement;
    if (planned && !session->study().rig) {
        console.note(
            "study.toml has no section [rig] with the settings that the rheometer can reach: the "
            "plan stays near the conditions already measured. 'pendular next --help' shows an "
            "example.");
    }
    if (next.unsupported > 0) {
        console.note(
            fmt::format("The simulations in atlas and store do not cover {} of {} conditions; the "
                        "plan leaves them out.",
                        next.unsupported, next.unsupported + next.points.size()));
    }
    console.json(json);  // before the figure, which needs gnuplot
    if (const Figure figure = next_figure(next); !figure.panels.empty()) {
        draw(figure, common->out_folder() / "figures");
        console.figures(common->out_folder() / "figures", {"next"});
    }
    const Diagnosis& diagnosis = d.diagnosis;
    if (diagnosis.verdict == Verdict::missing && diagnosis.confidence_set.size() <= 1) {
        console.next(
            fmt::format("pendular add {} {}", common->study_word(), diagnosis.effects.front()));
    } else if (orders) {
        console.line(
            fmt::format("Then list the new recording in study.toml, and run: pendular diagnose {}",
                        common->study_word()));
    } else if (diagnosis.verdict == Verdict::unknown) {
        console.next(next_step(diagnosis, common->study_word(), !d.proposals.empty()));
    }
    return done;
}

}  // namespace pendular::app
