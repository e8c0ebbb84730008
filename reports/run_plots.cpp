#include "reports/run_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "data/input_error.h"
#include "data/quantities/nearest.h"
#include "sim/runs/store/run_columns.h"

namespace pendular {
namespace {

const char* const colours[] = {"#000000", "#1b6ca8", "#c8502d", "#2f8f4e"};

Panel course(const StoredRun& stored, const std::string& label, dem::Observable which,
             double (*value)(const dem::TraceBlock&)) {
    Curve curve{.label = "blocks of strain", .style = Curve::Style::line, .colour = "#1b6ca8"};
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
            .key = Key::outside};
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

/// Index of a run's group among `curves_of_groups`. Without effects on grains: 0 for dry runs, 1 to
/// 3 for wet runs with P* below 1, from 1 to 10 and above 10; with effects on grains: 4 to 7.
std::size_t group_of(const dem::RunResult& run) {
    const auto& wetting = run.parameters.wetting;
    const std::size_t wetness = !wetting                            ? 0
                                : wetting->reduced_pressure < 1     ? 1
                                : wetting->reduced_pressure <= 10.0 ? 2
                                                                    : 3;
    return run.parameters.effects.empty() ? wetness : wetness + std::size(colours);
}

/// Curves of the groups of runs, by dryness or P* and by effects on grains, without points yet.
std::vector<Curve> curves_of_groups() {
    const std::vector<std::string> labels = {"dry", "P* < 1", "P* 1 to 10", "P* > 10"};
    std::vector<Curve> curves;
    for (const bool effects : {false, true}) {
        for (std::size_t k = 0; k < labels.size(); ++k) {
            curves.push_back(
                {.label = labels[k] + (effects ? ", effects" : ""), .colour = colours[k]});
            if (effects) {
                curves.back().symbol = {Shape::square, Filling::hollow};
            }
        }
    }
    return curves;
}

std::string label_of(const std::string& column) {
    if (column == "wall_seconds") {
        return "wall time [s]";
    }
    std::string label = column;
    std::ranges::replace(label, '_', ' ');
    return label + " [1]";
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
        .title = fmt::format("run {}: friction {:.4g}, inertial number {:.3g}", stored.id,
                             stored.run.parameters.friction, stored.run.parameters.inertial_number),
        .panels = {course(stored, "stress ratio [1]", dem::Observable::stress_ratio,
                          [](const dem::TraceBlock& b) { return -double{b.s12} / b.s22; }),
                   course(stored, "solid fraction [1]", dem::Observable::solid_fraction,
                          [](const dem::TraceBlock& b) { return double{b.solid_fraction}; })},
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
    std::vector<Curve> curves = curves_of_groups();
    for (const StoredRun& stored : runs) {
        const auto at = number_of(*along, stored.run), value = number_of(*up, stored.run);
        if (!stored.run.failure.empty() || !at || !value) {
            continue;
        }
        Curve& curve = curves[group_of(stored.run)];
        curve.x.push_back(*at);
        curve.y.push_back(*value);
        curve.y_error.push_back(error ? number_of(*error, stored.run).value_or(0) : 0);
    }
    std::erase_if(curves, [](const Curve& curve) { return curve.x.empty(); });
    if (curves.empty()) {
        throw InputError("no run has both columns; widen --where");
    }
    const bool decades = spans_decades(curves);
    return {.name = y + "_by_" + x,
            .title = fmt::format("{} runs", runs.size()),
            .panels = {{.x_label = label_of(x),
                        .y_label = label_of(y),
                        .log_x = decades,
                        .curves = std::move(curves),
                        .key = Key::outside}}};
}

}  // namespace pendular
