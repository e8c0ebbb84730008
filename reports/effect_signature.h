#pragma once

#include <string>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Study in which the signatures of effects are drawn, with the default grains, liquid and cell of
/// the virtual laboratory. It lists the effects, so that runs with them serve it.
Study signature_study(const std::vector<Effect>& effects);

/// Conditions at which signatures are drawn, dry and wet.
std::vector<Condition> signature_conditions(const Study& study);

/// Figure of the change of readings by an effect of the smallest size of interest (a switch: on):
/// shear stress [%] above, 1000 times the solid fraction below; against reduced pressure, liquid
/// content, inertial number and height of the sample. Effects on grains come with the standard
/// error of the change.
/// @throws std::invalid_argument where no run behind the simulation has the effect
/// @throws std::domain_error where no true state is shown so
Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation);

/// Caption: conditions that stay constant along the curves of those figures.
std::string signature_caption(const Effect& effect, const Study& study);

}  // namespace pendular
