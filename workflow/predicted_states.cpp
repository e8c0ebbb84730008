#include "workflow/predicted_states.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "analysis/diagnosis/side_by_side.h"
#include "calib/emulator/emulated_observables.h"
#include "sim/dem/simulation_error.h"

namespace pendular {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Number of states that a thread predicts at a time. Chosen: some milliseconds, so that Ctrl-C
/// ends the work at once, and enough columns for products of matrices.
constexpr std::size_t states_at_a_time = 32;

/// Predictions of states, filled by several threads.
class States {
  public:
    States(const StatePredictor& predictor, const std::vector<RequestedState>& requested,
           bool slopes)
        : predictor_(predictor), requested_(requested) {
        const auto states = static_cast<Eigen::Index>(requested.size());
        result_.observables = emulated::observables();
        const auto observables = std::ssize(result_.observables);
        const Eigen::MatrixXd empty = Eigen::MatrixXd::Constant(states, observables, none);
        result_.value = result_.standard_error = empty;
        if (slopes) result_.slopes.assign(4, empty);
        result_.bridge_volume = Eigen::VectorXd::Constant(states, none);
        result_.why_not.resize(requested.size());
    }

    /// Predicts the states from `begin` to `end` - 1.
    void predict(std::size_t begin, std::size_t end) {
        std::vector<std::size_t> places;
        std::vector<FlowState> asked;
        for (std::size_t k = begin; k < end; ++k) {
            result_.why_not[k] = requested_[k].why_wrong();
            if (!result_.why_not[k].empty()) continue;
            places.push_back(k);
            asked.push_back(predictor_.state_of(requested_[k]));
        }
        const std::vector<std::string> why_not = predictor_.why_unsupported(asked);
        std::vector<Eigen::Index> rows;
        std::vector<FlowState> states;
        for (std::size_t k = 0; k < asked.size(); ++k) {
            result_.why_not[places[k]] = why_not[k];
            if (!why_not[k].empty()) continue;
            rows.push_back(static_cast<Eigen::Index>(places[k]));
            states.push_back(asked[k]);
            if (!asked[k].dry()) result_.bridge_volume(rows.back()) = asked[k].bridge_volume;
        }
        if (states.empty()) return;
        const auto found = emulated_at(predictor_.emulator(), states, predictor_.stiffness_number(),
                                       result_.observables, !result_.slopes.empty());
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (const EmulatedObservable& one : found[k])
                put(rows[k], one);
    }

    PredictedStates taken() && { return std::move(result_); }

  private:
    void put(Eigen::Index row, const EmulatedObservable& one) {
        const auto column =
            std::ranges::find(result_.observables, one.which) - result_.observables.begin();
        result_.value(row, column) = one.value.value;
        result_.standard_error(row, column) = one.value.standard_error;
        for (std::size_t k = 0; k < std::min(one.slopes.size(), result_.slopes.size()); ++k)
            result_.slopes[k](row, column) = one.slopes[k].value;
    }

    const StatePredictor& predictor_;
    const std::vector<RequestedState>& requested_;
    PredictedStates result_;
};

}  // namespace

PredictedStates predict_states(const StatePredictor& predictor,
                               const std::vector<RequestedState>& requested,
                               const StatesRequest& request) {
    for (const RequestedState& each : requested)
        static_cast<void>(each.why_wrong());  // throws before any work
    States states(predictor, requested, request.slopes);
    const std::size_t count = requested.size();
    std::atomic<std::size_t> done = 0;
    const auto before_each = [&](std::size_t) {
        if (request.stop.stop_requested()) throw dem::Interrupted();
        if (request.report) request.report(done);
    };
    side_by_side((count + states_at_a_time - 1) / states_at_a_time, request.threads, before_each,
                 [&](std::size_t part) {
                     if (request.stop.stop_requested()) return;
                     const std::size_t begin = part * states_at_a_time;
                     const std::size_t end = std::min(begin + states_at_a_time, count);
                     states.predict(begin, end);
                     done += end - begin;
                 });
    if (request.stop.stop_requested()) throw dem::Interrupted();
    return std::move(states).taken();
}

}  // namespace pendular
