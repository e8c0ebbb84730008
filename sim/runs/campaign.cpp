#include "sim/runs/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "data/quantities/number.h"
#include "data/study/study_table.h"
#include "sim/catalogue/effect.h"
#include "sim/runs/ensemble.h"
#include "sim/runs/run_request.h"
#include "sim/runs/run_settings.h"
#include "sim/runs/store/run_columns.h"

namespace pendular {
namespace {

/// Chosen: years of computing; more is a mistake in the ranges of the campaign.
constexpr std::size_t most_runs = 1'000'000;
constexpr double most = 1e9;  ///< largest whole number in a campaign file

bool is_count(double value) {
    return value >= 0 && value <= most && value == std::floor(value);
}

/// Returns the column "EFFECT.PARAMETER" for a parameter of an effect on grains.
RunColumn column_of(const Effect& effect, std::size_t which) {
    return {.name = fmt::format("{}.{}", effect.name, effect.parameters[which].name),
            .type = RunColumn::Type::real,
            .determines = true,
            .get = {},
            .set = [&effect, which](dem::RunResult& run, const RunCell& cell) {
                auto& effects = run.parameters.effects;
                auto at = std::ranges::find(effects, effect.name, &EffectValues::effect);
                if (at == effects.end()) {
                    at = effects.insert(at, {effect.name, effect.neutral()});
                }
                at->values[which] = std::get<double>(cell);
            }};
}

/// Columns of the parameters of all effects on grains.
const std::vector<RunColumn>& effect_parameters() {
    static const std::vector<RunColumn> all = [] {
        std::vector<RunColumn> columns;
        for (const Effect& effect : built_in_effects()) {
            for (std::size_t k = 0; effect.of_grains() && k < effect.parameters.size(); ++k) {
                columns.push_back(column_of(effect, k));
            }
        }
        return columns;
    }();
    return all;
}

/// Columns that a campaign file may set: the parameters of effects on grains and the numbers that
/// determine a run, except seed, start and threads, which the campaign chooses.
const std::vector<const RunColumn*>& parameters() {
    static const std::vector<const RunColumn*> all = [] {
        std::vector<const RunColumn*> columns;
        for (const RunColumn& column : effect_parameters()) {
            columns.push_back(&column);
        }
        for (const RunColumn& column : run_columns()) {
            const bool chosen =
                column.name == "seed" || column.name == "start" || column.name == "threads";
            if (column.determines && column.type != RunColumn::Type::text && !chosen) {
                columns.push_back(&column);
            }
        }
        return columns;
    }();
    return all;
}

std::vector<std::string> keys_and(const std::vector<std::string>& others) {
    std::vector<std::string> keys = others;
    for (const RunColumn* parameter : parameters()) {
        const std::string key = parameter->name.substr(0, parameter->name.find('.'));
        if (std::ranges::find(keys, key) == keys.end()) {
            keys.push_back(key);
        }
    }
    return keys;
}

/// Returns the numbers that a table gives for a parameter. A parameter "EFFECT.PARAMETER" is read
/// from the table of the effect.
std::vector<double> numbers_of(const StudyTable& table, const RunColumn& parameter) {
    const auto dot = parameter.name.find('.');
    if (dot == std::string::npos) {
        return table.numbers(parameter.name);
    }
    const Effect& effect = built_in_effect(parameter.name.substr(0, dot));
    std::vector<std::string> keys;
    std::ranges::transform(effect.parameters, std::back_inserter(keys), &EffectParameter::name);
    const auto own = table.table(effect.name, keys);
    return own ? own->numbers(parameter.name.substr(dot + 1)) : std::vector<double>{};
}

/// Returns a whole number of a table, or `missing` where the table does not have the key.
/// @throws InputError for a number below `least`, above `most_runs` or not whole
std::size_t count(const StudyTable& table, std::string_view key, double missing, double least) {
    const double value = table.quantity(key, "1").value_or(missing);
    if (value < least || value != std::floor(value) || value > most_runs) {
        table.refuse(key, fmt::format("must be a whole number from {} to {}", least, most_runs));
    }
    return static_cast<std::size_t>(value);
}

/// The numbers of each key that a table has, in the order of `parameters`.
using ColumnValues = std::vector<std::pair<const RunColumn*, std::vector<double>>>;

ColumnValues columns_of(const StudyTable& table) {
    ColumnValues columns;
    for (const RunColumn* parameter : parameters()) {
        auto numbers = numbers_of(table, *parameter);
        if (parameter->type == RunColumn::Type::integer &&
            !std::ranges::all_of(numbers, is_count)) {
            table.refuse(parameter->name, fmt::format("must be whole numbers up to {}", most));
        }
        if (!numbers.empty()) {
            columns.emplace_back(parameter, std::move(numbers));
        }
    }
    if (table.has("bridge_volume") && !table.has("reduced_pressure")) {
        table.refuse("bridge_volume", "needs reduced_pressure: without it the grains are dry");
    }
    return columns;
}

/// One point of a table: the columns to set in a run, with their values.
using Point = std::vector<std::pair<const RunColumn*, double>>;

std::vector<Point> grid_points(const StudyTable& table) {
    std::vector<Point> points(1);
    for (const auto& [parameter, numbers] : columns_of(table)) {
        std::vector<Point> more;
        if (points.size() * numbers.size() > most_runs) {
            table.refuse(parameter->name,
                         fmt::format("makes more than {} simulations of this grid", most_runs));
        }
        for (const Point& point : points) {
            for (const double number : numbers) {
                more.push_back(point);
                more.back().emplace_back(parameter, number);
            }
        }
        points = std::move(more);
    }
    return points;
}

std::vector<Point> list_points(const StudyTable& table) {
    const ColumnValues columns = columns_of(table);
    std::size_t length = 1;
    for (const auto& column : columns) {
        length = std::max(length, column.second.size());
    }
    std::vector<Point> points(length);
    for (const auto& [parameter, numbers] : columns) {
        if (numbers.size() != 1 && numbers.size() != length) {
            table.refuse(parameter->name,
                         fmt::format("has {} numbers where another key of this list has {}; give "
                                     "one, or as many",
                                     numbers.size(), length));
        }
        for (std::size_t k = 0; k < length; ++k) {
            points[k].emplace_back(parameter, numbers[numbers.size() == 1 ? 0 : k]);
        }
    }
    return points;
}

std::vector<Point> sobol_points(const StudyTable& table) {
    const std::size_t wanted = count(table, "points", 0, 1);
    const auto logarithmic = table.words("logarithmic", {});
    ColumnValues fixed, ranges;
    for (auto& column : columns_of(table)) {
        (column.second.size() == 1 ? fixed : ranges).push_back(std::move(column));
    }
    for (const auto& [parameter, range] : ranges) {
        if (range.size() != 2 || !(range[0] < range[1])) {
            table.refuse(parameter->name, "must be one number or [least, greatest]");
        }
    }
    for (const std::string& key : logarithmic) {
        const auto found = std::ranges::find_if(
            ranges, [&](const auto& range) { return range.first->name == key; });
        if (found == ranges.end() || found->second[0] <= 0) {
            table.refuse("logarithmic", fmt::format("'{}' is no range of positive numbers", key));
        }
    }
    if (ranges.empty()) {
        throw InputError(table.position(), "[[sobol]] has no range; write key = [least, greatest]");
    }
    boost::random::sobol sequence(ranges.size());
    sequence.discard(ranges.size());  // skips the point at which all values are smallest
    const double scale = std::ldexp(1.0, -64);
    std::vector<Point> points(wanted);
    for (Point& point : points) {
        for (const auto& [parameter, range] : ranges) {
            const double at = static_cast<double>(sequence()) * scale;
            const bool log = std::ranges::find(logarithmic, parameter->name) != logarithmic.end();
            const double value = log ? range[0] * std::pow(range[1] / range[0], at)
                                     : range[0] + at * (range[1] - range[0]);
            point.emplace_back(parameter, parse_number(fmt::format("{:.4g}", value)).value());
        }
        for (const auto& [parameter, number] : fixed) {
            point.emplace_back(parameter, number.front());
        }
    }
    return points;
}

/// Run at a point; what the point does not state is that of the fidelity.
dem::RunParameters run_at(const Point& point, const Fidelity& fidelity) {
    dem::RunResult run;
    run.parameters.inertial_number = fidelity.lowest_inertial_number;
    run.parameters.stiffness_number = fidelity.stiffness_number;
    run.parameters.grains = fidelity.grains;
    run.parameters.strain = fidelity.strain;
    for (const auto& [parameter, value] : point) {
        const bool whole = parameter->type == RunColumn::Type::integer;
        parameter->set(run, whole ? RunCell(std::int64_t{std::llround(value)}) : RunCell(value));
    }
    auto& effects = run.parameters.effects;
    std::erase_if(effects, [](const EffectValues& e) {
        return e.values == built_in_effect(e.effect).neutral();
    });
    std::ranges::sort(effects, {}, &EffectValues::effect);
    return run.parameters;
}

/// Returns the fingerprint of all parameters that determine a run except its seed.
std::uint64_t own_fingerprint(dem::RunParameters run) {
    run.seed = 0;
    return fingerprint(run_description(run));
}

class Reader {
  public:
    Reader(std::uint64_t seed, const Fidelity& fidelity) : seed_(seed), fidelity_(fidelity) {}

