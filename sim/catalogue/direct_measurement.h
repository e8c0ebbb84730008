#pragma once

#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// Direct measurement of an effect's parameter, without shearing the grains: a drag by the torque
/// of the empty cell, a contact angle by a drop. A model without the effect predicts the neutral
/// value.
struct DirectMeasurement {
    std::string parameter;      ///< "torque-offset.torque"
    std::string unit;           ///< SI
    std::string by = {};        ///< what measures it; empty where that is not known
    double neutral = 0;         ///< [unit]
    double value = 0;           ///< [unit]; 0 where it has not been measured yet
    double standard_error = 0;  ///< [unit]
};

/// Direct measurement as a study or its rig states it, in the unit of the effect's parameter.
/// @throws InputError for an effect that is unknown, a switch, or does not apply to the study, and
///         for a value or error in another unit than the effect's
DirectMeasurement direct_measurement(const StatedDirect& stated, const Study& study,
                                     const EffectCatalogue& catalogue);

/// Direct measurements of a study, from [[direct]].
/// @throws InputError likewise
std::vector<DirectMeasurement> direct_measurements(const Study& study,
                                                   const EffectCatalogue& catalogue);

}  // namespace pendular
