#include "calib/model/fresh_runs.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <set>

#include "calib/emulator/emulated_observables.h"
#include "calib/model/study_state.h"
#include "data/quantities/statistics.h"
#include "sim/runs/run_request.h"
#include "sim/runs/run_settings.h"

namespace pendular {
namespace {

using dem::Observable;

std::string describe(const FlowState& state) {
    std::string text = fmt::format("friction {:.3g}, inertial number {:.3g}", state.friction,
                                   state.inertial_number);
    if (!state.dry()) {
        text += fmt::format(", reduced pressure {:.3g}, bridge volume {:.3g} a^3",
                            1 / state.inverse_pressure, state.bridge_volume);
    }
    return text;
}

}  // namespace

std::vector<dem::RunParameters> FreshSeeds::runs_at(const std::vector<FlowState>& states,
                                                    const Study& study, const Fidelity& fidelity,
                                                    const std::vector<dem::RunResult>& known) {
    std::set<std::string> descriptions;
    for (const dem::RunResult& run : known) {
        descriptions.insert(run_description(run.parameters));
    }
    std::vector<dem::RunParameters> wanted;
    for (const FlowState& state : states) {
        dem::RunParameters run = run_at(state, study, fidelity);
        do {
            run.seed = seed_of_run(seed_, next_++);
        } while (descriptions.contains(run_description(run)));
        wanted.push_back(run);
    }
    return wanted;
}

std::vector<dem::RunResult> usable_of(const std::vector<dem::RunResult>& runs,
                                      std::vector<std::string>& notes) {
    std::vector<dem::RunResult> usable;
    for (const dem::RunResult& run : runs) {
        if (emulated::usable(run)) {
            usable.push_back(run);
        } else {
            notes.push_back(fmt::format("a simulation at {} is not used: it {}",
                                        describe(emulated::flow_state_of(run.parameters)),
                                        emulated::why_unusable(run)));
        }
    }
    return usable;
}

double agreement(const Emulator& emulator, const std::vector<dem::RunResult>& fresh) {
    if (fresh.empty()) {
        return 1;
    }
    std::vector<FlowState> places;
    for (const dem::RunResult& run : fresh) {
        places.push_back(emulated::flow_state_of(run.parameters));
    }
    const auto queries = emulated::pairs_at(places);
    Eigen::VectorXd off = -emulator.mean(queries);
    Eigen::MatrixXd covariance = emulator.covariance(queries);
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const auto at = 2 * static_cast<Eigen::Index>(k);
        off(at) += emulated::training_value(fresh[k], Observable::stress_ratio).value;
        off(at + 1) += emulated::training_value(fresh[k], Observable::solid_fraction).value;
        covariance.block<2, 2>(at, at) += emulator.noise(fresh[k]);
    }
    const double chi2 = off.dot(covariance.llt().solve(off));
    return chi_squared_tail(chi2, static_cast<double>(off.size()));
}

}  // namespace pendular
