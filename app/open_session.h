#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/console.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "sim/runs/store/run_store.h"
#include "workflow/session.h"

namespace pendular::app {

/// Where a command writes; `files` are relative to its folder for results.
OutputPlaces places_of(const CommonOptions& options, std::vector<std::filesystem::path> files);

/// The session of a command: its study, the store of runs, progress on the console, and Ctrl-C,
/// which ends long work at a clean point.
class OpenSession {
  public:
    /// `files` are what the command writes.
    /// @throws InputError as Session, and for a store that cannot be read
    OpenSession(Console& console, const CommonOptions& options,
                std::vector<std::filesystem::path> files, std::int64_t seed = 1);
    OpenSession(const OpenSession&) = delete;
    OpenSession& operator=(const OpenSession&) = delete;

    const Session* operator->() const { return &session_; }

  private:
    OpenSession(Console& console, const CommonOptions& options, StudyInput input,
                std::uint64_t seed);

    InterruptGuard guard_;
    std::unique_ptr<RunStore> store_;
    Session session_;
};

}  // namespace pendular::app
