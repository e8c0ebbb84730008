#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/profile.h"
#include "data/study/effect_tables.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Quantity, such as the torque, that an unknown cause may change and a formula of an [[effect]] in
/// study.toml can set.
struct ChangedQuantity {
    std::string target;      ///< name of the quantity in formulas, such as "torque"
    bool relative = true;    ///< whether multiplied by 1 + change, else the change is added
    std::string unit;        ///< SI unit of the change; "1" if `relative` is true
    double smallest = 0.01;  ///< smallest change of interest [unit]
    double lower = -0.9;     ///< limits of the change [unit]
    double upper = 9;

    /// Returns whether it belongs to the instrument, to the flow, or to grains and liquid.
    WrittenEffect::Kind kind() const;
    /// Whether a sensor shows the quantity, so that a check of the sensor can decide.
    bool of_sensor() const { return kind() == WrittenEffect::Kind::instrument; }
};

/// Change of unknown cause: which quantity changes, and how the change varies between readings.
struct ShapeOfChange {
    ChangedQuantity quantity;
    Profile profile;

    /// Returns the change as an [[effect]] of study.toml. Its parameter "change" is the change
    /// where the profile has the size 1.
    WrittenEffect written(const std::string& name) const;
    /// Returns a name for the effect, such as "torque-above-time".
    std::string name() const;
};

/// Returns the quantities that an unknown cause may change: stress ratio, solid fraction and
/// friction coefficient; torque, normal force and height with a cell; the surface tension with wet
/// readings. Left out are those whose effect does not apply to the study (`why_not`).
std::vector<ChangedQuantity> quantities_that_may_change(const ResolvedStudy& study,
                                                        const std::vector<Reading>& readings);

}  // namespace pendular
