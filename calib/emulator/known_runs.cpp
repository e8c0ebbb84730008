#include "calib/emulator/known_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "calib/emulator/emulated_observables.h"
#include "data/files/csv.h"
#include "data/files/write_whole.h"
#include "data/quantities/number.h"

namespace pendular {

EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file) {
    const Table table = read_table(file);
    if (table.header.cells.size() != Hyperparameters::count + 1) {
        throw InputError(table.at_header(0),
                         fmt::format("{} columns are needed, there are {}",
                                     Hyperparameters::count + 1, table.header.cells.size()));
    }
    EmulatorHyperparameters result;
    for (const Row& row : table.rows) {
        std::array<double, Hyperparameters::count> values{};
        for (std::size_t k = 0; k < Hyperparameters::count; ++k) {
            const auto number = parse_number(row.cells[k + 1].text);
            if (!number || *number < smallest_magnitude || *number > largest_magnitude) {
                throw InputError(table.at(row, k + 1),
                                 fmt::format("'{}' is no positive number of ordinary size",
                                             row.cells[k + 1].text));
            }
            values[k] = *number;
        }
        try {
            result[dem::observable_named(row.cells[0].text)] = Hyperparameters::from_array(values);
        } catch (const std::invalid_argument& error) {
            throw InputError(table.at(row, 0), error.what());
        }
    }
    return result;
}

void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters) {
    std::string text = "observable";
    for (const auto name : Hyperparameters::names) {
        text += fmt::format(",{}", name);
    }
    text += '\n';
    for (const auto& [which, each] : hyperparameters) {
        text += dem::observable_names[static_cast<std::size_t>(which)];
        for (const double value : each.as_array()) {
            text += fmt::format(",{:.6g}", value);
        }
        text += '\n';
    }
    write_whole(file, text);
}

std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs) {
    // Changes the ratio of tangential to normal stiffness by less than a tenth.
    constexpr double largest_poisson_difference = 0.1;
    // As many as all runs of the atlas have. Smaller samples feel their periodic images more.
    constexpr int enough_grains = 1000;
    std::vector<dem::RunResult> result;
    std::ranges::copy_if(runs, std::back_inserter(result), [&](const dem::RunResult& run) {
        const auto& p = run.parameters;
        return emulated::usable(run) && p.grains >= std::min(fidelity.grains, enough_grains) &&
               std::abs(p.poisson_ratio - study.grains.poisson_ratio) <=
                   largest_poisson_difference &&
               (!p.wetting || p.wetting->bridge_force == study.model.bridge_force) &&
               std::ranges::all_of(p.effects, [&](const EffectValues& effect) {
                   return std::ranges::find(study.model.effects, effect.effect,
                                            &ListedEffect::name) != study.model.effects.end();
               });
    });
    return result;
}

}  // namespace pendular
