// `pendular predict`: what known runs say of any state, without a new one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "calib/emulated_structure.h"
#include "data/input_error.h"
#include "data/nearest.h"
#include "data/number.h"
#include "data/text_file.h"
#include "reports/prediction_figure.h"

namespace pendular::app {
namespace {

using nlohmann::ordered_json;

/// A state as it is asked for.
struct Asked {
    double friction = 0.09, inertial_number = 0;
    std::optional<double> reduced_pressure, bridge_volume, liquid_content;

    /// @throws InputError for what is no state
    void check() const {
        if (!(friction >= 0 && friction <= 1)) {
            throw InputError(fmt::format("--friction {}: 0 to 1 is needed", friction));
        }
        if (!(inertial_number >= 0 && inertial_number <= dem::largest_inertial_number)) {
            throw InputError(fmt::format("--inertial-number {}: 0 to {} is needed", inertial_number,
                                         dem::largest_inertial_number));
        }
        for (const auto& [name, value] : {std::pair("reduced-pressure", reduced_pressure),
                                          std::pair("bridge-volume", bridge_volume),
                                          std::pair("liquid-content", liquid_content)}) {
            if (value && !(*value > 0 && std::isfinite(*value))) {
                throw InputError(fmt::format("--{} {}: a positive number is needed", name, *value));
            }
        }
        if (reduced_pressure && bridge_volume.has_value() == liquid_content.has_value()) {
            throw InputError("wet beads need either --bridge-volume or --liquid-content");
        }
        if (!reduced_pressure && (bridge_volume || liquid_content)) {
            throw InputError(
                "--bridge-volume and --liquid-content need --reduced-pressure: without it the "
                "beads "
                "are dry");
        }
    }

    FlowState state(const Emulator& emulator) const {
        FlowState result{friction, inertial_number};
        if (reduced_pressure) {
            result.inverse_pressure = 1 / *reduced_pressure;
            result.bridge_volume = bridge_volume
                                       ? *bridge_volume
                                       : bridge_volume_of(emulator, *liquid_content, result);
        }
        return result;
    }
};

/// What a curve varies, and how.
struct Along {
    std::string name;
    double from = 0, to = 0;
    int points = 60;
    bool logarithmic = false;

