#pragma once

#include <string>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Study in which the signatures of effects, their changes of the readings, are drawn: the default
/// grains, liquid and cell of the virtual laboratory. The study lists the effects, so that its
/// emulator uses runs with these effects too.
Study signature_study(const std::vector<Effect>& effects);

/// Returns the dry and the wet condition about which the curves of signatures vary one quantity.
std::vector<Condition> signature_conditions(const Study& study);

/// Figure of the signature of an effect at its smallest size of interest (a switch: on), as the
/// emulator predicts it. Above: change of the shear stress [%]; below: 1000 times the change of the
/// solid fraction [1]; against reduced pressure, liquid content, inertial number and height of the
/// sample. Effects on grains have a band of one standard error of the change.
/// @throws std::invalid_argument where the emulator has no run with the effect
/// @throws std::domain_error where, with the effect, no true state of the cell gives the shown
///         reading
Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation);

/// Caption of the figure of `signature_figure`, with the conditions that stay constant along its
/// curves.
std::string signature_caption(const Effect& effect, const Study& study);

}  // namespace pendular
