// `pendular next`: the measurement that would tell most.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "reports/draw_figure.h"
#include "reports/next_report.h"
#include "workflow/json.h"
#include "workflow/next_json.h"

namespace pendular::app {
namespace {

const char* const about_next =
    R"(Says what to measure next. Diagnoses the study; where several models explain its readings
alike, looks over everything the rig can be set to for the point at which they differ most beyond
their errors, and says how many readings tell them apart; where no point does alone, which
readings at several do together; or that none would. Where one model stands, the point that
sharpens its parameters most. The rig stands in study.toml; without it, what the readings span is
taken:

  [rig]
  normal_stress = ["0.1 kPa", "5 kPa"]
  inertial_number = [0.003, 0.1]          # or shear_rate = ["0.05 1/s", "5 1/s"]
  liquid_contents = [0, 0.007, 0.03]
  bead_mass = ["30 g", "60 g"]            # fillings of the cell
  repeats = 5                             # most readings at one point (default 5)
  readings = 12                           # most at several points together (default 12)
  wet_cost = 2                            # of a wet reading, in dry ones (default 1)
  filling_cost = 3                        # of another filling (default 0)
  wait = ["0 h", "4 h"]                   # before a reading, from the last one on (default 0)
  hour_cost = 0.5                         # of an hour of that (default 1)

  [[rig.direct]]                          # an effect that can be measured by itself,
  effect = "torque-offset"                # as a drag by the torque of the empty cell
  error = "0.05 mN m"                     # standard error of one such measurement
  cost = 0.5                              # (default 1)

What was measured so goes into study.toml too, and counts in every fit and diagnosis:

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
    options.set_threads(0, "refits done side by side");
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the random errors of the diagnosis (default 1)");
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
    for (const std::string& line : next_lines(next)) {
        console.line(line);
    }
    if (d.diagnosis.verdict == Verdict::unknown ||
        d.diagnosis.verdict == Verdict::suspect_measurement) {
        console.note("the diagnosis is " + std::string(to_string(d.diagnosis.verdict)) +
                     ": what sharpens the parameters does not mend that; see 'pendular diagnose'");
    }
    if (!session->study().rig) {
        console.note(
            "the study has no [rig]: what its readings span was taken ('pendular next "
            "--help' shows one)");
    }
    if (next.unsupported > 0) {
        console.note(
            fmt::format("The known runs do not support {} of {} conditions, which were left out.",
                        next.unsupported, next.unsupported + next.points.size()));
    }
    if (const Figure figure = next_figure(next); !figure.panels.empty()) {
        draw(figure, common->out_folder() / "figures");
        console.line(
            fmt::format("figure: {}", (common->out_folder() / "figures" / "next.png").string()));
    }
    console.json(json);
    return done;
}

}  // namespace pendular::app