    double at(int k) const {
        const double part = static_cast<double>(k) / (points - 1);
        return logarithmic ? from * std::pow(to / from, part) : from + (to - from) * part;
    }
    void set(Asked& asked, double value) const {
        if (name == "friction") {
            asked.friction = value;
        } else if (name == "inertial_number") {
            asked.inertial_number = value;
        } else if (name == "reduced_pressure") {
            asked.reduced_pressure = value;
        } else if (name == "bridge_volume") {
            asked.bridge_volume = value;
        } else {
            asked.liquid_content = value;
        }
    }
};

/// "reduced-pressure=0.5:10".
/// @throws InputError for any other text
Along along_from(const std::string& text, int points) {
    const std::vector<std::string> names = {"friction", "inertial-number", "reduced-pressure",
                                            "bridge-volume", "liquid-content"};
    const auto equals = std::min(text.find('='), text.size());
    const auto colon = std::min(text.find(':', equals), text.size());
    const std::string name = text.substr(0, equals);
    const auto number = [&](std::size_t begin, std::size_t end) {
        return begin < text.size() ? parse_number(text.substr(begin, end - begin)) : std::nullopt;
    };
    const auto from = number(equals + 1, colon), to = number(colon + 1, text.size());
    if (std::ranges::find(names, name) == names.end()) {
        throw InputError(fmt::format("--along {}: nothing to vary is called '{}'; {}", text, name,
                                     did_you_mean(name, names)));
    }
    if (!from || !to || !(*from < *to) || points < 2) {
        throw InputError(fmt::format(
            "--along {}: two numbers are needed, the lesser first, as in {}=0.5:10", text, name));
    }
    Along along{.name = name, .from = *from, .to = *to, .points = points};
    along.logarithmic = name != "friction" && *from > 0;
    std::ranges::replace(along.name, '-', '_');
    return along;
}

ordered_json uncertain(const Estimate& estimate) {
    return {{"value", estimate.value}, {"stderr", estimate.standard_error}};
}

ordered_json state_json(const FlowState& state, const std::vector<EmulatedObservable>& observables) {
    ordered_json json = {{"friction", state.friction},
                         {"inertial_number", state.inertial_number},
                         {"reduced_pressure", nullptr},
                         {"bridge_volume", nullptr}};
    if (!state.dry()) {
        json["reduced_pressure"] = 1 / state.inverse_pressure;
        json["bridge_volume"] = state.bridge_volume;
    }
    constexpr const char* inputs[] = {"friction", "log_inertial_number", "inverse_reduced_pressure",
                                      "bridge_volume"};
    for (const auto& one : observables) {
        const std::string name(dem::observable_names[static_cast<std::size_t>(one.which)]);
        json[name] = uncertain(one.value);
        for (std::size_t k = 0; k < one.slopes.size(); ++k) {
            json[name]["by"][inputs[k]] = uncertain(one.slopes[k]);
        }
    }
    return json;
}

/// The line that says where the emulator leaves what it knows.
void warn_beyond(const std::vector<FlowState>& states, const Emulator& emulator, Console& console) {
    for (const FlowState& state : {states.front(), states.back()}) {
        if (const std::string text = emulator.beyond(state); !text.empty()) {
            console.note(
                fmt::format("extrapolated: {} of the runs known; 'pendular simulate' or "
                            "'pendular campaign' makes runs there",
                            text));
        }
    }
}

void predict_one(const Asked& asked, const Emulator& emulator, double stiffness_number,
                 Console& console) {
    const FlowState state = asked.state(emulator);
    const auto observables = emulated_at(emulator, state, stiffness_number, observables_of(state));
    for (const auto& one : observables) {
        console.line(fmt::format("{:<32} {:>22}",
                                 dem::observable_names[static_cast<std::size_t>(one.which)],
                                 with_error(one.value.value, one.value.standard_error)));
    }
    console.line(fmt::format("from {} runs; solid fraction at stiffness number {:.4g}",
                             emulator.runs().size(), stiffness_number));
    warn_beyond({state}, emulator, console);
    ordered_json json = state_json(state, observables);
    json["stiffness_number"] = stiffness_number;
    json["beyond"] = emulator.beyond(state);
    json["runs"] = emulator.runs().size();
    console.json(json);
}

void predict_along(Asked asked, const Along& along, const Emulator& emulator,
                   double stiffness_number, const std::filesystem::path& folder, Console& console) {
    PredictionCurve curve{.variable = along.name, .stiffness_number = stiffness_number};
    ordered_json json = {{"along", along.name}, {"states", ordered_json::array()}};
    for (int k = 0; k < along.points; ++k) {
        along.set(asked, along.at(k));
        curve.at.push_back(along.at(k));
        curve.states.push_back(asked.state(emulator));
        curve.observables.push_back(emulated_at(emulator, curve.states.back(), stiffness_number,
                                                observables_of(curve.states.back())));
        json["states"].push_back(state_json(curve.states.back(), curve.observables.back()));
    }
    write_whole(folder / "prediction.csv", prediction_table(curve));
    draw(prediction_figure(curve, emulator), folder / "figures");
    console.line(fmt::format("{} states from {} runs written to {} and {}", along.points,
                             emulator.runs().size(), (folder / "prediction.csv").string(),
                             (folder / "figures" / "prediction.png").string()));
    warn_beyond(curve.states, emulator, console);
    console.json(json);
}

}  // namespace

int predict(const std::vector<std::string>& arguments) {
    Options options(
        "predict [options]",
        "Tells at once what steady shear of beads would measure, with standard errors, "
        "from the runs of the\n"
        "atlas and of the store; simulates nothing. With --along, a curve as CSV and "
        "figure.",
        "  pendular predict --friction 0.09\n"
        "  pendular predict --friction 0.09 --reduced-pressure 1 --liquid-content 0.03\n"
        "  pendular predict --reduced-pressure 3 --bridge-volume 0.004 --json -\n"
        "  pendular predict --along reduced-pressure=0.5:50 --liquid-content 0.03 --out "
        "curve\n",
        false);
    options.set_out("folder for prediction.csv and the figure of --along (default: here)");
    Asked asked;
    double pressure = 0, volume = 0, content = 0, stiffness_number = 0;
    options.add("friction", &asked.friction,
                "intergranular friction coefficient [1] (default 0.09)");
    options.add("inertial-number", &asked.inertial_number,
                "shear rate times sqrt(m/(a s22)) [1] (default 0, the quasi-static limit)");
    options.add("reduced-pressure", &pressure, "P* = a^2 s22/F0 of wet beads [1] (default: dry)");
    options.add("bridge-volume", &volume, "volume of a liquid bridge over a^3 [1]");
    options.add("liquid-content", &content, "liquid volume over bead volume [1], instead of that");
    options.add("stiffness-number", &stiffness_number,
                "(E/(1 - nu^2)/s22)^(2/3), to which the solid fraction is corrected [1] (default: "
                "the fidelity's)");
    std::string along;
    int points = 60;
    options.add("along", &along, "NAME=FROM:TO of the one number to vary");
    options.add("points", &points, "states along it (default 60)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const auto take = [&](const char* name, double value, std::optional<double>& into) {
        if (options.given(name)) {
            into = value;
        }
    };
    take("reduced-pressure", pressure, asked.reduced_pressure);
    take("bridge-volume", volume, asked.bridge_volume);
    take("liquid-content", content, asked.liquid_content);
    std::optional<Along> line;
    if (!along.empty()) {
        line = along_from(along, points);
        for (const double end : {line->from, line->to}) {
            Asked at = asked;
            line->set(at, end);
            at.check();
        }
    } else {
        asked.check();
    }
    if (!options.given("stiffness-number")) {
        stiffness_number = common->fidelity.stiffness_number;
    }
    if (!(stiffness_number >= 100)) {
        throw InputError(
            fmt::format("--stiffness-number {}: 100 or more is needed", stiffness_number));
    }
    Console console(*common);
    const auto store = open_store(*common);
    auto known = known_runs(Study{}, common->fidelity, store.get());
    if (!known) {
        throw InputError(
            "there are too few runs to predict from; name an atlas in PENDULAR_ATLAS, or make runs "
            "with 'pendular campaign'");
    }
    const Emulator emulator(known->runs, std::move(known->scales));
    if (line) {
        predict_along(asked, *line, emulator, stiffness_number, common->out.value_or("."), console);
    } else {
        predict_one(asked, emulator, stiffness_number, console);
    }
    return done;
}

}  // namespace pendular::app
