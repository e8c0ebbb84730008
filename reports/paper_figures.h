#pragma once

#include <vector>

#include "analysis/reproduction/paper_states.h"
#include "reports/figure.h"

namespace pendular {

/// Figures of Badetti et al. (2018) that show simulations, drawn from the simulated states of its
/// parameter study: the axes, normalisations and symbol code (symbol_code.h) are those of the
/// paper, the name of each figure is that of the paper's figure. Values without a state are left
/// out.
/// - mustarphimu, muphinertial: stress ratio and solid fraction of dry grains against friction and
///   inertial number
/// - philphis: liquid content against P*
/// - cexpnum, phiexpnum: stress ratio with its straight lines, and solid fraction, of friction 0.09
///   against 1/P*
/// - cphilphis, cstarmu: reduced cohesion against liquid content and friction
/// - coulombeff: stress ratio of contact forces against P*, with the dry stress ratios
/// - zzcip, phisdiffmu: coordination numbers and solid fraction against P*
/// - appdiff, s12pred: stress ratios predicted without and with capillary shear stress
/// - cohcomp, cohgen: Rumpf's and generalised cohesion over that of the straight line against 1/P*
/// - scaps, scapcd: capillary shear stress, and its parts' ratio, against 1/P*
/// - fabric: fabric of contacts and of distant bridges against 1/P*
/// - scapdapp, scapapp: capillary shear stress predicted from fabric and force anisotropy
std::vector<Figure> paper_figures(const PaperStudy& study);

}  // namespace pendular
