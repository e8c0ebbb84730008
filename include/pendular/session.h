#pragma once

/// @file
/// Public C++ interface of Pendular: from the recordings of an annular rheometer to stresses, a
/// calibrated friction and the physical effect that a model lacks. The header includes the standard
/// library only.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

/// Version 1 of the public interface.
namespace pendular::v1 {

/// Fitted parameter of a model, with its standard error and unit.
struct Estimate {
    std::string name;  ///< name of the parameter, such as "friction" or "torque-offset.torque"
    std::string unit;  ///< SI unit of `value` and `standard_error`; "1": dimensionless
    double value = 0;  ///< fitted value [unit]
    /// Standard error of `value`, from errors of measurement and simulation together [unit].
    double standard_error = 0;
};

/// Shear stress and solid fraction of one steady state, as measured and as a fitted model predicts
/// them.
struct Reading {
    std::string file;               ///< file of the recording or table that the reading comes from
    std::size_t step = 0;           ///< step of the recording, counted from 1; 0: a row of a table
    double normal_stress = 0;       ///< normal stress on the sample [Pa]
    double inertial_number = 0;     ///< inertial number I, the reduced shear rate [1]
    double liquid_content = 0;      ///< liquid volume over solid volume [1]; 0: dry
    double shear_stress = 0;        ///< measured shear stress [Pa]
    double shear_stress_error = 0;  ///< standard error of the measured shear stress [Pa]
    double solid_fraction = 0;      ///< measured solid fraction [1]
    double solid_fraction_error = 0;      ///< standard error of the measured solid fraction [1]
    double predicted_shear_stress = 0;    ///< shear stress by the fitted model [Pa]; 0: no fit
    double predicted_solid_fraction = 0;  ///< solid fraction by the fitted model [1]; 0: no fit
    bool fitted = false;  ///< true: the parameters were fitted to the reading; false: not fitted
};

/// Fit of a study's model to the study's readings.
struct Fit {
    std::vector<Estimate> parameters;  ///< fitted parameters, the intergranular friction first
    /// Misfit of all readings, fitted and predicted, and of direct measurements of parameters [1].
    double chi2 = 0;
    int degrees_of_freedom = 0;  ///< degrees of freedom of `chi2`
    bool converged = false;      ///< whether the search for the best parameters converged
    /// Reasons not to believe the fit as sentences, the most serious first; empty: none was found.
    std::vector<std::string> doubts;
    std::vector<Reading> readings;  ///< all readings of the study with their predictions
};

/// Result of a diagnosis: whether a physical effect is missing from a study's model, and which.
struct Verdict {
    /// Result in one word:
    /// - "nothing-missing": the model explains the readings; any effect that can show in them would
    ///   have shown if it were large enough to matter;
    /// - "inconclusive": the model explains the readings, but effects could be present unseen;
    /// - "missing": the model lacks the effects in `effects`;
    /// - "indistinguishable": several effects explain the readings equally well;
    /// - "unknown": something is missing that no known effect explains;
    /// - "suspect-measurement": an error of measurement would explain the misfit.
    std::string verdict;
    /// Names of effects. "missing": all of them are missing; "indistinguishable": alternatives that
    /// explain the readings equally well; "inconclusive": effects that could be large enough to
    /// matter without showing in these readings. Empty for other verdicts.
    std::vector<std::string> effects;
    /// Whether the readings are explained; false where neither the study's model nor any model with
    /// further effects fits them.
    bool complete = true;
    /// Measurements whose error would explain the readings too, as in "the readings of dry_1.csv".
    std::vector<std::string> suspects;
    /// Misfit chi2 of the study's model as it is, without further effects [1].
    double chi2 = 0;
    int degrees_of_freedom = 0;  ///< degrees of freedom of `chi2`
    /// Reasons not to believe the fit of the study's model, as sentences, the most serious first;
    /// empty: none was found.
    std::vector<std::string> doubts;
};

/// Fits of a study before and after an effect was added to its model or dropped from it.
struct Change {
    /// Fit of the model before the change. Its `doubts` are not determined and therefore empty.
    Fit before;
    Fit after;             ///< fit of the model after the change
    bool written = false;  ///< whether study.toml was changed: only where the new fit converged
};

/// Exception for a mistake in a file, key, value or option that the user gave. The text names the
/// mistake and what to do; for a mistake in a file, it begins with file:line:column.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Exception for long work that a request by `Options::stop` ended early. The text says how to
/// continue the work.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Settings of the rheometer for one reading, a pair of shear stress and solid fraction.
struct SetPoint {
    double normal_stress = 0;    ///< normal stress on the sample [Pa]
    double inertial_number = 0;  ///< inertial number I [1]; 0: the quasi-static limit
    double liquid_content = 0;   ///< liquid volume over solid volume [1]; 0: dry
};

/// Reading that a fitted model predicts at one set point, as the instrument would show it.
struct Prediction {
    SetPoint at;                      ///< set point of the predicted reading
    double shear_stress = 0;          ///< predicted shear stress [Pa]
    double shear_stress_error = 0;    ///< standard error of the predicted shear stress [Pa]
    double solid_fraction = 0;        ///< predicted solid fraction [1]
    double solid_fraction_error = 0;  ///< standard error of the predicted solid fraction [1]
};

/// One suggested measurement: readings at a set point, or direct measurements of a parameter
/// without shearing the sample.
struct NextReading {
    SetPoint at;  ///< set point at which to shear the sample
    /// Parameter to measure directly, as in "torque-offset.torque"; empty: shear the sample at
    /// `at`.
    std::string direct;
    int repeats = 1;  ///< number of readings, or of direct measurements, to take
};

/// Suggested next measurements. They tell apart the models that fit the readings or, if only one
/// model fits, make its parameters more precise.
struct Suggestion {
    /// Models between which the measurements should decide; a single one: there is nothing to tell
    /// apart.
    std::vector<std::string> rivals;
    /// Measurements to take; empty: the instrument cannot tell any of the `rivals` apart.
    std::vector<NextReading> readings;
};

/// Options of a session: simulations, files and progress messages.
struct Options {
    std::string fidelity = "standard";  ///< size of simulations: "quick", "standard", "paper"
    std::uint64_t seed = 1;             ///< seed of all random numbers
    int threads = 1;                    ///< number of simulations or refits at a time
    std::filesystem::path store;        ///< SQLite file that keeps simulation runs; empty: none
    std::filesystem::path results;      ///< folder for fit.json and other results; empty: STUDY/out
    bool confirm = false;               ///< confirm each fit by new simulations at the optimum
    std::stop_token stop = {};          ///< a request ends long work early, with `Interrupted`
    /// Function called with one line of text for each progress message; empty: no calls.
    std::function<void(const std::string&)> listener = {};
};

/// Session on a study: reads the study's files once, then fits, compares, predicts, diagnoses and
/// plans measurements. Nothing is printed.
class Session {
  public:
    /// Reads a study and all its recordings.
    /// @param study folder of the study, or its study.toml
    /// @param options settings of this session, such as the folder for results
    /// @throws InputError for a mistake in a file of the study or in the options, and where results
    ///         would replace a file of the study
    explicit Session(const std::filesystem::path& study, Options options = {});
    ~Session();
    /// Moves a session, which is then empty. Sessions cannot be copied.
    Session(Session&&) noexcept;
    /// Moves a session into this one and ends the session that this one was.
    Session& operator=(Session&&) noexcept;

