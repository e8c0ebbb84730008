#include "analysis/diagnosis/side_by_side.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <vector>

namespace pendular {
namespace {

/// Number of pieces of work for each of which one more thread is started; with 3, one thread
/// would make five fits alone.
constexpr std::size_t worth_another_thread = 2;

}  // namespace

void side_by_side(std::size_t count, std::size_t threads,
                  const std::function<void(std::size_t)>& before_each,
                  const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    const auto take_turns = [&](const std::function<void(std::size_t)>& before) {
        for (std::size_t k = next++; k < count; k = next++) {
            if (before) before(k);
            work(k);
        }
    };
    std::vector<std::future<void>> helpers;
    for (std::size_t thread = 1; thread < std::min(threads, count / worth_another_thread);
         ++thread) {
        helpers.push_back(std::async(std::launch::async, take_turns, nullptr));
    }
    try {
        take_turns(before_each);
    } catch (...) {
        next = count;  // the other threads end soon, and are waited for
        throw;
    }
    for (auto& helper : helpers) {
        helper.get();
    }
}

}  // namespace pendular
