#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/profile.h"
#include "data/study/effect_tables.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Quantity that a change of unknown cause may act on: one that a formula of an [[effect]] can set.
struct ChangedQuantity {
    std::string target;      ///< name of the quantity in formulas, such as "torque"
    bool relative = true;    ///< whether the change is a factor on the quantity, else it is added
    std::string unit;        ///< SI unit of the change: "1" where it is relative
    double smallest = 0.01;  ///< smallest change that matters [unit]
    double lower = -0.9;     ///< smallest change considered [unit]
    double upper = 9;        ///< largest change considered [unit]

    /// Kind of the quantity: of the instrument, of the flow, or of grains and liquid.
    WrittenEffect::Kind kind() const;
};

/// Change of unknown cause: the change of a quantity varies with one coordinate of the readings,
/// such as time, as a profile does.
struct ShapeOfChange {
    ChangedQuantity quantity;
    Profile profile;

    /// The change as a table [[effect]] of study.toml with this name. Its parameter "change" is the
    /// change where the size of the profile is 1.
    WrittenEffect written(const std::string& name) const;
    /// Name of the effect, made from the changed quantity, the dependence and the coordinate, such
    /// as "torque-above-time".
    std::string name() const;
};

/// Quantities that may change in a study with these readings: quantities of the flow and of the
/// grains; in a study with a cell, also the quantities that the instrument shows; with wet
/// readings, also the surface tension of the liquid.
std::vector<ChangedQuantity> quantities_that_may_change(const ResolvedStudy& study,
                                                        const std::vector<Reading>& readings);

}  // namespace pendular
