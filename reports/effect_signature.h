#pragma once

#include <string>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Study from which the figures of signatures are computed; a signature is the change of the
/// readings by an effect. Grains, liquid and cell are the defaults of the virtual laboratory. The
/// study lists `effects`, so that its emulator (interpolation between simulation runs) uses runs
/// with these effects too.
Study signature_study(const std::vector<Effect>& effects);

/// Returns two conditions, dry and wet, at which the signature figures start: each of their curves
/// varies one quantity of one of these conditions.
std::vector<Condition> signature_conditions(const Study& study);

/// Figure of the signature of an effect: the change of the predicted readings when the parameters
/// of the effect go from neutral (no effect), or from the value of the study's liquid, by the
/// smallest amount of interest; an effect without a parameter is switched on. Above: change of the
/// shear stress [%]. Below: 1000 times the change of the solid fraction [1]. The columns are
/// against reduced pressure, liquid content, inertial number and height of the sample [mm]. Effects
/// on grains have a band of one standard error of the change.
/// @param simulation emulator, which interpolates between the study's simulation runs
/// @throws std::invalid_argument where the emulator has no run with the effect
/// @throws std::domain_error where, with the effect, no true state of the cell makes the instrument
///         show a condition of the figure
Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation);

/// Caption of the figure that `signature_figure` returns for the effect, with the values of the
/// quantities that stay constant along the curves.
std::string signature_caption(const Effect& effect, const Study& study);

}  // namespace pendular
