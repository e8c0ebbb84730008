#pragma once

#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Error that all readings of a study share, such as that of the calibration of the torque: one
/// unknown number with a standard uncertainty, of expectation 0 unless it is one-sided. An error
/// has the consequences of an effect of the instrument or of the condition, of which it is a small
/// amount. Source: JCGM 100:2008 (GUM), section 4.3 (type B evaluation) and annex F.2.4.
struct SharedUncertainty {
    std::string name;  ///< effect, such as "torque-gain", or key of study.toml, such as "density"
    double standard = 0;     ///< standard uncertainty [`unit`]
    std::string unit = "1";  ///< SI unit; "1": relative to the value
    bool assumed = false;    ///< typical of a class of instruments, not stated by the user
    /// Whether fits take the error into account: it is stated, or the study states the class of its
    /// instrument. The others show what a study leaves out.
    bool counts = true;
    /// Whether no size is known, so that it is in no budget: an effect of the instrument that is
    /// named where it changes the readings as an error of the budget does. `standard` is then the
    /// smallest size of interest.
    bool unbudgeted = false;
    /// Whether an error can only have this sign, such as that of neglecting what can only raise, or
    /// only lower, the torque. The readings are not corrected for its expectation, so that
    /// `standard` is its root mean square. Source: GUM, F.2.4.5. Such an error never counts: among
    /// the weights, readings could need it with the other sign.
    bool one_sided = false;
    /// Effects in which an error consists, with one fitted parameter each, which all have the same
    /// distance from their neutral values. They are constant as long as the program runs.
    std::vector<const Effect*> effects = {};

    /// Returns the effects with an error of `standard`, or of its negative value if `below`, which
    /// is none if the error is one-sided.
    std::vector<ActiveEffect> error(bool below) const;
    /// Whether an effect changes the same quantity, so that a model which fits the effect's
    /// parameter knows nothing else of the quantity.
    bool is_fitted_by(const Effect& effect) const;
};

/// Returns the shared uncertainties of a study: those that its table [instrument] states, then
/// typical values of all others that apply to the study, which count if the table states a class,
/// and the other effects of its instrument, of which no typical size is known. A study with a cell
/// has the uncertainties of a rotational rheometer with an annular cell, and one of tables alone
/// those of the tables' quantities.
/// @throws InputError at a class or a name that is unknown or does not apply to the study, and at a
///         value that is not positive or whose unit does not fit
std::vector<SharedUncertainty> shared_uncertainties(const Study& study);

}  // namespace pendular
