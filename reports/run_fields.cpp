#include "reports/run_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "reports/figure_style.h"
#include "reports/figure_text.h"
#include "sim/dem/grain_effects.h"
#include "sim/runs/run_request.h"

namespace pendular {
namespace {

using dem::Field;
using Json = nlohmann::ordered_json;

const std::string contact_colour = model_colour, distant_colour = calibrated_colour;

/// Profiles and distributions that a run has.
std::vector<Field> fields_of(const dem::RunResult& run) {
    std::vector<Field> result;
    for (std::size_t k = 0; k < dem::field_count; ++k) {
        if (!run.fields[k].means.empty()) {
            result.push_back(static_cast<Field>(k));
        }
    }
    return result;
}

Json field_json(const dem::BinnedMeans& field, Field which) {
    const auto& about = dem::about(which);
    const auto& coordinate = dem::about(about.coordinate);
    Json json = {
        {"meaning", about.meaning},
        {"unit", about.unit},
        {"coordinate",
         {{"name", coordinate.name}, {"unit", coordinate.unit}, {"meaning", coordinate.meaning}}},
        {"at", field.at},
        {"value", Json::array()},
        {"stderr", Json::array()}};
    for (const Mean& mean : field.means) {
        json["value"].push_back(mean.value);
        json["stderr"].push_back(mean.standard_error);
    }
    return json;
}

std::string cell(double value) {
    return std::isfinite(value) ? fmt::format("{:.10g}", value) : "";
}

/// CSV of the fields over one coordinate, side by side.
std::string table_of(const dem::RunResult& run, const std::vector<Field>& shared) {
    const auto& coordinate = dem::about(dem::about(shared.front()).coordinate);
    std::string text = fmt::format("{} [{}]", coordinate.name, coordinate.unit);
    for (const Field which : shared) {
        const auto& about = dem::about(which);
        text += fmt::format(",{0} [{1}],{0}_sd [{1}]", about.name, about.unit);
    }
    text += '\n';
    for (std::size_t bin = 0; bin < run[shared.front()].at.size(); ++bin) {
        text += cell(run[shared.front()].at[bin]);
        for (const Field which : shared) {
            const Mean& mean = run[which].means[bin];
            text += fmt::format(",{},{}", cell(mean.value), cell(mean.standard_error));
        }
        text += '\n';
    }
    return text;
}

/// Curve of a field as points with error bars. Bins without samples are left out.
Curve curve_of(const dem::BinnedMeans& field, const std::string& label, const std::string& colour,
               Symbol symbol) {
    Curve curve{.label = label, .colour = colour, .symbol = symbol};
    for (std::size_t k = 0; k < field.at.size(); ++k) {
        if (std::isfinite(field.means[k].value)) {
            curve.x.push_back(field.at[k]);
            curve.y.push_back(field.means[k].value);
            curve.y_error.push_back(field.means[k].standard_error);
        }
    }
    return curve;
}

Curve contacts(const dem::RunResult& run, Field which) {
    return curve_of(run[which], "contacts", contact_colour, {Shape::circle, Filling::filled});
}

Curve distant(const dem::RunResult& run, Field which) {
    return curve_of(run[which], "bridges without contact", distant_colour,
                    {Shape::square, Filling::hollow});
}

std::string title(const std::string& what, const dem::RunResult& run) {
    const auto& p = run.parameters;
    std::string text = fmt::format("{}: μ = {:g}, {}, κ = {:g}, {} grains", what, p.friction,
                                   inertial_text(p.inertial_number), p.stiffness_number, p.grains);
    if (p.wetting) {
        text += fmt::format(", P* = {:g}, V_0 = {:g} a³", p.wetting->reduced_pressure,
                            p.wetting->bridge_volume);
    }
    if (!p.effects.empty()) {
        text += ", " + plain_text(effects_text(p.effects));
    }
    return text;
}

Figure profiles_figure(const dem::RunResult& run) {
    const auto panel = [&](Field which, const std::string& label) {
        Panel result{.x_label = "position along the gradient x_2/H",
                     .y_label = label,
                     .curves = {contacts(run, which)},
                     .x_range = {{0.0, 1.0}}};
        result.curves.front().in_key = false;
        return result;
    };
    Panel velocity = panel(Field::velocity, "velocity v_1/(γ̇H)");
    velocity.curves.front().label = "simulated";
    velocity.curves.front().in_key = true;
    velocity.curves.push_back(
        {.label = "uniform shear", .style = Curve::Style::dotted_line, .x = {0, 1}, .y = {0, 1}});
    velocity.key = Key::top_left;
    Panel solid = panel(Field::solid_fraction, solid_fraction_label);
    const Mean& mean = run[dem::Observable::solid_fraction];
    solid.references.push_back({"of the whole sample", mean.value, mean.standard_error});
    solid.key = Key::top_right;
    solid.headroom = 0.12;
    return {
        .name = "profiles",
        .title = title("Profiles along the velocity gradient", run),
        .panels = {velocity, solid,
                   panel(Field::granular_temperature, "granular temperature ⟨δv^2⟩/(3a^2γ̇^2)")}};
}

/// Panel of the probability density of the normal contact force, with a logarithmic axis. Bins
/// whose density is below 1.5 standard errors are left out: their error bars would reach zero.
Panel force_panel(const dem::RunResult& run) {
    Curve kept{.label = "contacts",
               .colour = contact_colour,
               .symbol = {Shape::circle, Filling::filled},
               .in_key = false};
    const Curve all = contacts(run, Field::contact_force);
    for (std::size_t k = 0; k < all.x.size(); ++k) {
        if (all.y[k] > 1.5 * all.y_error[k]) {
            kept.x.push_back(all.x[k]);
            kept.y.push_back(all.y[k]);
            kept.y_error.push_back(all.y_error[k]);
        }
    }
    return {.x_label = "normal force of contacts F_N/⟨F_N⟩",
            .y_label = "probability density",
            .log_y = true,
            .curves = {kept},
            .x_range = {{0.0, 8.0}}};
}

Panel angle_panel(const std::string& label, std::vector<Curve> curves) {
    return {.x_label = "angle of n from the flow to the gradient [°]",
            .y_label = label,
            .curves = std::move(curves),
            .x_range = {{0.0, 180.0}}};
}

Figure distributions_figure(const dem::RunResult& run) {
    const bool wet = run.parameters.wetting.has_value();
    Panel orientation =
        angle_panel("probability density [1/rad]", {contacts(run, Field::contact_orientation)});
    orientation.references.push_back({"isotropic", 1 / std::numbers::pi, 0});
    orientation.key = Key::top_left;
    orientation.headroom = 0.22;
    Panel force = angle_panel("mean normal force of contacts F_N/(a^2σ_{22})",
                              {contacts(run, Field::contact_force_by_orientation)});
    force.references.push_back({"of all contacts", run[dem::Observable::contact_force].value, 0});
    force.key = Key::top_left;
    force.curves.front().in_key = false;
    std::vector<Panel> panels{orientation, force, force_panel(run)};
    if (wet) {
        panels.front().curves.push_back(distant(run, Field::distant_orientation));
        panels.push_back({.x_label = "gap of bridges without contact h/a",
                          .y_label = "probability density",
                          .curves = {distant(run, Field::distant_gap)}});
    }
    return {.name = "distributions",
            .title = title("Contacts and bridges", run),
            .panels = std::move(panels),
            .columns = wet ? 2u : 0u};
}

}  // namespace

Json fields_json(const dem::RunResult& run) {
    Json json = {{"profiles", Json::object()}, {"distributions", Json::object()}};
    for (const Field which : fields_of(run)) {
        json[dem::is_profile(which) ? "profiles" : "distributions"]
            [std::string(dem::about(which).name)] = field_json(run[which], which);
    }
    return json;
}

std::map<std::string, std::string> field_tables(const dem::RunResult& run) {
    std::map<dem::Coordinate, std::vector<Field>> shared;
    for (const Field which : fields_of(run)) {
        shared[dem::about(which).coordinate].push_back(which);
    }
    std::map<std::string, std::string> tables;
    for (const auto& [coordinate, together] : shared) {
        tables[std::string(dem::about(coordinate).table) + ".csv"] = table_of(run, together);
    }
    return tables;
}

std::vector<Figure> field_figures(const dem::RunResult& run) {
    return {profiles_figure(run), distributions_figure(run)};
}

}  // namespace pendular
