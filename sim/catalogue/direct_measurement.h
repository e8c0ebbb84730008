#pragma once

#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// Direct measurement of an effect's parameter without shearing grains, such as the measurement of
/// the drag from the torque of the empty cell, or of the contact angle from a drop.
struct DirectMeasurement {
    /// Name of the measured parameter as "EFFECT.PARAMETER", such as "torque-offset.torque".
    std::string parameter;
    std::string unit;  ///< SI unit of the measured parameter
    /// Instrument or method that measures the parameter, such as "a viscometer"; empty if unknown.
    std::string by = {};
    /// Value of the parameter, in the parameter's unit, that a model assumes if the model does not
    /// list the effect (`Effect::unlisted_value`). If the study's liquid gives the parameter
    /// (`Effect::given_by_liquid`), as for the surface tension, the value is that of the liquid.
    /// Otherwise the effect vanishes at this value, such as 1 for a torque gain.
    double neutral = 0;
    /// Measured value of the parameter, in the parameter's unit; 0 if not measured yet.
    double value = 0;
    double standard_error = 0;  ///< standard error of the measured value, in the parameter's unit
};

/// Converts a table [[direct]] or [[rig.direct]] of study.toml to a direct measurement. Value and
/// standard error are in the SI unit of the parameter.
/// @param catalogue all effects available to the study
/// @throws InputError if the effect is unknown, can only be switched on or off, or does not apply
///         to the study, if a unit does not fit the parameter, or if the standard error is not
///         positive
DirectMeasurement direct_measurement(const StatedDirect& stated, const Study& study,
                                     const EffectCatalogue& catalogue);

/// Returns the direct measurements that the tables [[direct]] of study.toml state, in the order of
/// the tables. Each measurement is in the SI unit of its parameter.
/// @param catalogue all effects available to the study
/// @throws InputError for a table that `direct_measurement` does not accept
std::vector<DirectMeasurement> direct_measurements(const Study& study,
                                                   const EffectCatalogue& catalogue);

}  // namespace pendular
