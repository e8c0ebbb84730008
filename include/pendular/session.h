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
    double standard_error = 0;  ///< from errors of measurement and simulation together [unit]
};

/// Shear stress and solid fraction of one state of the sample (steady shear or point of failure),
/// as measured and as a fitted model predicts them.
struct Reading {
    std::string file;          ///< file of the recording or table that the reading comes from
    std::size_t step = 0;      ///< step of constant set points in the recording, from 1; 0: unknown
    double normal_stress = 0;  ///< normal stress on the sample [Pa]
    double inertial_number = 0;       ///< inertial number I, the reduced shear rate [1]
    double liquid_content = 0;        ///< volume of liquid divided by volume of grains [1]; 0: dry
    double shear_stress = 0;          ///< measured shear stress [Pa]
    double shear_stress_error = 0;    ///< standard error of the measured shear stress [Pa]
    double solid_fraction = 0;        ///< measured solid fraction [1]
    double solid_fraction_error = 0;  ///< standard error of the measured solid fraction [1]
    double predicted_shear_stress = 0;    ///< shear stress predicted by the fit [Pa]; 0: no fit
    double predicted_solid_fraction = 0;  ///< solid fraction predicted by the fit [1]; 0: no fit
    bool fitted = false;  ///< whether the model's parameters were fitted to the reading
};

/// Fit of a study's model to the study's readings.
struct Fit {
    std::vector<Estimate> parameters;  ///< fitted parameters, the intergranular friction first
    /// Misfit chi2 of all readings and of the direct measurements of parameters [1], the readings
    /// included to which the parameters were not fitted.
    double chi2 = 0;
    int degrees_of_freedom = 0;  ///< degrees of freedom of `chi2`
    bool converged = false;      ///< whether the search for the best parameters converged
    /// Reasons not to believe the fit, as sentences, the most serious first; empty: none found.
    std::vector<std::string> doubts;
    std::vector<Reading> readings;  ///< all readings of the study with their predictions
};

/// Result of a diagnosis: whether a physical effect is missing from a study's model, and which.
struct Verdict {
    /// Result in one word:
    /// - "nothing-missing": the model fits, and the readings would have revealed every effect that
    ///   is large enough to matter (effects that the readings cannot reveal at any size do not
    ///   count);
    /// - "inconclusive": the model fits, but the readings cannot exclude some effects, or the
    ///   errors of some readings are assumed, not measured;
    /// - "missing": the model lacks the effects in `effects`;
    /// - "indistinguishable": several models with different further effects fit equally well;
    /// - "unknown": the model does not fit, and no known effect explains the misfit;
    /// - "suspect-measurement": an error in one part of the measurement would explain the misfit.
    std::string verdict;
    /// Names of effects, all of which the model lacks ("missing"), which explain the readings
    /// equally well ("indistinguishable"), or which may be large enough to matter ("inconclusive").
    /// Empty for every other verdict.
    std::vector<std::string> effects;
    /// Whether the study's model fits the readings, alone, with further effects, or with an error
    /// of one part of the measurement. Always true if the verdict is "suspect-measurement".
    bool complete = true;
    /// Parts of the measurement whose error alone would explain the misfit, such as "the readings
    /// of dry_1.csv".
    std::vector<std::string> suspects;
    double chi2 = 0;             ///< misfit chi2 of the study's model without further effects [1]
    int degrees_of_freedom = 0;  ///< degrees of freedom of `chi2`
    /// Reasons not to believe the fit of the study's model, as in `Fit::doubts`.
    std::vector<std::string> doubts;
};

/// Fits of a study's model before and after an effect was added or dropped.
struct Change {
    Fit before;            ///< fit of the model before the change; its `doubts` are always empty
    Fit after;             ///< fit of the model after the change
    bool written = false;  ///< whether study.toml was changed; false: the new fit did not converge
};

/// Exception for a mistake in a file, key, value or option that the user gave. The text names the
/// mistake and what to do; for a file, it begins with file:line:column.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Exception for a stop request (`Options::stop`) that ended long work early. The text says how to
/// continue.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Settings of the rheometer for one reading, a pair of shear stress and solid fraction.
struct SetPoint {
    double normal_stress = 0;    ///< normal stress on the sample [Pa]
    double inertial_number = 0;  ///< inertial number I [1]; 0: the quasi-static limit
    double liquid_content = 0;   ///< volume of liquid divided by volume of grains [1]; 0: dry
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
    SetPoint at;  ///< set point at which to shear the sample; unused if `direct` is set
    /// Parameter to measure directly, such as "torque-offset.torque"; empty: shear the sample.
    std::string direct;
    int repeats = 1;  ///< number of readings, or of direct measurements, to take
};

