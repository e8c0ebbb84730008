// `pendular next`: plans the most informative next measurement.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "reports/next_steps.h"
#include "workflow/json/diagnosis.h"
#include "workflow/json/parts.h"

namespace pendular::app {
namespace {

const char* const about_next =
    R"(Diagnoses the study and lists what to do next, in order: checks of the instrument and direct
measurements of effects first, then the most informative readings. If several models explain the
readings equally well, the command looks for the condition at which their predictions differ most
compared with the errors, and states how many readings tell the models apart. If no single condition
does, it combines several conditions, or states that the rheometer cannot tell the models apart. If
only one model fits, the command looks for the condition that reduces the standard errors of its
parameters most. The section [rig] of study.toml lists the settings that the rheometer can reach;
without this section, the plan stays within the range of the readings:

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
    options.offer_runs_of();
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const OpenSession session(console, *common, {"next.json", "figures"}, seed);
    const StudyDiagnosis d = session->diagnose();
    const NextMeasurement next = session->next(d);
    std::optional<ImpactTable> impacts;  // these choose among effects that could go undetected
    if (d.diagnosis.verdict == Verdict::inconclusive) {
        impacts = impacts_of(d, static_cast<std::size_t>(session->options().threads));
    }
    const std::vector<NextStep> steps =
        next_steps(d, impacts, session->resolved(), common->study_word());
    const auto json = to_json(next, d, texts_of(steps));
    write_json(common->out_folder() / "next.json", json);
    console.print(next_output(next, d, steps, session->study().rig.has_value()));
    console.json(json);  // before the figure, which needs gnuplot
    if (const Figure figure = next_figure(next); !figure.panels.empty()) {
        console.figures(common->out_folder() / "figures", {figure});
    }
    if (d.diagnosis.verdict == Verdict::missing) {
        console.next(next_command(d.diagnosis, steps, common->study_word()));
    } else {
        console.line(fmt::format(
            "Afterwards, list new recordings in study.toml, and run: pendular diagnose {}",
            common->study_word()));
    }
    return done;
}

}  // namespace pendular::app
