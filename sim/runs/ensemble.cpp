#include "sim/runs/ensemble.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <numeric>
#include <thread>

#include "sim/runs/run_checkpoints.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

double expected_cost(const dem::RunParameters& run) {
    // Steps per strain: 1/(I dt) with dt proportional to kappa^(-1/2); about 1.2 of strain is
    // transient.
    return run.grains * (run.strain + 1.2) / run.inertial_number * std::sqrt(run.stiffness_number);
}

std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads) {
    // Bridges and effects make a time step more expensive.
    const auto kind = [](const dem::RunParameters& p) {
        return std::pair(p.wetting.has_value(), !p.effects.empty());
    };
    std::map<std::pair<bool, bool>, std::vector<double>> seconds_per_cost;
    std::vector<double> of_all;
    for (const dem::RunResult& run : measured) {
        if (run.failure.empty() && run.wall_seconds > 0) {
            const double seconds = run.wall_seconds / expected_cost(run.parameters);
            seconds_per_cost[kind(run.parameters)].push_back(seconds);
            of_all.push_back(seconds);
        }
    }
    if (of_all.empty()) {
        return std::nullopt;
    }
    const auto middle = [](std::vector<double>& values) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, place);
        return *place;
    };
    double total = 0, longest = 0;
    for (const dem::RunParameters& run : runs) {
        const auto same = seconds_per_cost.find(kind(run));
        const double seconds =
            expected_cost(run) * middle(same == seconds_per_cost.end() ? of_all : same->second);
        total += seconds;
        longest = std::max(longest, seconds);
    }
    return std::max(total / threads, longest);
}

std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs) {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{},
                             [&](std::size_t k) { return expected_cost(runs[k]); });
    return order;
}

namespace {

/// Work shared by the threads of one ensemble.
class Ensemble {
  public:
    Ensemble(const std::vector<dem::RunParameters>& runs, const Workers& workers)
        : runs_(runs),
          workers_(workers),
          results_(runs.size()),
          done_(runs.size(), 0.0),
          order_(longest_first(runs)),
          checkpoints_(workers.store ? workers.store->file() : std::filesystem::path()) {
        if (workers_.store && workers_.reads_store) {
            take_stored();
        }
        for (const std::size_t k : order_) {
            total_ += expected_cost(runs_[k]);
        }
    }

    std::vector<dem::RunResult> run_all_members() {
        {
            const std::stop_callback forward(workers_.stop, [this] { stop_.request_stop(); });
            std::vector<std::jthread> threads;
            const auto count = std::min<std::size_t>(std::max(1, workers_.threads), order_.size());
            for (std::size_t k = 0; k < count; ++k) {
                threads.emplace_back([this] { work(); });
            }
        }
        if (failure_) {
            std::rethrow_exception(failure_);
        }
        if (stop_.stop_requested()) {
            throw dem::Interrupted();
        }
        return std::move(results_);
    }

  private:
    /// Reads the runs that the store has, so that only the remaining runs are carried out.
    void take_stored() {
        std::erase_if(order_, [&](std::size_t k) {
            auto stored = workers_.store->find(runs_[k]);
            if (stored) {
                results_[k] = std::move(*stored);
                done_[k] = 1;
            }
            return stored.has_value();
        });
    }

    void work() {
        for (;;) {
            const std::size_t turn = next_.fetch_add(1);
            if (turn >= order_.size() || stop_.stop_requested()) {
                return;
            }
            const std::size_t k = order_[turn];
            try {
                results_[k] =
                    checkpoints_.simulated(runs_[k],
                                           {.stop = stop_.get_token(),
                                            .progress =
                                                [&](double strain, double expected) {
                                                    note(k, std::min(0.999, strain / expected));
                                                }},
                                           [&](const dem::RunResult& run) {
                                               if (workers_.store) workers_.store->add(run);
                                           });
                if (workers_.store) {
                    results_[k].trace.clear();
                    results_[k].final_state = {};
                }
                note(k, 1.0);
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!failure_) {
                    failure_ = std::current_exception();
                }
                stop_.request_stop();
            }
        }
    }

    void note(std::size_t k, double fraction) {
        const std::lock_guard lock(mutex_);
        // A run may find that it needs more strain; the reported progress never decreases.
        done_[k] = std::max(done_[k], fraction);
        if (!workers_.report) {
            return;
        }
        EnsembleProgress progress{.runs = runs_.size()};
        double cost = 0;
        progress.runs_done = runs_.size() - order_.size();
        for (const std::size_t run : order_) {
            cost += done_[run] * expected_cost(runs_[run]);
            progress.runs_done += done_[run] >= 1;
        }
        progress.fraction = cost / total_;
        const double spent =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
        if (progress.fraction > 0.01) {  // earlier, the time left would be a guess
            progress.seconds_left = spent * (1 / progress.fraction - 1);
        }
        workers_.report(progress);
    }

    const std::vector<dem::RunParameters>& runs_;
    const Workers& workers_;
    std::vector<dem::RunResult> results_;
    std::vector<double> done_;
    std::vector<std::size_t> order_;
    const RunCheckpoints checkpoints_;
    double total_ = 0;
    std::atomic<std::size_t> next_{0};
    std::stop_source stop_;
    std::mutex mutex_;
    std::exception_ptr failure_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace

std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers) {
    return runs.empty() ? std::vector<dem::RunResult>{} : Ensemble(runs, workers).run_all_members();
}

}  // namespace pendular