/// Suggested next measurements. They tell apart the models in `rivals`, or make the parameters of a
/// single model more precise.
struct Suggestion {
    /// Models to tell apart: those that fit the readings or, if none fits, those that come closest.
    /// One entry: the parameters of this model are to become more precise.
    std::vector<std::string> rivals;
    /// Measurements to take; empty: the instrument cannot tell any two of the `rivals` apart.
    std::vector<NextReading> readings;
};

/// Options of a session: simulations, files and progress messages.
struct Options {
    std::string fidelity = "standard";  ///< size of simulations: "quick", "standard", "paper"
    std::uint64_t seed = 1;             ///< seed of all random numbers
    int threads = 1;                    ///< number of simulations or refits that run at a time
    std::filesystem::path store;        ///< SQLite file that keeps simulation runs; empty: no file
    std::filesystem::path results;      ///< folder for fit.json and other results; empty: STUDY/out
    bool confirm = false;       ///< whether new simulations at the fitted parameters check a fit
    std::stop_token stop = {};  ///< a stop request ends long work by throwing `Interrupted`
    /// Called with one line of text for each progress message; empty: no calls.
    std::function<void(const std::string&)> listener = {};
};

/// Session on a study: reads the study's files once, then fits, compares, predicts, diagnoses and
/// plans measurements. The session prints nothing.
class Session {
  public:
    /// Reads a study and all its recordings.
    /// @param study folder of the study, or its study.toml
    /// @param options settings of this session, such as the folder for results
    /// @throws InputError for a mistake in a file of the study or in the options, or if results
    ///         would replace a file of the study
    explicit Session(const std::filesystem::path& study, Options options = {});
    ~Session();
    /// Moves a session into a new object. The moved session must not be used.
    Session(Session&&) noexcept;
    /// Moves a session into this object and ends the one that it held before.
    Session& operator=(Session&&) noexcept;

    /// Returns the measured readings of the study, dry readings first; their predicted values are
    /// 0.
    std::vector<Reading> readings() const;

    /// Fits the parameters of the study's model, the intergranular friction among them, to the
    /// readings. An emulator, which interpolates between simulation runs, predicts the readings.
    /// Writes fit.json and fit_runs.csv to the folder for results.
    /// @throws InputError if there is nothing to fit, or if a reading cannot be simulated
    /// @throws Interrupted on a stop request
    /// @throws std::runtime_error if a file cannot be written
    Fit calibrate() const;

    /// Reads the fit in fit.json of the folder for results and compares it with the readings.
    /// @throws InputError if there is no readable fit.json, or if the study has changed since the
    ///         fit
    Fit compare() const;

    /// Predicts the reading that the instrument would show at each set point, in the order of `at`,
    /// from the fit in fit.json of the folder for results.
    /// @throws InputError if there is no readable fit.json, if the study has changed since the fit,
    ///         or if a set point cannot be simulated
    std::vector<Prediction> predict(const std::vector<SetPoint>& at) const;

    /// Tests which physical effect, if any, is missing from the study's model. Nothing is
    /// simulated: the predictions are interpolated between earlier simulation runs, which come with
    /// Pendular or are in `Options::store`.
    /// @throws InputError if there are too few readings or too few earlier simulation runs, if a
    ///         reading is outside the range that can be simulated, or if ladder.json in the folder
    ///         for results cannot be read
    /// @throws Interrupted on a stop request
    Verdict diagnose() const;

    /// Diagnoses the study and plans its next measurement. Section [rig] of study.toml states the
    /// possible settings of the instrument; without it, they lie in the range of the readings.
    /// @throws InputError if the study cannot be diagnosed (see `diagnose`), or if no earlier
    ///         simulation run is near any of the settings
    /// @throws Interrupted on a stop request
    Suggestion next() const;

    /// Fits the study's model without and with a further physical effect. If the fit with the
    /// effect converges, adds the effect to study.toml and writes the fit to the folder for
    /// results. The session is then one of the changed study. If the last diagnosis of this session
    /// found sets of effects that explain the readings as well as the added one, ladder.json keeps
    /// them, so that later diagnoses compare with them.
    /// @param effect name of the effect, such as "torque-offset"
    /// @throws InputError if the effect is unknown, is already in the model or does not apply to
    ///         the study, if ladder.json in the folder for results cannot be read, if a fit is
    ///         impossible, or if study.toml has changed since it was read
    /// @throws Interrupted on a stop request
    /// @throws std::runtime_error if a file cannot be written
    Change add(const std::string& effect);
    /// Fits the study's model with and without one of the effects that study.toml lists. If the fit
    /// without the effect converges, removes the effect from study.toml and writes the fit, as
    /// `add` does. The session is then one of the changed study.
    /// @param effect name of the effect
    /// @throws InputError if the study does not list the effect; else as for `add`
    /// @throws Interrupted on a stop request
    /// @throws std::runtime_error if a file cannot be written
    Change drop(const std::string& effect);

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::v1
