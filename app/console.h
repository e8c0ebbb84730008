#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/options.h"
#include "reports/with_error.h"
#include "sim/runs/ensemble.h"

namespace pendular::app {

/// Where a command's words go: the verdict and its evidence on standard output, or on standard
/// error where JSON takes standard output; progress on standard error unless --quiet.
class Console {
  public:
    explicit Console(const CommonOptions& options) : options_(options) {}
    /// Ends a progress line, so that what is said of an error begins a line of its own.
    ~Console() { end_progress(); }
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void line(const std::string& text);
    /// Something the user should know, marked as a note.
    void note(const std::string& text);
    /// Writes to what --json names, if given.
    void json(const nlohmann::ordered_json& json);

    /// A progress line with the time left; redrawn in place on a terminal, else every few seconds.
    void progress(const std::string& what, const EnsembleProgress& progress);
    void end_progress();

  private:
    const CommonOptions& options_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point last_{};
};

/// "1 min 20 s", "3 h 5 min".
std::string duration(double seconds);

}  // namespace pendular::app
