#pragma once

#include <vector>

#include "analysis/reproduction/paper_states.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of Badetti et al. (2018) that show simulations, with axes, normalisations,
/// symbols and names as in the paper. States that have not been simulated are left out. The first
/// two also show the emulator. Distant bridges join grains that do not touch.
/// - mustarphimu: dry stress ratio and solid fraction against friction
/// - muphinertial: dry stress ratio and solid fraction against the inertial number
/// - philphis: liquid content against P*
/// - cexpnum: stress ratio against 1/P* for friction 0.09, with the fitted straight lines
/// - phiexpnum: solid fraction against 1/P* for friction 0.09
/// - cphilphis, cstarmu: reduced cohesion against the liquid content, against friction
/// - coulombeff: stress ratio of the contact forces against P*, with those of dry grains
/// - zzcip, phisdiffmu: coordination numbers, solid fraction against P*
/// - appdiff, s12pred: predicted against simulated stress ratio, without and with capillary shear
///   stress
/// - cohcomp, cohgen: cohesion by Rumpf's formula, generalised cohesion, over the cohesion from the
///   straight line, against 1/P*
/// - scaps: capillary shear stress against 1/P*
/// - scapcd: capillary shear stress of distant bridges over that of bridges at contacts, against
///   1/P*
/// - fabric: fabric of contacts and of distant bridges against 1/P*
/// - scapdapp, scapapp: capillary shear stress of distant bridges, of all bridges, predicted from
///   fabric and anisotropy of forces, against the simulated value
std::vector<Figure> paper_figures(const PaperStudy& study);

}  // namespace pendular
