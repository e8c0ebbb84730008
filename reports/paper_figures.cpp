#include "reports/simulation_figures.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "reports/figure_style.h"
#include "reports/symbol.h"

namespace pendular {
namespace {

using dem::Observable;
/// Quantity of a state; a value that is not finite is not drawn.
using Of = std::function<Mean(const PaperState&)>;

constexpr const char* inverse_pressure_axis = "1/P* [1]";
constexpr const char* pressure_axis = "P* [1]";
/// Dots per curve of the emulator.
constexpr int dots = 60;

Mean exact(double value) {
    return {value, 0};
}

const Of inverse_pressure = [](const PaperState& s) { return exact(1 / s.reduced_pressure()); };
const Of pressure = [](const PaperState& s) { return exact(s.reduced_pressure()); };

Of observable(Observable which) {
    return [which](const PaperState& s) { return s[which]; };
}

/// Observable over F0/a^2 instead of the normal stress, with a sign.
Of over_pull_off(Observable which, double sign = 1) {
    return [which, sign](const PaperState& s) {
        const Mean mean = s[which];
        return Mean{sign * s.reduced_pressure() * mean.value,
                    s.reduced_pressure() * mean.standard_error};
    };
}

double content_of(double bridge_volume) {
    for (const PaperContent& content : paper_contents) {
        if (same_setting(content.bridge_volume, bridge_volume)) {
            return content.liquid_content;
        }
    }
    return 0;
}

/// Entries of the key that explain shapes by friction and colours by liquid content. Beside the
/// frictions, the contents share one entry, so that the key stays short. `shape`: of all points
/// where the frictions have no entries, by default that of friction 0.09. `most_content`: the
/// largest content that is drawn.
void add_key(Panel& panel, bool frictions, Shape shape = Shape::triangle, double most_content = 1) {
    panel.key = true;
    if (frictions) {
        for (const FrictionCode& code : friction_code) {
            panel.curves.push_back({.label = fmt::format("friction {:g}", code.friction),
                                    .colour = shape_colour,
                                    .symbol = {code.shape, Filling::hollow}});
        }
        Curve contents{.style = Curve::Style::scale};
        for (const ContentCode& code : content_code) {
            if (code.liquid_content > most_content) continue;
            contents.colours.emplace_back(code.colour);
            contents.label = fmt::format("liquid content {:g} to {:g}",
                                         content_code.front().liquid_content, code.liquid_content);
        }
        panel.curves.push_back(std::move(contents));
        return;
    }
    for (const ContentCode& code : content_code) {
        panel.curves.push_back({.label = fmt::format("liquid content {:g}", code.liquid_content),
                                .colour = std::string(code.colour),
                                .symbol = {shape, code.filling}});
    }
}

/// Points of states, a curve for each friction and bridge volume.
std::vector<Curve> points(const std::vector<const PaperState*>& states, const Of& x, const Of& y) {
    std::vector<Curve> curves;
    for (const PaperState* state : states) {
        const double content = content_of(state->bridge_volume());
        const std::string label =
            fmt::format("friction {:g}, liquid content {:g}", state->friction(), content);
        if (curves.empty() || curves.back().label != label) {
            curves.push_back({.label = label,
                              .colour = std::string(code_of(content).colour),
                              .symbol = simulated_symbol(state->friction(), content),
                              .in_key = false});
        }
        const Mean along = x(*state), up = y(*state);
        if (std::isfinite(along.value) && std::isfinite(up.value)) {
            curves.back().x.push_back(along.value);
            curves.back().y.push_back(up.value);
            curves.back().y_error.push_back(up.standard_error);
        }
    }
    std::erase_if(curves, [](const Curve& curve) { return curve.x.empty(); });
    return curves;
}

/// Panel of all states, with the key of the symbol code.
Panel all_states(const PaperStudy& study, const char* x_label, const char* y_label, const Of& x,
                 const Of& y) {
    Panel panel{.x_label = x_label, .y_label = y_label};
    add_key(panel, true);
    std::vector<Curve> curves = points(study.where([](const PaperState&) { return true; }), x, y);
    std::ranges::move(curves, std::back_inserter(panel.curves));
    return panel;
}

std::vector<const PaperState*> of_friction(const PaperStudy& study, double friction) {
    return study.where([&](const PaperState& s) { return same_setting(s.friction(), friction); });
}

Figure one_panel(const char* name, const std::string& title, Panel panel) {
    return {.name = name, .title = title, .panels = {std::move(panel)}};
}

Figure stacked(const char* name, const std::string& title, Panel upper, Panel lower) {
    lower.key = false;
    std::erase_if(lower.curves, [](const Curve& curve) { return curve.x.empty(); });
    return {.name = name,
            .title = title,
            .panels = {std::move(upper), std::move(lower)},
            .stacked = true};
}

/// Panel of an observable of dry grains against one coordinate, as the emulator gives it.
Panel dry_panel(const PaperStudy& study, const char* x_label, const char* y_label, Observable which,
                bool logarithmic, double from, double to,
                const std::function<std::pair<double, double>(double)>& at) {
    Curve band{.label = "emulator, ± 1 standard error",
               .style = Curve::Style::band,
               .colour = "#1b6ca8",
               .in_key = false};
    Curve line{.label = band.label,
               .style = Curve::Style::line,
               .colour = "#1b6ca8",
               .banded = true,
               .in_table = false};
    for (int k = 0; k < dots; ++k) {
        const double part = static_cast<double>(k) / (dots - 1);
        const double x = logarithmic ? from * std::pow(to / from, part) : from + (to - from) * part;
        const auto [friction, inertial_number] = at(x);
        const Mean mean = study.dry(which, friction, inertial_number);
        for (Curve* curve : {&band, &line}) {
            curve->x.push_back(x), curve->y.push_back(mean.value);
        }
        band.y_error.push_back(mean.standard_error);
    }
    return {.x_label = x_label,
            .y_label = y_label,
            .log_x = logarithmic,
            .references = {},
            .curves = {band, line}};
}

/// Points of the dry runs that fulfil a condition.
Curve dry_points(const PaperStudy& study, Observable which,
                 const std::function<bool(const dem::RunParameters&)>& condition,
                 double dem::RunParameters::*along) {
    Curve curve{.label = "simulations", .symbol = {Shape::circle, Filling::hollow}};
    for (const dem::RunResult& run : study.dry_runs()) {
        if (!condition(run.parameters)) continue;
        const Mean mean = emulated::training_value(run, which);
        curve.x.push_back(run.parameters.*along), curve.y.push_back(mean.value);
        curve.y_error.push_back(mean.standard_error);
    }
    return curve;
}

std::vector<Figure> dry_grains(const PaperStudy& study) {
    const auto by_friction = [&](Observable which, const char* label, double value) {
        Panel panel = dry_panel(study, "friction [1]", label, which, false, 0, 0.3,
                                [](double x) { return std::pair(x, 0.0); });
        panel.curves.push_back(dry_points(
            study, which,
            [](const dem::RunParameters& p) {
                return p.inertial_number <= 0.001 && p.friction <= 0.3;
            },
            &dem::RunParameters::friction));
        panel.key = true;
        panel.references = {
            {.label = "friction 0.09", .value = 0.09, .vertical = true, .colour = "#d62728"},
            {.label = "", .value = value, .colour = "#d62728"}};
        return panel;
    };
    const auto by_rate = [&](Observable which, const char* label) {
        Panel panel = dry_panel(study, "inertial number [1]", label, which, true, 1e-3, 0.1,
                                [](double x) { return std::pair(0.09, x); });
        panel.curves.push_back(dry_points(
            study, which,
            [](const dem::RunParameters& p) { return same_setting(p.friction, 0.09); },
            &dem::RunParameters::inertial_number));
        panel.key = true;
        return panel;
    };
    return {stacked("mustarphimu", "Dry grains, slow shear",
                    by_friction(Observable::stress_ratio, "stress ratio [1]",
                                study.dry_stress_ratio(0.09).value),
                    by_friction(Observable::solid_fraction, "solid fraction [1]",
                                study.dry_solid_fraction(0.09).value)),
            stacked("muphinertial", "Dry grains, friction 0.09",
                    by_rate(Observable::stress_ratio, "stress ratio [1]"),
                    by_rate(Observable::solid_fraction, "solid fraction [1]"))};
}

Figure liquid_contents(const PaperStudy& study) {
    Panel panel{
        .x_label = pressure_axis, .y_label = "liquid content [1]", .log_x = true, .log_y = true};
    add_key(panel, false);
    std::ranges::move(
        points(of_friction(study, 0.09), pressure, observable(Observable::liquid_content)),
        std::back_inserter(panel.curves));
    return one_panel("philphis", "Friction 0.09", std::move(panel));
}

/// Dotted lines of the straight lines of one friction, from 1/P* = 0 to the lowest P*.
std::vector<Curve> strength_lines(const PaperStudy& study, double friction) {
    std::vector<Curve> curves;
    for (const StrengthLine& line : study.lines()) {
        if (!same_setting(line.friction, friction)) continue;
        const double content = content_of(line.bridge_volume);
        curves.push_back({.label = fmt::format("line, liquid content {:g}", content),
                          .style = Curve::Style::dotted_line,
                          .x = {0, 2},
                          .y = {line.intercept.value, line.at(0.5).value},
                          .y_error = {},
                          .colour = std::string(code_of(content).colour),
                          .in_key = false});
    }
    return curves;
}

std::vector<Figure> strength_and_density(const PaperStudy& study) {
    Panel strength{.x_label = inverse_pressure_axis, .y_label = "stress ratio [1]"};
    add_key(strength, false);
    strength.curves.push_back(kind_entry("straight line", Curve::Style::dotted_line));
    std::ranges::move(strength_lines(study, 0.09), std::back_inserter(strength.curves));
    std::ranges::move(
        points(of_friction(study, 0.09), inverse_pressure, observable(Observable::stress_ratio)),
        std::back_inserter(strength.curves));
    Panel density{.x_label = inverse_pressure_axis, .y_label = "solid fraction [1]"};
    add_key(density, false);
    std::ranges::move(points(of_friction(study, 0.09), inverse_pressure,
                             [](const PaperState& s) { return s.rigid_solid_fraction(); }),
                      std::back_inserter(density.curves));
    return {one_panel("cexpnum", "Friction 0.09, lines fitted at P* >= 2.3", std::move(strength)),
            one_panel("phiexpnum", "Friction 0.09", std::move(density))};
}

std::vector<Figure> cohesions(const PaperStudy& study) {
    Curve simulated{.label = "simulated, from the straight line",
                    .symbol = {Shape::triangle, Filling::hollow}},
        rumpf{.label = "Rumpf's formula",
              .colour = "#c8502d",
              .symbol = {Shape::square, Filling::hollow}},
        general{.label = "generalised cohesion",
                .colour = "#1b6ca8",
                .symbol = {Shape::star, Filling::filled}};
    Panel by_friction{.x_label = "friction [1]", .y_label = "reduced cohesion c* [1]"};
    add_key(by_friction, false, Shape::square);
    for (const PaperContent& content : paper_contents) {
        Curve curve{.label = fmt::format("c*, liquid content {:g}", content.liquid_content),
                    .colour = std::string(code_of(content.liquid_content).colour),
                    .symbol = {Shape::square, code_of(content.liquid_content).filling},
                    .in_key = false};
        for (const StrengthLine& line : study.lines()) {
            if (!same_setting(line.bridge_volume, content.bridge_volume)) continue;
            curve.x.push_back(line.friction), curve.y.push_back(line.cohesion.value);
            curve.y_error.push_back(line.cohesion.standard_error);
            if (!same_setting(line.friction, 0.09)) continue;
            simulated.x.push_back(content.liquid_content);
            simulated.y.push_back(line.cohesion.value);
            simulated.y_error.push_back(line.cohesion.standard_error);
            rumpf.x.push_back(content.liquid_content);
            rumpf.y.push_back(
                study.mean_over(line, &closures::ClosureValues::rumpf_cohesion).value);
            general.x.push_back(content.liquid_content);
            general.y.push_back(
                study.mean_over(line, &closures::ClosureValues::generalised_cohesion).value);
        }
        if (!curve.x.empty()) by_friction.curves.push_back(std::move(curve));
    }
    Panel by_content{.x_label = "liquid content [1]",
                     .y_label = "reduced cohesion c* [1]",
                     .references = {},
                     .curves = {simulated, rumpf, general},
                     .key = true};
    return {one_panel("cphilphis", "Friction 0.09", std::move(by_content)),
            one_panel("cstarmu", "From straight lines at P* >= 2.3", std::move(by_friction))};
}

Figure effective_stress(const PaperStudy& study) {
    Panel panel = all_states(study, pressure_axis, "|σ_{12}^{cont}|/σ_{22}^{cont} [1]", pressure,
                             [](const PaperState& s) {
                                 return s.closure(&closures::ClosureValues::contact_stress_ratio);
                             });
    panel.log_x = true;
    for (const double friction : paper_frictions) {
        panel.references.push_back(
            {.label = "",
             .value = study.dry(Observable::stress_ratio, friction, grid_inertial_number).value});
    }
    return one_panel("coulombeff", "Lines: stress ratio of dry grains", std::move(panel));
}

std::vector<Figure> coordination_and_density(const PaperStudy& study) {
    const auto by_pressure = [&](const char* label, const Of& y) {
        Panel panel = all_states(study, pressure_axis, label, pressure, y);
        panel.log_x = true;
        return panel;
    };
    return {
        stacked("zzcip", "", by_pressure("Z_c [1]", observable(Observable::contact_coordination)),
                by_pressure("Z_d [1]", observable(Observable::distant_coordination))),
        one_panel("phisdiffmu", "", by_pressure("solid fraction [1]", [](const PaperState& s) {
                      return s.rigid_solid_fraction();
                  }))};
}

Figure predicted(const PaperStudy& study, const char* name, const char* title,
                 double closures::ClosureValues::*prediction) {
    Panel panel = all_states(study, "simulated stress ratio [1]", "predicted stress ratio [1]",
                             observable(Observable::stress_ratio),
                             [prediction](const PaperState& s) { return s.closure(prediction); });
    panel.diagonal = true;
    return one_panel(name, title, std::move(panel));
}

Figure cohesion_ratio(const PaperStudy& study, const char* name, const char* title,
                      double closures::ClosureValues::*prediction, double most_content) {
    Panel panel{.x_label = inverse_pressure_axis, .y_label = "predicted over fitted c* [1]"};
    add_key(panel, true, {}, most_content);
    const auto ratio = [&](const PaperState& s) {
        const StrengthLine* line = study.line(s.friction(), s.bridge_volume());
        const double predicted_cohesion = s.closure(prediction).value;
        return line == nullptr ? exact(NAN) : exact(predicted_cohesion / line->cohesion.value);
    };
    std::ranges::move(points(study.where([&](const PaperState& s) {
                          return content_of(s.bridge_volume()) <= most_content;
                      }),
                             inverse_pressure, ratio),
                      std::back_inserter(panel.curves));
    panel.references = {{.label = "", .value = 1}};
    return one_panel(name, title, std::move(panel));
}

std::vector<Figure> capillary_shear(const PaperStudy& study) {
    Panel ratio = all_states(study, inverse_pressure_axis, "distant over contact part [1]",
                             inverse_pressure, [](const PaperState& s) {
                                 return exact(s[Observable::capillary_shear_stress_distant].value /
                                              s[Observable::capillary_shear_stress_contact].value);
                             });
    return {
        one_panel("scaps", "",
                  all_states(study, inverse_pressure_axis, "a^{2}σ_{12}^{cap}/F_{0} [1]",
                             inverse_pressure, over_pull_off(Observable::capillary_shear_stress))),
        one_panel("scapcd", "Capillary shear stress of distant bridges over that of contacts",
                  std::move(ratio)),
        stacked("fabric", "",
                all_states(study, inverse_pressure_axis, "F_{12}^{c} [1]", inverse_pressure,
                           observable(Observable::fabric_12_contact)),
                all_states(study, inverse_pressure_axis, "F_{12}^{d} [1]", inverse_pressure,
                           observable(Observable::fabric_12_distant)))};
}

/// Capillary shear stress of distant bridges from the anisotropy of their fabric, and from that and
/// the anisotropy of their force.
Figure distant_approximations(const PaperStudy& study) {
    Curve fabric{
        .label = "fabric", .colour = "#d62728", .symbol = {Shape::diamond, Filling::hollow}},
        force{.label = "fabric and force",
              .colour = "#1f4fd8",
              .symbol = {Shape::diamond, Filling::filled}};
    for (const PaperState& state : study.states()) {
        closures::State network = state.network();
        network.length_anisotropy_12_distant = 0;
        const double simulated =
            over_pull_off(Observable::capillary_shear_stress_distant, -1)(state).value;
        force.x.push_back(simulated);
        force.y.push_back(-closures::distant_capillary_shear_stress(network));
        network.force_anisotropy_12_distant = 0;
        fabric.x.push_back(simulated);
        fabric.y.push_back(-closures::distant_capillary_shear_stress(network));
    }
    return one_panel("scapdapp", "-a^{2}σ_{12}^{cap,d}/F_{0}",
                     {.x_label = "simulated [1]",
                      .y_label = "predicted [1]",
                      .references = {},
                      .curves = {fabric, force},
                      .diagonal = true,
                      .key = true});
}

Figure approximation(const PaperStudy& study) {
    Panel panel = all_states(
        study, "simulated [1]", "predicted [1]", over_pull_off(Observable::capillary_shear_stress),
        [](const PaperState& s) { return exact(closures::capillary_shear_stress(s.network())); });
    panel.diagonal = true;
    return one_panel("scapapp", "a^{2}σ_{12}^{cap}/F_{0}", std::move(panel));
}

}  // namespace

std::vector<Figure> paper_figures(const PaperStudy& study) {
    std::vector<Figure> figures = dry_grains(study);
    const auto add = [&](std::vector<Figure> more) {
        std::ranges::move(more, std::back_inserter(figures));
    };
    add({liquid_contents(study)});
    add(strength_and_density(study));
    add(cohesions(study));
    add({effective_stress(study)});
    add(coordination_and_density(study));
    add({predicted(study, "appdiff", "Without capillary shear stress",
                   &closures::ClosureValues::strength3),
         predicted(study, "s12pred", "With capillary shear stress",
                   &closures::ClosureValues::strength2),
         cohesion_ratio(study, "cohcomp", "Rumpf's formula",
                        &closures::ClosureValues::rumpf_cohesion, 1),
         cohesion_ratio(study, "cohgen", "Generalised cohesion, small liquid contents",
                        &closures::ClosureValues::generalised_cohesion, 0.02)});
    add(capillary_shear(study));
    add({distant_approximations(study), approximation(study)});
    for (Figure& figure : figures) {
        if (figure.name == "mustarphimu" || figure.name == "muphinertial") continue;
        figure.title += fmt::format(
            "{} number {:g}", figure.title.empty() ? "Stiffness" : ", stiffness", paper_stiffness);
    }
    return figures;
}

}  // namespace pendular
