#pragma once

#include <string>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Returns the study for which the figures of effects' signatures are drawn. The signature of an
/// effect is the change of shear stress and solid fraction that the effect causes. Grains, liquid
/// and cell are the defaults of `pendular virtual-lab`. The study lists `effects`, so that the
/// emulator of the study (which interpolates between simulations) also uses simulations with these
/// effects.
Study signature_study(const std::vector<Effect>& effects);

/// Returns the dry and the wet condition (normal stress, inertial number, liquid content) of the
/// figures that show how an effect changes the readings (signature of the effect). Along each curve
/// of a figure, one quantity varies. All other quantities keep their values at the dry or the wet
/// condition.
std::vector<Condition> signature_conditions(const Study& study);

/// Returns a figure of how an effect of the smallest size of interest changes the predicted
/// readings. The upper row of panels shows the change of the shear stress [%]. The lower row shows
/// 1000 times the change of the solid fraction [1]. The four columns show the changes against
/// reduced pressure [1], liquid content [1], inertial number [1] and height of the sample [mm]. For
/// effects on grains, a band shows one standard error of the change.
///
/// The reference of the change is the model without the effect, with two exceptions:
/// - For a property of the liquid, the reference is the model with the value of the study's liquid.
/// - For an effect that makes the model compute the strength of wet grains more accurately, the
///   reference is the model with the next simpler formula or, if there is none, the base model
///   `mohr-coulomb`.
/// @param simulation emulator, which interpolates between the simulations known for the study
/// @throws std::invalid_argument if the emulator has no simulation with the effect
/// @throws std::domain_error if, with the effect, no possible state of the grains gives the normal
///        stress and height that the instrument shows at a condition of the figure
Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation);

/// Returns the caption of the figure that `signature_figure` returns for the effect. The caption
/// states the quantities that stay constant along the curves, with their values.
std::string signature_caption(const Effect& effect, const Study& study);

}  // namespace pendular
