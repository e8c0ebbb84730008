#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/profile.h"
#include "data/study/effect_tables.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Quantity, such as the torque, that an unknown cause may change, with the bounds of the change. A
/// formula of an [[effect]] in study.toml can set the quantity.
struct ChangedQuantity {
    std::string target;  ///< name of the quantity in formulas, such as "torque"
    /// Whether the quantity is multiplied by 1 + change. If false, the change is added to the
    /// quantity.
    bool relative = true;
    std::string unit;  ///< SI unit of the change; "1" if `relative` is true
    /// Smallest change of the quantity that is of interest [unit].
    double smallest = 0.01;
    /// Lower limit of the change of the quantity [unit].
    double lower = -0.9;
    /// Upper limit of the change of the quantity [unit].
    double upper = 9;

    /// Returns the kind of effect that changes the quantity: an effect on the instrument, on the
    /// flow, or on grains and liquid.
    WrittenEffect::Kind kind() const;
    /// Whether a sensor of the instrument shows the quantity, so that a check of the sensor can
    /// decide whether the quantity changes.
    bool of_sensor() const { return kind() == WrittenEffect::Kind::instrument; }
};

/// Shape of a change of unknown cause: which quantity changes, and how the change varies with one
/// coordinate of the readings, such as the time.
struct ShapeOfChange {
    ChangedQuantity quantity;
    Profile profile;

    /// Returns the change as a table [[effect]] of study.toml with the name `name`. The parameter
    /// "change" of the effect is the change at readings at which the profile has the size 1.
    WrittenEffect written(const std::string& name) const;
    /// Returns a name for the change as an effect, made from the changed quantity, the dependence
    /// and the coordinate, such as "torque-above-time".
    std::string name() const;
};

/// Returns the quantities of a study that an unknown cause may change: stress ratio, solid fraction
/// and friction coefficient. In a study with a cell, torque, normal force and height of the sample
/// may also change. With wet readings, the surface tension of the liquid may also change. A
/// quantity is left out if an effect that changes it does not apply to the study (`why_not`).
std::vector<ChangedQuantity> quantities_that_may_change(const ResolvedStudy& study,
                                                        const std::vector<Reading>& readings);

}  // namespace pendular
