#pragma once

#include <string>
#include <vector>

#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "reports/figure.h"
#include "reports/output.h"
#include "sim/catalogue/effect.h"
#include "workflow/json/commands.h"

namespace pendular {

/// Returns the quantities on which the change of the readings depends, as words in a sentence:
/// "normal stress (largest at small values), height".
std::string dependences(const Effect& effect);

/// Returns a table with one line per parameter, grouped by the part of the experiment that the
/// effects change, such as the instrument.
std::vector<std::string> effects_table(const std::vector<EffectEntry>& entries);

/// Returns the description of one effect, with the settings and options that switch it on.
std::vector<std::string> effect_page(const EffectEntry& entry);

/// Returns the effect's page of the manual, in Markdown.
/// @param figure Markdown of the effect's signature figure, or the reason why there is none
std::string manual_page(const EffectEntry& entry, const std::string& figure);

/// Returns the index of the manual of effects, in Markdown, with links to the pages NAME.md.
std::string manual_index(const std::vector<EffectEntry>& entries);

/// Returns what `pendular effects` says of all effects.
/// @param all whether to say of each effect what the study lacks for it
Output effects_output(const std::vector<EffectEntry>& entries, bool all);

/// Returns the study for which signatures are drawn: the changes of shear stress and solid fraction
/// that an effect causes. Grains, liquid and cell are the defaults of `pendular virtual-lab`. The
/// study lists `effects`, so that its emulator also uses simulations with them.
Study signature_study(const std::vector<Effect>& effects);

/// Returns the change of the readings by an effect of the smallest size of interest: of the shear
/// stress [%] in the upper row, 1000 times that of the solid fraction [1] in the lower row. The
/// columns show it against reduced pressure [1], liquid content [1], inertial number [1] and height
/// of the sample [mm]. For effects on grains, a band shows one standard error.
///
/// The reference is the model without the effect. For a property of the liquid, it is the model
/// with the study's liquid; for an effect that computes wet strength more accurately, the model
/// with the next simpler formula or else the base model `mohr-coulomb`.
/// @throws std::invalid_argument if the emulator has no simulation with the effect
/// @throws std::domain_error if no state of the grains gives, with the effect, the shown normal
///        stress and height at a condition
Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation);

/// Returns the caption of `signature_figure`, with the quantities that stay constant.
std::string signature_caption(const Effect& effect, const Study& study);

}  // namespace pendular
