#pragma once

#include <string>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Study for which the signature figures are computed. A signature is how an effect changes the
/// readings. Grains, liquid and cell are the defaults of `pendular virtual-lab`. The study lists
/// `effects`, so that its emulator (which interpolates between simulation runs) also uses runs with
/// these effects.
Study signature_study(const std::vector<Effect>& effects);

/// Returns the dry and the wet condition from which the signature figures start. Each curve of a
/// figure varies one quantity of one of the two conditions.
std::vector<Condition> signature_conditions(const Study& study);

/// Figure of how an effect of its smallest size of interest changes the predicted readings (its
/// signature). The reference is the model without the effect or, for a property of the liquid, with
/// the value of the study's liquid. Upper row: change of the shear stress [%]. Lower row: 1000
/// times the change of the solid fraction [1]. The four columns show the changes against reduced
/// pressure [1], liquid content [1], inertial number [1] and height of the sample [mm]. For effects
/// on grains, a band shows one standard error of the change.
/// @param simulation emulator, which interpolates between the study's simulation runs
/// @throws std::invalid_argument where the emulator has no run with the effect
/// @throws std::domain_error where, with the effect, no possible state of the grains gives the
///         stress and height that the instrument shows at a condition of the figure
Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation);

/// Caption of the figure that `signature_figure` returns for the effect, with the values of the
/// quantities that stay constant along the curves.
std::string signature_caption(const Effect& effect, const Study& study);

}  // namespace pendular
