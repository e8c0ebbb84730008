#pragma once

#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// Direct measurement of an effect's parameter, such as the drag from the torque of the empty cell,
/// or the contact angle from a drop. All values are in `unit`.
struct DirectMeasurement {
    std::string parameter;  ///< "EFFECT.PARAMETER", such as "torque-offset.torque"
    std::string unit;       ///< SI unit of the parameter
    std::string by = {};    ///< instrument or method, such as "a viscometer"; empty if unknown
    /// Value that a model without the effect assumes (`Effect::unlisted_value`): that of the
    /// study's liquid, such as its surface tension, or the value at which the effect vanishes, such
    /// as 1 for a torque gain.
    double neutral = 0;
    double value = 0;  ///< 0 if not measured yet
    double standard_error = 0;
};

/// Returns a table [[direct]] or [[rig.direct]] of study.toml as a direct measurement in SI units.
/// @throws InputError if the effect is unknown, can only be switched on or off, or does not apply
///         to the study, if a unit does not fit the parameter, or if the standard error is not
///         positive
DirectMeasurement direct_measurement(const StatedDirect& stated, const Study& study,
                                     const EffectCatalogue& catalogue);

/// Returns the direct measurements of the tables [[direct]] of study.toml, in their order and in SI
/// units.
/// @throws InputError for a table that `direct_measurement` does not accept
std::vector<DirectMeasurement> direct_measurements(const Study& study,
                                                   const EffectCatalogue& catalogue);

}  // namespace pendular
