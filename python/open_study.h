#pragma once

#include <unistd.h>
#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "workflow/session.h"

namespace pendular::python {

/// How to work on a study: as in `SessionOptions`, and where results go.
struct StudySettings {
    Fidelity fidelity;
    bool fidelity_given = false;  ///< false: a change keeps that of the fit in the results folder
    std::uint64_t seed = 1;
    int threads = 1;
    std::shared_ptr<RunStore> store;  ///< null: no store
    std::filesystem::path folder;     ///< for results; empty: STUDY/out
    /// Effects by functions of Python, which the model lists after those of study.toml.
    std::vector<Effect> effects = {};
};

/// Result of a fit: what `pendular calibrate --json` writes, and the covariances, which the JSON
/// has only in part. Values are shear stress [Pa] and solid fraction [1] of each reading in turn.
struct FitResult {
    nlohmann::ordered_json json;
    Eigen::MatrixXd measured_covariance, predicted_covariance;
    Eigen::MatrixXd normalised;  ///< residuals [1], a row for each reading
    std::vector<int> lines;      ///< of the file, at which each reading begins
    bool of_means = false;       ///< whether means of several readings were fitted (`most_fitted`)
};

/// Study that was read, with the settings for work on it. Each piece of work has a `Session` of its
/// own, so that several threads may work on one study and each may be stopped.
class OpenStudy {
  public:
    /// @throws InputError as `Session`
    OpenStudy(const std::filesystem::path& study, StudySettings settings);

    /// Sets the store, which keeps new runs and provides earlier ones; null: none.
    void use(std::shared_ptr<RunStore> store) { settings_.store = std::move(store); }
    const StudyInput& input() const { return input_; }
    const StudySettings& settings() const { return settings_; }
    const std::filesystem::path& folder() const { return settings_.folder; }
    /// Returns the store; null: none. A connection to SQLite serves only the process that opened
    /// it.
    /// @throws InputError in a process that was forked from the one that opened the study
    RunStore* store() const;

    FitResult calibrate(const FitOptions& fit, const std::stop_token& stop,
                        const Listener& listener) const;
    /// Result of the comparison, as `pendular compare --json` writes it, with the fit.
    std::pair<nlohmann::ordered_json, FitResult> compare(const std::stop_token& stop,
                                                         const Listener& listener) const;
    Prediction predict(const std::vector<Condition>& conditions, const std::stop_token& stop,
                       const Listener& listener) const;
    nlohmann::ordered_json diagnose(std::optional<double> confirming_seconds,
                                    const std::stop_token& stop, const Listener& listener);
    nlohmann::ordered_json next(const std::stop_token& stop, const Listener& listener);
    nlohmann::ordered_json change(Action action, const std::string& effect, const FitOptions& fit,
                                  const std::stop_token& stop, const Listener& listener) const;

  private:
    Session session(const std::stop_token& stop, const Listener& listener) const;
    StudyDiagnosis diagnosis(std::optional<double> confirming_seconds, const Session& session);

    FitResult result_of(const FittedStudy& fitted) const;

    StudySettings settings_;
    StudyInput input_;
    pid_t process_ = getpid();  ///< which opened the study
    mutable std::mutex mutex_;
    /// Sets of effects that explain the readings, by the last diagnosis; empty: none was made.
    std::optional<EffectNames> explaining_;
};

}  // namespace pendular::python
