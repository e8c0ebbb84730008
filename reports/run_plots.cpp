#include "reports/simulation_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "data/input_error.h"
#include "reports/figure.h"
#include "reports/figure_style.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_columns.h"

namespace pendular {
namespace {

Panel course(const StoredRun& stored, const std::string& label, dem::Observable which,
             double (*value)(const dem::TraceBlock&), bool key) {
    Curve curve{.label = "averages over blocks of strain",
                .style = Curve::Style::line,
                .colour = "#1b6ca8"};
    double strain = 0;
    for (const auto& block : stored.run.trace) {
        strain += block.strain;
        curve.x.push_back(strain);
        curve.y.push_back(value(block));
    }
    const Mean& mean = stored.run[which];
    return {.x_label = "strain [1]",
            .y_label = label,
            .references = {{.label = "average", .value = mean.value, .error = mean.standard_error},
                           {.label = "transient ends",
                            .value = stored.run.strain_transient,
                            .vertical = true,
                            .colour = "#c8502d"}},
            .curves = {curve},
            .key = key};
}

std::vector<std::string> number_columns() {
    std::vector<std::string> names;
    for (const RunColumn& column : run_columns()) {
        if (column.type != RunColumn::Type::text) {
            names.push_back(column.name);
        }
    }
    return names;
}

const RunColumn* column_named(const std::string& name) {
    const auto found = std::ranges::find(run_columns(), name, &RunColumn::name);
    return found == run_columns().end() || found->type == RunColumn::Type::text ? nullptr : &*found;
}

std::optional<double> number_of(const RunColumn& column, const dem::RunResult& run) {
    const RunCell cell = column.get(run);
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
        return static_cast<double>(*whole);
    }
    const auto* number = std::get_if<double>(&cell);
    return number && std::isfinite(*number) ? std::optional(*number) : std::nullopt;
}

/// Ranges of a quantity of runs that colours tell apart; it is on neither axis.
struct Ranges {
    std::vector<std::string> labels;
    std::vector<double> ends;  ///< upper end of each range but the last
    double (*of)(const dem::RunResult&);

    std::size_t place(double value) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(ends, value) - ends.begin());
    }
};

/// The ranges of P*, or those of the friction where an axis shows P* or what follows from it.
Ranges ranges_for(const std::string& x, const std::string& y) {
    for (const std::string& axis : {x, y}) {
        if (axis == "reduced_pressure" || axis == "liquid_content" || axis == "bridge_volume") {
            return {{"friction < 0.05", "friction 0.05 to 0.1", "friction 0.1 to 0.2",
                     "friction ≥ 0.2"},
                    {0.05, 0.1, 0.2},
                    [](const dem::RunResult& run) { return run.parameters.friction; }};
        }
    }
    return {
        {"P* < 1", "P* 1 to 10", "P* ≥ 10", "dry"}, {1, 10, 1e300}, [](const dem::RunResult& run) {
            const auto& wetting = run.parameters.wetting;
            return wetting ? wetting->reduced_pressure : INFINITY;
        }};
}

/// Curves of the groups of runs, by a range and by effects on grains, without points yet.
std::vector<Curve> curves_of_groups(const Ranges& ranges) {
    std::vector<Curve> curves;
    for (const bool effects : {false, true}) {
        for (std::size_t k = 0; k < ranges.labels.size(); ++k) {
            const SeriesLook look = look_of_series(k, ranges.labels.size());
            curves.push_back(effects
                                 ? model_points(ranges.labels[k] + ", with effects on grains", look)
                                 : measured_points(ranges.labels[k], look));
            curves.back().area = 0.4;  // of hundreds of points
        }
    }
    return curves;
}

std::string words_of(std::string column) {
    std::ranges::replace(column, '_', ' ');
    return column;
}

std::string title_word(const std::string& column) {
    std::string words = words_of(column);
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    return words;
}

std::string label_of(const std::string& column) {
    if (column == "wall_seconds") {
        return "wall time [s]";
    }
    return words_of(column) + " [1]";
}

bool spans_decades(const std::vector<Curve>& curves) {
    double least = INFINITY, greatest = 0;
    for (const Curve& curve : curves) {
        for (const double x : curve.x) {
            least = std::min(least, x), greatest = std::max(greatest, x);
        }
    }
    return least > 0 && greatest > 20 * least;
}

}  // namespace

