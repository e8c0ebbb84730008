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
    std::string name;           ///< name, such as "friction" or "torque-offset.torque"
    std::string unit;           ///< unit of value and error; "1": dimensionless
    double value = 0;           ///< fitted value [unit]
    double standard_error = 0;  ///< from errors of measurement and simulation together [unit]
};

/// Shear stress and solid fraction of one steady state, as measured and as a fitted model predicts
/// them.
struct Reading {
    std::string file;               ///< file of the recording or table that the reading comes from
    std::size_t step = 0;           ///< step of the recording, counted from 1; 0: a row of a table
    double normal_stress = 0;       ///< [Pa]
    double inertial_number = 0;     ///< I [1]
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
    double chi2 = 0;                   ///< chi2 of all readings, fitted and predicted [1]
    int degrees_of_freedom = 0;        ///< degrees of freedom of chi2
    bool converged = false;            ///< whether the search for the best parameters converged
    /// Reasons not to believe the fit as sentences, the most serious first; empty: none was found.
    std::vector<std::string> doubts;
    std::vector<Reading> readings;  ///< all readings of the study with their predictions
};

/// Verdict of a diagnosis: whether a physical effect is missing from a study's model, and which.
struct Verdict {
    /// "nothing-missing", "inconclusive", "missing", "indistinguishable", "unknown" or
    /// "suspect-measurement".
    std::string verdict;
    /// Effects that the verdict names. "missing": all of them are missing; "indistinguishable":
    /// alternatives that explain the readings equally well; "inconclusive": effects that these
    /// readings would not reveal.
    std::vector<std::string> effects;
    std::vector<std::string> suspects;  ///< measurements whose error would explain the readings too
    double chi2 = 0;                    ///< chi2 of the study's model as it is [1]
    int degrees_of_freedom = 0;         ///< degrees of freedom of chi2
    /// Reasons not to believe the fit of the study's model, the most serious first.
    std::vector<std::string> doubts;
};

/// Fits of a study before and after an effect was added to its model or dropped from it.
struct Change {
    Fit before;            ///< fit of the model before the change
    Fit after;             ///< fit of the model after the change
    bool written = false;  ///< whether study.toml was changed: only where the new fit converged
};

/// Thrown for a mistake in a file, key or value that the user gave. The text names the place as
/// file:line:column, the mistake and what to do.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Thrown where a request to stop ended work early. The text says how to resume the work.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Set point of the instrument for one reading.
struct SetPoint {
    double normal_stress = 0;    ///< [Pa]
    double inertial_number = 0;  ///< I [1]; 0: the quasi-static limit
    double liquid_content = 0;   ///< liquid volume over solid volume [1]; 0: dry
};

/// Reading that the fitted model predicts at a set point, as the instrument would show it.
struct Prediction {
    SetPoint at;                      ///< set point that is predicted
    double shear_stress = 0;          ///< [Pa]
    double shear_stress_error = 0;    ///< standard error of the shear stress [Pa]
    double solid_fraction = 0;        ///< [1]
    double solid_fraction_error = 0;  ///< standard error of the solid fraction [1]
};

/// One suggested measurement: readings at a set point, or direct measurements of a parameter.
struct NextReading {
    SetPoint at;         ///< set point at which to shear the sample
    std::string direct;  ///< parameter to measure by itself instead of shearing; empty: shear
    int repeats = 1;     ///< number of repetitions
};

/// Suggested next measurements. They separate the models that fit, or make the parameters of the
/// only model that fits more precise.
struct Suggestion {
    std::vector<std::string> rivals;    ///< models that fit; one: there is nothing to separate
    std::vector<NextReading> readings;  ///< empty: the instrument separates none of the rivals
};

/// Options of a session: simulations, files and progress messages.
struct Options {
    std::string fidelity = "standard";  ///< size of simulations: "quick", "standard" or "paper"
    std::uint64_t seed = 1;             ///< seed of all random numbers
    int threads = 1;                    ///< number of simulations or refits at a time
    std::filesystem::path store;        ///< SQLite file that keeps simulation runs; empty: none
    std::filesystem::path results;      ///< folder for fit.json and other results; empty: STUDY/out
    bool confirm = false;               ///< confirm each fit by new simulations at the optimum
    std::stop_token stop = {};          ///< ends long work early, with `Interrupted`
    /// Called with one line of text for each event of the work; empty: no calls.
    std::function<void(const std::string&)> listener = {};
};

/// Session on a study: reads the study's files once, then fits, compares, predicts, diagnoses and
/// plans measurements. Nothing is printed.
class Session {
  public:
    /// Reads a study, named by its folder or its study.toml, and all its recordings.
    /// @throws InputError for a mistake in these files or in the options
    explicit Session(const std::filesystem::path& study, Options options = {});
    ~Session();
    /// Moves a session. Sessions cannot be copied.
    Session(Session&&) noexcept;
    /// Moves a session into this one.
    Session& operator=(Session&&) noexcept;

    /// Returns the measured readings of the study, dry readings first, without predictions.
    std::vector<Reading> readings() const;

    /// Fits the study's parameters, the intergranular friction among them, by simulation and an
    /// emulator of simulation runs, and writes fit.json to the results folder.
    /// @throws InputError where there is nothing to fit or a reading cannot be simulated
    /// @throws Interrupted where the work was stopped
    Fit calibrate() const;

    /// Reads fit.json from the results folder and compares the fit with the readings.
    /// @throws InputError where there is no fit, or the fit belongs to another study
    Fit compare() const;

    /// Returns what the instrument would show at each set point, as predicted by the fit in the
    /// results folder.
    /// @throws InputError where there is no fit, the fit belongs to another study, or a set point
    ///         cannot be simulated
    std::vector<Prediction> predict(const std::vector<SetPoint>& at) const;

    /// Tests which physical effect, if any, is missing from the study's model, without any new
    /// simulation.
    /// @throws InputError where the study cannot be diagnosed, as with too few readings
    /// @throws Interrupted where the work was stopped
    Verdict diagnose() const;

    /// Diagnoses the study and plans the next measurement: among the settings in section [rig] of
    /// study.toml, else within the range of the readings.
    /// @throws InputError where the study cannot be diagnosed, and where none of these settings can
    ///         be predicted from the known simulation runs
    /// @throws Interrupted where the work was stopped
    Suggestion next() const;

    /// Fits the study with a further effect; where the fit converges, adds the effect to
    /// study.toml. This session keeps the study without the effect: open another session to go on.
    /// @throws InputError for an effect that is unknown, that is in the model already or that does
    ///         not apply to the study
    /// @throws Interrupted where the work was stopped
    Change add(const std::string& effect) const;
    /// Fits the study without one of its effects; where the fit converges, removes the effect from
    /// study.toml. This session keeps the study with the effect: open another session to go on.
    /// @throws InputError for an effect that the study does not list
    /// @throws Interrupted where the work was stopped
    Change drop(const std::string& effect) const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::v1
