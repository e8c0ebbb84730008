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

/// Fitted parameter with its standard error.
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

/// Verdict of a diagnosis: whether a physical effect is missing from a study's model, and which.
struct Verdict {
    /// Result in one word: "nothing-missing", "inconclusive", "missing", "indistinguishable"
    /// (several effects explain the readings equally well), "unknown" (something is missing that no
    /// known effect explains) or "suspect-measurement".
    std::string verdict;
    /// Effects that the verdict names. "missing": all of them are missing; "indistinguishable":
    /// alternatives that explain the readings equally well; "inconclusive": effects that could be
    /// large enough to matter without showing in these readings.
    std::vector<std::string> effects;
    bool complete = true;  ///< whether the model with the named effects explains the readings
    std::vector<std::string> suspects;  ///< measurements whose error would explain the readings too
    double chi2 = 0;                    ///< misfit chi2 of the study's model, nothing added [1]
    int degrees_of_freedom = 0;         ///< degrees of freedom of `chi2`
    /// Reasons not to believe the fit of the study's model, as sentences, the most serious first;
    /// empty: none was found.
    std::vector<std::string> doubts;
};

/// Fits of a study before and after an effect was added to its model or dropped from it.
struct Change {
    Fit before;            ///< fit of the model before the change
    Fit after;             ///< fit of the model after the change
    bool written = false;  ///< whether study.toml was changed: only where the new fit converged
};

/// Thrown for a mistake in a file, key, value or option that the user gave. The text names the
/// mistake, what to do and, for a mistake in a file, the place as file:line:column.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Thrown where a request by `Options::stop` ended work early. The text says how to resume it.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Set point of the rheometer for one reading, a pair of shear stress and solid fraction.
struct SetPoint {
    double normal_stress = 0;    ///< normal stress on the sample [Pa]
    double inertial_number = 0;  ///< inertial number I [1]; 0: the quasi-static limit
    double liquid_content = 0;   ///< liquid volume over solid volume [1]; 0: dry
};

/// Reading that the fitted model predicts at a set point, as the instrument would show it.
struct Prediction {
    SetPoint at;                      ///< set point of the predicted reading
    double shear_stress = 0;          ///< predicted shear stress [Pa]
    double shear_stress_error = 0;    ///< standard error of the predicted shear stress [Pa]
    double solid_fraction = 0;        ///< predicted solid fraction [1]
    double solid_fraction_error = 0;  ///< standard error of the predicted solid fraction [1]
};

/// One suggested measurement: readings at a set point, or direct measurements of a parameter.
struct NextReading {
    SetPoint at;         ///< set point at which to shear the sample
    std::string direct;  ///< parameter to measure by itself instead of shearing; empty: shear
    int repeats = 1;     ///< number of readings, or of direct measurements, to take
};

/// Suggested next measurements: they tell apart the models that fit the readings or, if only one
/// model fits, make its parameters more precise.
struct Suggestion {
    std::vector<std::string> rivals;  ///< models that fit; one: there is nothing to tell apart
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
    /// Reads a study, named by its folder or its study.toml, and all its recordings.
    /// @throws InputError for a mistake in these files or in the options, and for results that
    ///         would replace one of these files
    explicit Session(const std::filesystem::path& study, Options options = {});
    ~Session();
    /// Moves a session. Sessions cannot be copied.
    Session(Session&&) noexcept;
    /// Moves a session into this one.
    Session& operator=(Session&&) noexcept;

    /// Returns the measured readings of the study, dry readings first, without predictions.
    std::vector<Reading> readings() const;

    /// Fits the study's parameters, the intergranular friction among them, by simulations and an
    /// emulator, which interpolates between simulation runs. Writes fit.json and fit_runs.csv to
    /// the folder for results (`Options::results`).
    /// @throws InputError where there is nothing to fit or a reading cannot be simulated
    /// @throws Interrupted where `Options::stop` ended the work
    Fit calibrate() const;

    /// Reads fit.json from the folder for results and compares the fit with the study's readings.
    /// @throws InputError where there is no readable fit.json, or the study has changed since
    Fit compare() const;

    /// Returns the reading that the instrument would show at each set point, as predicted by the
    /// fit in fit.json of the folder for results.
    /// @throws InputError where there is no readable fit.json, the study has changed since, or a
    ///         set point cannot be simulated
    std::vector<Prediction> predict(const std::vector<SetPoint>& at) const;

    /// Tests which physical effect, if any, is missing from the study's model, without any new
    /// simulation.
    /// @throws InputError where the study has too few readings, or atlas and store too few
    ///         simulations, for a diagnosis, or a reading is outside the range that can be
    ///         simulated
    /// @throws Interrupted where `Options::stop` ended the work
    Verdict diagnose() const;

    /// Diagnoses the study as `diagnose` and plans the next measurement, among the instrument
    /// settings in section [rig] of study.toml or, without this section, in the readings' range.
    /// @throws InputError where `diagnose` would throw it, and where the reading at none of these
    ///         settings can be predicted from the simulations in atlas and store
    /// @throws Interrupted where `Options::stop` ended the work
    Suggestion next() const;

    /// Fits the study's model with a further physical effect, named as in "torque-offset"; where
    /// the fit converges, adds the effect to study.toml. This session keeps the study without the
    /// effect: open another session to go on.
    /// @throws InputError for an effect that is unknown, that is in the model already or that does
    ///         not apply to the study
    /// @throws Interrupted where `Options::stop` ended the work
    Change add(const std::string& effect) const;
    /// Fits the study's model without one of the effects that study.toml lists; where the fit
    /// converges, removes the effect from study.toml. This session keeps the study with the effect:
    /// open another session to go on.
    /// @throws InputError for an effect that the study does not list
    /// @throws Interrupted where `Options::stop` ended the work
    Change drop(const std::string& effect) const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::v1
