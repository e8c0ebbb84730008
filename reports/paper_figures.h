#pragma once

#include <vector>

#include "analysis/reproduction/paper_states.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of Badetti et al. (2018) that show simulations, drawn from the simulated
/// states of the parameter study in the paper. Axes, normalisations, symbols and names of the
/// figures are as in the paper. States that have not been simulated are left out. P* is the reduced
/// pressure. Distant bridges join grains that do not touch.
/// - mustarphimu: stress ratio and solid fraction of dry grains against the friction coefficient,
///   with the emulator, which interpolates simulations
/// - muphinertial: stress ratio and solid fraction of dry grains against the inertial number, with
///   the emulator
/// - philphis: liquid content against P*
/// - cexpnum: stress ratio against 1/P* for the friction coefficient 0.09, with the fitted straight
///   lines
/// - phiexpnum: solid fraction against 1/P* for the friction coefficient 0.09
/// - cphilphis: reduced cohesion against the liquid content
/// - cstarmu: reduced cohesion against the friction coefficient
/// - coulombeff: stress ratio of the contact forces against P*, with the stress ratios of dry
///   grains
/// - zzcip: coordination numbers against P*
/// - phisdiffmu: solid fraction against P*
/// - appdiff: predicted against simulated stress ratio, without capillary shear stress
/// - s12pred: predicted against simulated stress ratio, with capillary shear stress
/// - cohcomp: cohesion by Rumpf's formula, divided by the cohesion from the straight line, against
///   1/P*
/// - cohgen: generalised cohesion, divided by the cohesion from the straight line, against 1/P*
/// - scaps: capillary shear stress against 1/P*
/// - scapcd: capillary shear stress by distant bridges divided by capillary shear stress by bridges
///   at contacts, against 1/P*
/// - fabric: fabric of contacts and of distant bridges against 1/P*
/// - scapdapp: capillary shear stress by distant bridges, predicted from the fabric and the
///   anisotropy of forces, against the simulated value
/// - scapapp: capillary shear stress by all bridges, predicted from the fabric and the anisotropy
///   of forces, against the simulated value
std::vector<Figure> paper_figures(const PaperStudy& study);

}  // namespace pendular