    /// Returns the measured readings of the study, dry readings first. Their predicted values are
    /// 0.
    std::vector<Reading> readings() const;

    /// Fits the parameters of the study's model, the intergranular friction among them, to the
    /// readings. Predictions come from an emulator, which interpolates between simulation runs.
    /// Writes fit.json and fit_runs.csv to the folder for results (`Options::results`).
    /// @throws InputError where there is nothing to fit or a reading cannot be simulated
    /// @throws Interrupted where `Options::stop` ended the work
    /// @throws std::runtime_error where a file cannot be written
    Fit calibrate() const;

    /// Reads fit.json from the folder for results, and compares this fit with the study's readings.
    /// @throws InputError where there is no readable fit.json, and where the study has changed
    ///         since the fit
    Fit compare() const;

    /// Predicts the reading that the instrument would show at each set point, by the fit in
    /// fit.json of the folder for results. Returns one prediction per set point, in the order of
    /// `at`.
    /// @throws InputError where there is no readable fit.json, where the study has changed since
    ///         the fit, and where a set point cannot be simulated
    std::vector<Prediction> predict(const std::vector<SetPoint>& at) const;

    /// Tests which physical effect, if any, is missing from the study's model. Nothing is
    /// simulated.
    /// @throws InputError where the study has too few readings, where there are too few earlier
    ///         simulation runs (those that come with Pendular and those in `Options::store`), where
    ///         a reading is outside the range that can be simulated, and where ladder.json in the
    ///         folder for results cannot be read
    /// @throws Interrupted where `Options::stop` ended the work
    Verdict diagnose() const;

    /// Diagnoses the study and plans its next measurement. The instrument's possible settings are
    /// those of section [rig] of study.toml or, without this section, the range of the readings.
    /// @throws InputError where the study cannot be diagnosed, as by `diagnose`, and where none of
    ///         the settings is near an earlier simulation run (those that come with Pendular and
    ///         those in `Options::store`)
    /// @throws Interrupted where `Options::stop` ended the work
    Suggestion next() const;

    /// Fits the study's model without and with a further physical effect and, where the fit
    /// converges, adds the effect to study.toml. This session keeps the study without the effect:
    /// open another session to go on.
    /// @param effect name of the effect, as in "torque-offset"
    /// @throws InputError for an effect that is unknown, that the model contains already or that
    ///         does not apply to the study, where a fit is impossible, and where study.toml has
    ///         changed since it was read
    /// @throws Interrupted where `Options::stop` ended the work
    /// @throws std::runtime_error where a file cannot be written
    Change add(const std::string& effect) const;
    /// Fits the study's model with and without one of the effects that study.toml lists and, where
    /// the fit converges, removes the effect from study.toml. This session keeps the study with the
    /// effect: open another session to go on.
    /// @param effect name of the effect, as in "torque-offset"
    /// @throws InputError for an effect that the study does not list, where a fit is impossible,
    ///         and where study.toml has changed since it was read
    /// @throws Interrupted where `Options::stop` ended the work
    /// @throws std::runtime_error where a file cannot be written
    Change drop(const std::string& effect) const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::v1
