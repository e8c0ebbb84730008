#pragma once

#include <vector>

#include "analysis/reproduction/paper_states.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of Badetti et al. (2018) that show simulations, drawn from the simulated
/// states of the parameter study in the paper. The figures of dry grains also show the emulator,
/// which interpolates simulations. The axes, normalisations, symbols and the name of each figure
/// are as in the paper. States that have not been simulated are left out. P* is the reduced
/// pressure. Distant bridges join grains that do not touch.
/// - mustarphimu, muphinertial: stress ratio and solid fraction of dry grains, the first figure
///   against the friction coefficient, the second against the inertial number
/// - philphis: liquid content against P*
/// - cexpnum, phiexpnum: stress ratio with the fitted straight lines, and solid fraction, both
///   against 1/P*, for the friction coefficient 0.09
/// - cphilphis, cstarmu: reduced cohesion, the first figure against the liquid content, the second
///   against the friction coefficient
/// - coulombeff: stress ratio of the contact forces against P*, with the stress ratios of dry
///   grains
/// - zzcip, phisdiffmu: coordination numbers and solid fraction against P*
/// - appdiff, s12pred: predicted against simulated stress ratio, the first figure without capillary
///   shear stress, the second with capillary shear stress
/// - cohcomp, cohgen: predicted cohesion divided by the cohesion from the straight line, against
///   1/P*; the first figure with Rumpf's formula, the second with the generalised cohesion
/// - scaps, scapcd: capillary shear stress, and the contribution of distant bridges to the
///   capillary shear stress divided by the contribution of bridges at contacts, both against 1/P*
/// - fabric: fabric of contacts and of distant bridges against 1/P*
/// - scapdapp, scapapp: capillary shear stress predicted from the fabric and the anisotropy of
///   forces against the simulated value, the first figure for distant bridges, the second for all
///   bridges
std::vector<Figure> paper_figures(const PaperStudy& study);

}  // namespace pendular
