#include "app/study_lock.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "app/terminal.h"
#include "data/quantities/number.h"
#include "sim/dem/run.h"

namespace pendular::app {
namespace {

using namespace std::chrono_literals;

/// Longest time to wait for another process.
std::chrono::duration<double> patience() {
    const char* const stated = std::getenv("PENDULAR_LOCK_SECONDS");
    return std::chrono::duration<double>(parse_number(stated ? stated : "").value_or(60));
}

}  // namespace

StudyLock::StudyLock(const std::filesystem::path& folder, const std::stop_token& stop) {
    if (access(folder.c_str(), W_OK) != 0) return;
    lock_.emplace(folder / ".study.toml.lock");
    const auto end = std::chrono::steady_clock::now() + patience();
    for (bool told = false; !lock_->take(); told = true) {
        if (std::chrono::steady_clock::now() > end) {
            throw std::runtime_error(fmt::format(
                "{} is held by {}, and nothing was changed: give the same command again "
                "once that one has ended",
                folder.string(), lock_->holder()));
        }
        if (!told) {
            print_line(stderr, fmt::format("Waiting for {}, which changes {}.", lock_->holder(),
                                           folder.string()));
        }
        if (stop.stop_requested()) throw dem::Interrupted();
        std::this_thread::sleep_for(50ms);
    }
}

}  // namespace pendular::app
