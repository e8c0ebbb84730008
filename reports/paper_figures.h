#pragma once

#include <vector>

#include "analysis/reproduction/paper_states.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of Badetti et al. (2018) that show simulations, drawn from the simulated
/// states of the paper's parameter study. The axes, normalisations, symbols and the name of each
/// figure are those of the paper. States that have not been simulated are left out. P* is the
/// reduced pressure.
/// - mustarphimu, muphinertial: stress ratio and solid fraction of dry grains against friction and
///   inertial number
/// - philphis: liquid content against P*
/// - cexpnum, phiexpnum: stress ratio with its straight lines, and solid fraction, of friction 0.09
///   against 1/P*
/// - cphilphis, cstarmu: reduced cohesion against liquid content and friction
/// - coulombeff: stress ratio of contact forces against P*, with the dry stress ratios
/// - zzcip, phisdiffmu: coordination numbers and solid fraction against P*
/// - appdiff, s12pred: stress ratios predicted without and with capillary shear stress
/// - cohcomp, cohgen: cohesion by Rumpf's formula and generalised cohesion, each divided by the
///   cohesion from the straight line, against 1/P*
/// - scaps, scapcd: capillary shear stress, and the ratio of its parts from contacts and from
///   distant bridges, against 1/P*
/// - fabric: fabric of contacts and of distant bridges against 1/P*
/// - scapdapp, scapapp: capillary shear stress predicted from fabric and force anisotropy
std::vector<Figure> paper_figures(const PaperStudy& study);

}  // namespace pendular
