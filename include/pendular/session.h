#pragma once

/// @file
/// Pendular as a library: from the recordings of an annular rheometer to stresses, a calibrated
/// friction and the physical effect that a model lacks. Everything here stands on the standard
/// library alone.

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

/// A number with its error.
struct Estimate {
    std::string name;           ///< such as "friction" or "torque-offset.torque"
    std::string unit;           ///< of both numbers; "1" where it has none
    double value = 0;           ///< [unit]
    double standard_error = 0;  ///< [unit], of measurement and simulation together
};

/// A shear stress and a solid fraction at a steady state, measured and predicted.
struct Reading {
    std::string file;                     ///< it comes from
    std::size_t step = 0;                 ///< of the recording, from 1 on; 0: a row of a table
    double normal_stress = 0;             ///< [Pa]
    double inertial_number = 0;           ///< I [1]
    double liquid_content = 0;            ///< liquid over solid volume [1]; 0: dry
    double shear_stress = 0;              ///< measured [Pa]
    double shear_stress_error = 0;        ///< its standard error [Pa]
    double solid_fraction = 0;            ///< measured [1]
    double solid_fraction_error = 0;      ///< its standard error [1]
    double predicted_shear_stress = 0;    ///< by the fitted model [Pa]; 0 before there is a fit
    double predicted_solid_fraction = 0;  ///< likewise [1]
    bool fitted = false;                  ///< whether the fit saw it, or only predicts it
};

/// A model fitted to a study.
struct Fit {
    std::vector<Estimate> parameters;  ///< the friction first
    double chi2 = 0;                   ///< of all readings, predicted ones included [1]
    int degrees_of_freedom = 0;        ///< of chi2
    bool converged = false;            ///< whether the search settled
    std::vector<std::string>
        doubts;                     ///< why not to believe it, the gravest first; none: believe it
    std::vector<Reading> readings;  ///< with their predictions
};

/// Verdict of a diagnosis.
struct Verdict {
    /// "nothing-missing", "inconclusive", "missing", "indistinguishable", "unknown" or
    /// "suspect-measurement".
    std::string verdict;
    std::vector<std::string>
        effects;  ///< those that explain the readings; several: none is told apart
    std::vector<std::string> suspects;  ///< measurements that look wrong
    double chi2 = 0;                    ///< of the study's model [1]
    int degrees_of_freedom = 0;         ///< of chi2
    std::vector<std::string> doubts;    ///< as in `Fit`
};

/// An effect added or dropped: the fits without and with it.
struct Change {
    Fit before;            ///< without the effect, where it was added
    Fit after;             ///< with it
    bool written = false;  ///< whether study.toml was changed: only where the new fit converged
};

/// Something wrong in what the user gave: a file, a key, a value. The text says where, as
/// file:line:column, what is wrong and what to do.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A request to stop was heeded; the text says how to go on.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A state that an instrument is set to.
struct SetPoint {
    double normal_stress = 0;    ///< [Pa]
    double inertial_number = 0;  ///< I [1]; 0: the quasi-static limit
    double liquid_content = 0;   ///< liquid over solid volume [1]; 0: dry
};

/// Prediction of a fitted model at a set point, as the instrument shows it.
struct Prediction {
    SetPoint at;                      ///< where
    double shear_stress = 0;          ///< [Pa]
    double shear_stress_error = 0;    ///< its standard error [Pa]
    double solid_fraction = 0;        ///< [1]
    double solid_fraction_error = 0;  ///< its standard error [1]
};

/// One measurement that tells models apart, or sharpens the only one.
struct NextReading {
    SetPoint at;         ///< where to shear
    std::string direct;  ///< instead, the parameter to measure by itself; empty: shear
    int repeats = 1;     ///< how often
};

/// Suggested next measurement.
struct Suggestion {
    std::vector<std::string> rivals;    ///< models that are left; one: nothing to tell apart
    std::vector<NextReading> readings;  ///< empty: the rig tells none of the rivals apart
};

/// How simulations of a study are made, and whom to tell.
struct Options {
    std::string fidelity = "standard";  ///< quick, standard or paper
    std::uint64_t seed = 1;             ///< of the simulations
    int threads = 1;                    ///< runs and refits side by side
    std::filesystem::path store;        ///< SQLite file that keeps runs; empty: none
    std::filesystem::path results;      ///< folder for fit.json and others; empty: STUDY/out
    bool confirm = false;               ///< fresh runs at the optimum confirm a fit
    std::stop_token stop = {};          ///< ends long work
    /// Told what goes on, a line each; empty: nobody.
    std::function<void(const std::string&)> listener = {};
};

/// A study at work: reads its files once, and answers whatever is asked of it. Nothing is printed.
class Session {
  public:
    /// Reads a study, named by its folder or its study.toml, and all its recordings.
    /// @throws InputError for what is wrong in its files
    explicit Session(const std::filesystem::path& study, Options options = {});
    ~Session();
    /// Sessions are moved, not copied: each has its files open.
    Session(Session&&) noexcept;
    /// Moves a session.
    Session& operator=(Session&&) noexcept;

    /// Measured stresses and solid fractions.
    std::vector<Reading> readings() const;

    /// Fits the study's parameters, the friction among them, by simulation, and writes fit.json to
    /// the results folder.
    /// @throws InputError where there is nothing to fit; Interrupted
    Fit calibrate() const;

    /// Reads the fit of the results folder, and puts it beside the readings.
    /// @throws InputError where there is no fit, or it is another study's
    Fit compare() const;

    /// Predicts what the instrument shows, by the fit of the results folder.
    /// @throws InputError where there is no fit, or a set point cannot be simulated
    std::vector<Prediction> predict(const std::vector<SetPoint>& at) const;

    /// Says which physical effect is missing from the study's model, if any.
    /// @throws InputError for what cannot be diagnosed; Interrupted
    Verdict diagnose() const;

    /// Says what to measure next on the study's rig, or within what its readings span.
    /// @throws InputError for what cannot be diagnosed, and where the known runs support nothing
    ///         that the rig can do; Interrupted
    Suggestion next() const;

    /// Takes an effect into the study's file and fits it anew. The session then is of the study as
    /// it was: open another one.
    /// @throws InputError for an effect that is unknown or does not apply; Interrupted
    Change add(const std::string& effect) const;
    /// Takes an effect out of the study's file, likewise.
    Change drop(const std::string& effect) const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::v1