    void add(const StudyTable& table, const std::vector<Point>& points) {
        const std::size_t repeats = count(table, "repeats", 1, 1);
        for (const Point& point : points) {
            dem::RunParameters run = run_at(point, fidelity_);
            const std::uint64_t own = own_fingerprint(run);
            for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
                // 53 bits, which every program that reads the store can hold.
                run.seed = seed_of_run(seed_ ^ own, repeat) >> 11;
                add(table, run);
            }
        }
    }

    std::vector<dem::RunParameters> runs() && { return std::move(runs_); }

  private:
    void add(const StudyTable& table, const dem::RunParameters& run) {
        try {
            check_run(run);
        } catch (const std::invalid_argument& error) {
            throw InputError(
                table.position(),
                fmt::format("requests a simulation that is not possible: {}", error.what()));
        }
        if (there_.insert(run_description(run)).second) {
            runs_.push_back(run);
        }
        if (runs_.size() > most_runs) {
            throw InputError(table.position(), fmt::format("more than {} simulations", most_runs));
        }
    }

    std::uint64_t seed_;
    Fidelity fidelity_;
    std::vector<dem::RunParameters> runs_;
    std::set<std::string> there_;
};

}  // namespace

std::vector<dem::RunParameters> read_campaign(const std::filesystem::path& file,
                                              const Fidelity& fidelity) {
    const StudyTable root = StudyTable::read(file, {"seed", "grid", "list", "sobol"});
    Reader reader(count(root, "seed", 1, 0), fidelity);
    for (const StudyTable& table : root.tables("grid", keys_and({"repeats"}))) {
        reader.add(table, grid_points(table));
    }
    for (const StudyTable& table : root.tables("list", keys_and({"repeats"}))) {
        reader.add(table, list_points(table));
    }
    for (const StudyTable& table :
         root.tables("sobol", keys_and({"repeats", "points", "logarithmic"}))) {
        reader.add(table, sobol_points(table));
    }
    auto runs = std::move(reader).runs();
    if (runs.empty()) {
        throw InputError(root.position(),
                         "requests no simulation; add [[grid]], [[list]] or [[sobol]] ('pendular "
                         "campaign --help')");
    }
    return runs;
}

std::vector<dem::RunParameters> share_of(const std::vector<dem::RunParameters>& runs, int share,
                                         int shares) {
    const auto order = longest_first(runs);
    std::vector<dem::RunParameters> mine;
    for (std::size_t turn = static_cast<std::size_t>(share) - 1; turn < order.size();
         turn += static_cast<std::size_t>(shares)) {
        mine.push_back(runs[order[turn]]);
    }
    return mine;
}

}  // namespace pendular
