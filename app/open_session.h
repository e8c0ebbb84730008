#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/options.h"
#include "app/terminal.h"
#include "data/files/file_access.h"
#include "sim/runs/store/run_store.h"
#include "workflow/session.h"

namespace pendular::app {

/// Lock of a study, which each command that changes the study takes first, so that these commands
/// run one after the other. A study in a folder without write permission is not locked, since no
/// command can change it.
class StudyLock {
  public:
    /// Locks a study. If another process has the lock, prints a line that names this process and
    /// waits for at most a minute or $PENDULAR_LOCK_SECONDS [s].
    /// @param folder folder of the study
    /// @throws dem::Interrupted if a stop is requested while waiting
    /// @throws std::runtime_error if another process keeps the lock for longer than the waiting
    ///         time
    StudyLock(const std::filesystem::path& folder, const std::stop_token& stop);

  private:
    std::optional<FileLock> lock_;
};

/// Returns the paths to which a command writes: the results folder, `files` in it, and the file of
/// --json.
OutputPlaces places_of(const CommonOptions& options, std::vector<std::filesystem::path> files);

/// Sets in `fit` whether new simulations at the fitted parameters check a fit, and for how long.
/// @param seconds longest computing time of these simulations [s]; infinity: no limit; empty: no
///        simulation checks the fit
void set_confirmation(const std::optional<double>& seconds, FitOptions& fit);

/// Session in which one command works on a study, with the user's store. Progress appears on the
/// console, or is passed to a callback. Ctrl-C, or a stop request, ends long computations without
/// half-written files.
class OpenSession {
  public:
    enum class Access { reads, changes };
    /// Reads the study `options.study`, and opens the store.
    /// @param files paths in the results folder that the command writes to
    /// @param seed seed of all random numbers, 0 or more
    /// @param access whether the command changes the study or its fit; a command with `changes`
    ///        waits until no other command is changing the study
    /// @throws InputError for a mistake in the study's files, a negative seed or an unreadable
    ///         store, or if a result would replace a file that the study reads
    /// @throws std::runtime_error if a store that the user named cannot be written, or if the wait
    ///         takes longer than a minute or $PENDULAR_LOCK_SECONDS [s]
    /// @throws dem::Interrupted if the user stops the command while it waits
    OpenSession(Console& console, const CommonOptions& options,
                std::vector<std::filesystem::path> files, std::int64_t seed = 1,
                Access access = Access::reads);
    /// Opens a session without a console, such as for `pendular serve`; else as above.
    /// @param stop long computations end if a stop is requested through the token
    /// @param listener callback for notes and progress; may be empty
    OpenSession(const std::stop_token& stop, const Listener& listener, const CommonOptions& options,
                std::vector<std::filesystem::path> files, std::int64_t seed = 1,
                Access access = Access::reads);
    OpenSession(const OpenSession&) = delete;
    OpenSession& operator=(const OpenSession&) = delete;

    const Session* operator->() const { return &session_; }
    const Session& operator*() const { return session_; }
    Session& operator*() { return session_; }

  private:
    /// For the public constructors.
    /// @param guard null: only `stop` ends computations
    OpenSession(std::unique_ptr<InterruptGuard> guard, const std::stop_token& stop,
                const Listener& listener, const CommonOptions& options,
                std::vector<std::filesystem::path> files, std::int64_t seed, Access access);

    std::unique_ptr<InterruptGuard> guard_;
    std::unique_ptr<StudyLock> lock_;
    StudyInput input_;  ///< until `session_` takes it over
    std::unique_ptr<RunStore> store_;
    Session session_;
};

/// Returns the names of files and folders that `pendular add` and `pendular drop` write to the
/// results folder.
std::vector<std::filesystem::path> outputs_of_change();

/// Calls `Session::add`, with the rivals of the effect in diagnosis.json of the results folder, or
/// `Session::drop`, and passes on their exceptions.
ChangedStudy change_effects(Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity);

}  // namespace pendular::app
