#include "sim/runs/store/run_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "data/formula_variant.h"
#include "sim/dem/series.h"
#include "sim/runs/run_request.h"

namespace pendular {
namespace {

using dem::RunParameters;
using dem::RunResult;

double real(const RunCell& cell) {
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
        return static_cast<double>(*whole);
    }
    if (const auto* number = std::get_if<double>(&cell)) {
        return *number;
    }
    throw std::invalid_argument("holds a text where a number is needed");
}

/// Whole number of a cell, for a number of type `Number`.
/// @throws std::invalid_argument where the cell holds something else, or more than fits the type
template <typename Number>
Number whole(const RunCell& cell) {
    const auto* number = std::get_if<std::int64_t>(&cell);
    if (!number) {
        throw std::invalid_argument("holds something other than a whole number");
    }
    if constexpr (std::is_same_v<Number, bool>) {
        return *number != 0;
    } else {
        // A seed is stored as the signed number with the same bits.
        if (sizeof(Number) < sizeof *number && !std::in_range<Number>(*number)) {
            throw std::invalid_argument(fmt::format("{} is out of range", *number));
        }
        return static_cast<Number>(*number);
    }
}

/// @throws std::invalid_argument where the cell holds a number
const std::string& text_of(const RunCell& cell) {
    const auto* text = std::get_if<std::string>(&cell);
    if (!text) {
        throw std::invalid_argument("holds a number where a text is needed");
    }
    return *text;
}

bool empty(const RunCell& cell) {
    return std::holds_alternative<std::monostate>(cell);
}

/// List of columns under construction; each call adds a column.
class Columns {
  public:
    std::vector<RunColumn> all;

    void add(std::string name, RunColumn::Type type, bool determines, auto get, auto set) {
        all.push_back({std::move(name), type, determines, get, set});
    }
    /// Adds a column of a number; `at(result)` returns a reference to it.
    void number(const std::string& name, bool determines, auto at) {
        using Number = std::remove_cvref_t<decltype(at(std::declval<RunResult&>()))>;
        if constexpr (std::is_floating_point_v<Number>) {
            add(
                name, RunColumn::Type::real, determines,
                [at](const RunResult& r) { return RunCell(at(const_cast<RunResult&>(r))); },
                [at](RunResult& r, const RunCell& cell) { at(r) = real(cell); });
        } else {
            add(
                name, RunColumn::Type::integer, determines,
                [at](const RunResult& r) {
                    return RunCell(static_cast<std::int64_t>(at(const_cast<RunResult&>(r))));
                },
                [at](RunResult& r, const RunCell& cell) { at(r) = whole<Number>(cell); });
        }
    }
    /// Adds a column of the liquid bridges; empty for a dry run.
    void wet_number(const std::string& name, double dem::Wetting::*member) {
        add(
            name, RunColumn::Type::real, true,
            [member](const RunResult& r) {
                const auto& wetting = r.parameters.wetting;
                return wetting ? RunCell((*wetting).*member) : RunCell();
            },
            [member](RunResult& r, const RunCell& cell) {
                if (!empty(cell)) {
                    wetting_of(r).*member = real(cell);
                }
            });
    }
    static dem::Wetting& wetting_of(RunResult& r) {
        auto& wetting = r.parameters.wetting;
        return wetting ? *wetting : wetting.emplace();
    }
};

std::string precision_text(const RunParameters& p) {
    std::string text;
    for (const auto& wanted : p.precision) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ",
                            dem::observable_names[static_cast<std::size_t>(wanted.which)],
                            wanted.standard_error);
    }
    return text;
}

