#include "workflow/reproduction.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "data/input_error.h"
#include "sim/runs/store/run_table.h"
#include "workflow/fit_runs.h"
#include "workflow/known_runs.h"
#include "workflow/requested_state.h"

namespace pendular {
namespace {

/// JSON of a number that may be infinite: null in JSON.
nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

Reproduction::Reproduction(const Fidelity& fidelity, const RunStore* store) : fidelity_(fidelity) {
    auto known = known_runs(Study{}, fidelity, store);
    if (!known) {
        throw InputError(
            "there are too few simulations; name an atlas in PENDULAR_ATLAS, or simulate with "
            "'pendular campaign'");
    }
    emulator_ = std::make_unique<Emulator>(known->runs, std::move(known->hyperparameters));
    study_ = std::make_unique<PaperStudy>(known->runs, *emulator_);
    rows_ = compare_with_published(*study_);
}

std::size_t Reproduction::agreeing() const {
    return static_cast<std::size_t>(std::ranges::count_if(rows_, &ScoreboardRow::agrees));
}

std::vector<dem::RunParameters> Reproduction::missing_runs() const {
    std::vector<dem::RunParameters> runs;
    for (const MissingState& state : study_->missing()) {
        runs.push_back(run_of({.friction = state.friction,
                               .inertial_number = grid_inertial_number,
                               .inverse_pressure = 1 / state.reduced_pressure,
                               .bridge_volume = state.bridge_volume},
                              fidelity_, fidelity_.stiffness_number));
    }
    return runs;
}

nlohmann::ordered_json to_json(const Reproduction& reproduction) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ScoreboardRow& row : reproduction.rows()) {
        rows.push_back({{"section", row.section},
                        {"what", row.what},
                        {"published", row.published},
                        {"published_range", {number(row.lower), number(row.upper)}},
                        {"ours", row.ours},
                        {"our_range", {row.least, row.greatest}},
                        {"distance", row.distance},
                        {"values", row.values},
                        {"outside", row.outside},
                        {"where", row.where},
                        {"agrees", row.agrees}});
    }
    return {{"rows", rows},
            {"agreeing", reproduction.agreeing()},
            {"runs", runs_json(reproduction.emulator().runs())},
            {"states", reproduction.study().states().size()},
            {"missing", reproduction.study().missing().size()}};
}

}  // namespace pendular