Figure trace_figure(const StoredRun& stored) {
    return {
        .name = fmt::format("run_{}", stored.id),
        .title = fmt::format("Simulation {}: friction {:.4g}, inertial number {:.3g}", stored.id,
                             stored.run.parameters.friction, stored.run.parameters.inertial_number),
        .panels = {course(
                       stored, "stress ratio [1]", dem::Observable::stress_ratio,
                       [](const dem::TraceBlock& b) { return -double{b.s12} / b.s22; }, true),
                   course(
                       stored, "solid fraction [1]", dem::Observable::solid_fraction,
                       [](const dem::TraceBlock& b) { return double{b.solid_fraction}; }, false)},
        .stacked = true};
}

Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y) {
    for (const std::string& name : {x, y}) {
        if (!column_named(name)) {
            throw InputError(fmt::format("no column '{}' of numbers; {}", name,
                                         did_you_mean(name, number_columns())));
        }
    }
    const RunColumn *along = column_named(x), *up = column_named(y),
                    *error = column_named(y + "_stderr");
    const Ranges ranges = ranges_for(x, y);
    std::vector<Curve> curves = curves_of_groups(ranges);
    std::size_t drawn = 0;
    for (const StoredRun& stored : runs) {
        const auto at = number_of(*along, stored.run), value = number_of(*up, stored.run);
        if (!stored.run.failure.empty() || !at || !value) {
            continue;
        }
        const bool effects = !stored.run.parameters.effects.empty();
        Curve& curve =
            curves[ranges.place(ranges.of(stored.run)) + (effects ? ranges.labels.size() : 0)];
        ++drawn;
        curve.x.push_back(*at);
        curve.y.push_back(*value);
        curve.y_error.push_back(error ? number_of(*error, stored.run).value_or(0) : 0);
    }
    std::erase_if(curves, [](const Curve& curve) { return curve.x.empty(); });
    if (curves.empty()) {
        throw InputError("no run has both columns; widen --where");
    }
    const bool decades = spans_decades(curves);
    return {
        .name = y + "_by_" + x,
        .title = fmt::format("{} against {} of {} simulations", title_word(y), words_of(x), drawn),
        .panels = {{.x_label = label_of(x),
                    .y_label = label_of(y),
                    .log_x = decades,
                    .curves = std::move(curves),
                    .key = true}}};
}

namespace {

using dem::Field;

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
        Panel result{.x_label = "position along the gradient x_2/H [1]",
                     .y_label = label,
                     .curves = {contacts(run, which)},
                     .x_range = {{0.0, 1.0}}};
        result.curves.front().in_key = false;
        return result;
    };
    Panel velocity = panel(Field::velocity, "velocity v_1/(γ̇H) [1]");
    velocity.curves.front().label = "simulated";
    velocity.curves.front().in_key = true;
    velocity.curves.push_back(
        {.label = "uniform shear", .style = Curve::Style::dotted_line, .x = {0, 1}, .y = {0, 1}});
    velocity.key = true;
    Panel solid = panel(Field::solid_fraction, solid_fraction_label);
    const Mean& mean = run[dem::Observable::solid_fraction];
    solid.references.push_back({"of the whole sample", mean.value, mean.standard_error});
    solid.key = true;
    return {.name = "profiles",
            .title = title("Profiles along the velocity gradient", run),
            .panels = {velocity, solid,
                       panel(Field::granular_temperature, "temperature ⟨δv^2⟩/(3a^2γ̇^2) [1]")}};
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
    return {.x_label = "normal force of contacts F_N/⟨F_N⟩ [1]",
            .y_label = "probability density [1]",
            .log_y = true,
            .curves = {kept},
            .x_range = {{0.0, 8.0}}};
}

Panel angle_panel(const std::string& label, std::vector<Curve> curves) {
    return {.x_label = "angle of contacts to the flow [°]",
            .y_label = label,
            .curves = std::move(curves),
            .x_range = {{0.0, 180.0}}};
}

Figure distributions_figure(const dem::RunResult& run) {
    const bool wet = run.parameters.wetting.has_value();
    Panel orientation =
        angle_panel("probability density [1/rad]", {contacts(run, Field::contact_orientation)});
    orientation.references.push_back({"isotropic", 1 / std::numbers::pi, 0});
    orientation.key = true;
    Panel force = angle_panel("mean force F_N/(a^2σ_{22}) [1]",
                              {contacts(run, Field::contact_force_by_orientation)});
    force.references.push_back({"of all contacts", run[dem::Observable::contact_force].value, 0});
    force.key = true;
    force.curves.front().in_key = false;
    std::vector<Panel> panels{orientation, force, force_panel(run)};
    if (wet) {
        panels.front().curves.push_back(distant(run, Field::distant_orientation));
        panels.push_back({.x_label = "gap of bridges without contact h/a [1]",
                          .y_label = "probability density [1]",
                          .curves = {distant(run, Field::distant_gap)}});
    }
    return {.name = "distributions",
            .title = title("Contacts and bridges", run),
            .panels = std::move(panels),
            .columns = wet ? 2u : 0u};
}

}  // namespace

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
