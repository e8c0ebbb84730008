#include "workflow/reproduction.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "data/input_error.h"
#include "sim/runs/store/run_table.h"
#include "workflow/requested_state.h"
#include "workflow/study_input.h"

namespace pendular {
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

}  // namespace pendular
