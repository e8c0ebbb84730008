#include "calib/model/run_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <stop_token>
#include <thread>

#include "data/input_error.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/store/run_store.h"

namespace pendular {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration duration_of(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Timer that requests a stop at a point in time, unless it is destroyed before.
class Alarm {
  public:
    Alarm(Clock::time_point at, std::stop_source& stop)
        : waiting_([this, at, &stop](const std::stop_token& ended) {
              std::unique_lock lock(mutex_);
              never_.wait_until(lock, ended, at, [] { return false; });
              if (!ended.stop_requested()) stop.request_stop();
          }) {}

  private:
    std::mutex mutex_;
    std::condition_variable_any never_;
    std::jthread waiting_;  ///< last member: the thread ends before the other members are destroyed
};

std::vector<dem::RunResult> stored(const std::vector<dem::RunParameters>& runs,
                                   const RunStore* store) {
    std::vector<dem::RunResult> found;
    for (const dem::RunParameters& run : runs) {
        if (auto result = store ? store->find(run) : std::nullopt) {
            found.push_back(std::move(*result));
        }
    }
    return found;
}

}  // namespace

RunBudget::RunBudget(double seconds) {
    // Beyond decades, the clock would overflow.
    constexpr double endless = 1e9;
    if (!(seconds >= 0)) {
        throw InputError(
            fmt::format("time for simulations {} s: a number of 0 or more is needed", seconds));
    }
    if (seconds < endless) end_ = Clock::now() + duration_of(seconds);
}

double RunBudget::seconds_left() const {
    return end_ ? std::max(0.0, std::chrono::duration<double>(*end_ - Clock::now()).count())
                : std::numeric_limits<double>::infinity();
}

std::size_t RunBudget::affordable(const std::vector<dem::RunParameters>& runs,
                                  const std::vector<dem::RunResult>& measured, int threads,
                                  double reserved) const {
    if (!limited()) {
        return runs.size();
    }
    const double left = seconds_left() - reserved;
    std::vector<dem::RunParameters> first;
    for (const dem::RunParameters& run : runs) {
        first.push_back(run);
        if (expected_seconds(first, measured, threads).value_or(0) >= left) {
            return first.size() - 1;
        }
    }
    return runs.size();
}

std::size_t RunBudget::batch(const std::vector<dem::RunParameters>& runs,
                             const std::vector<dem::RunResult>& measured, int threads,
                             double reserved) const {
    const double others = 2.0 / 3 * std::max(0.0, seconds_left() - reserved);
    const std::size_t third = affordable(runs, measured, threads, reserved + others),
                      most = affordable(runs, measured, threads, reserved);
    return std::min(most, std::max(third, static_cast<std::size_t>(threads)));
}

std::vector<dem::RunResult> RunBudget::run(const std::vector<dem::RunParameters>& runs,
                                           const Workers& workers, double reserved) const {
    if (!limited()) {
        return run_all(runs, workers);
    }
    std::stop_source stop;
    const std::stop_callback forward(workers.stop, [&] { stop.request_stop(); });
    const Alarm alarm(*end_ - duration_of(reserved), stop);
    Workers limited = workers;
    limited.stop = stop.get_token();
    try {
        return run_all(runs, limited);
    } catch (const dem::Interrupted&) {
        if (workers.stop.stop_requested()) {
            throw;
        }
        return stored(runs, workers.store);
    }
}

}  // namespace pendular