void set_precision(RunParameters& p, std::string_view text) {
    while (!text.empty()) {
        const auto end = std::min(text.find(' '), text.size());
        p.precision.push_back(dem::precision_named(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

void add_parameters(Columns& columns) {
    columns.number(
        "friction", true, [](RunResult & r) -> auto& { return r.parameters.friction; });
    columns.number(
        "inertial_number", true,
        [](RunResult & r) -> auto& { return r.parameters.inertial_number; });
    columns.wet_number("reduced_pressure", &dem::Wetting::reduced_pressure);
    columns.wet_number("bridge_volume", &dem::Wetting::bridge_volume);
    columns.add(
        "bridge_force", RunColumn::Type::text, true,
        [](const RunResult& r) {
            const auto& wetting = r.parameters.wetting;
            return wetting ? RunCell(to_string(wetting->bridge_force)) : RunCell();
        },
        [](RunResult& r, const RunCell& cell) {
            if (!empty(cell)) {
                Columns::wetting_of(r).bridge_force = formula_variant_named(text_of(cell));
            }
        });
    columns.number(
        "stiffness_number", true,
        [](RunResult & r) -> auto& { return r.parameters.stiffness_number; });
    columns.number(
        "poisson_ratio", true, [](RunResult & r) -> auto& { return r.parameters.poisson_ratio; });
    columns.number(
        "damping", true, [](RunResult & r) -> auto& { return r.parameters.damping; });
    columns.number(
        "beads", true, [](RunResult & r) -> auto& { return r.parameters.grains; });
    columns.number(
        "strain", true, [](RunResult & r) -> auto& { return r.parameters.strain; });
    columns.number(
        "seed", true, [](RunResult & r) -> auto& { return r.parameters.seed; });
    columns.number(
        "start", true, [](RunResult & r) -> auto& { return r.parameters.start; });
    columns.number(
        "threads", true, [](RunResult & r) -> auto& { return r.threads; });
    columns.add(
        "effects", RunColumn::Type::text, true,
        [](const RunResult& r) {
            const std::string text = effects_text(r.parameters.effects);
            return text.empty() ? RunCell() : RunCell(text);
        },
        [](RunResult& r, const RunCell& cell) {
            if (!empty(cell)) {
                r.parameters.effects = effects_from(text_of(cell));
            }
        });
    columns.add(
        "precision", RunColumn::Type::text, true,
        [](const RunResult& r) {
            const std::string text = precision_text(r.parameters);
            return text.empty() ? RunCell() : RunCell(text);
        },
        [](RunResult& r, const RunCell& cell) {
            if (!empty(cell)) {
                set_precision(r.parameters, text_of(cell));
            }
        });
}

void add_outcome(Columns& columns) {
    columns.add(
        "failure", RunColumn::Type::text, false,
        [](const RunResult& r) { return r.failure.empty() ? RunCell() : RunCell(r.failure); },
        [](RunResult& r, const RunCell& cell) {
            if (!empty(cell)) {
                r.failure = text_of(cell);
            }
        });
    columns.number(
        "steady", false, [](RunResult & r) -> auto& { return r.steady; });
    columns.number(
        "crystallised", false, [](RunResult & r) -> auto& { return r.crystallised; });
    columns.number(
        "precise", false, [](RunResult & r) -> auto& { return r.precise; });
    columns.number(
        "strain_averaged", false, [](RunResult & r) -> auto& { return r.strain_averaged; });
    columns.number(
        "strain_transient", false, [](RunResult & r) -> auto& { return r.strain_transient; });
    columns.number(
        "time_step", false, [](RunResult & r) -> auto& { return r.time_step; });
    columns.number(
        "steps", false, [](RunResult & r) -> auto& { return r.steps; });
    columns.number(
        "wall_seconds", false, [](RunResult & r) -> auto& { return r.wall_seconds; });
    columns.number(
        "covariance", false, [](RunResult & r) -> auto& { return r.covariance; });
}

void add_observables(Columns& columns) {
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        const auto which = static_cast<dem::Observable>(k);
        const auto part = [&](const std::string& suffix, double Mean::*member, double unit) {
            columns.add(
                std::string(dem::observable_names[k]) + suffix, RunColumn::Type::real, false,
                [=](const RunResult& r) {
                    const bool told =
                        r.failure.empty() && (r.parameters.wetting || !dem::needs_bridges(which));
                    return told ? RunCell(r.means[k].*member * unit) : RunCell();
                },
                [=](RunResult& r, const RunCell& cell) {
                    if (!empty(cell)) {
                        r.means[k].*member = real(cell) / unit;
                    }
                });
        };
        part("", &Mean::value, 1);
        part("_stderr", &Mean::standard_error, 1);
        part("_correlation_strain", &Mean::correlation_samples, dem::block_strain);
    }
}

}  // namespace

const std::vector<RunColumn>& run_columns() {
    static const std::vector<RunColumn> columns = [] {
        Columns made;
        add_parameters(made);
        add_outcome(made);
        add_observables(made);
        return made.all;
    }();
    return columns;
}

}  // namespace pendular
