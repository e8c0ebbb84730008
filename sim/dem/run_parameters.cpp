#include "sim/dem/run_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "data/quantities/number.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/shear_cell.h"

namespace pendular::dem {
namespace {

/// Kind of grains for which an observable is defined: all grains, or only grains with liquid
/// bridges.
enum class Wetness { all, wet };

constexpr Wetness grains_of[] = {
#define OBSERVABLE(name, symbol, unit, grains, ...) Wetness::grains,
#include "data/quantities/observables.def"
};

}  // namespace

bool needs_bridges(Observable which) {
    return grains_of[static_cast<std::size_t>(which)] == Wetness::wet;
}

Observable observable_named(std::string_view name) {
    const auto found = std::ranges::find(observable_names, name);
    if (found == observable_names.end()) {
        throw std::invalid_argument(fmt::format("unknown observable '{}'; use one of {}", name,
                                                fmt::join(observable_names, ", ")));
    }
    return static_cast<Observable>(found - observable_names.begin());
}

namespace {

void demand(bool holds, const std::string& what) {
    if (!holds) {
        throw std::invalid_argument(what);
    }
}

void check_wetting(const Wetting& w, double rupture_distance, double edge) {
    demand(w.reduced_pressure >= 0.05 && w.reduced_pressure <= 1e6,
           fmt::format("reduced pressure {} is not between 0.05 and 1e6", w.reduced_pressure));
    demand(w.bridge_volume >= 1e-6,
           fmt::format("bridge volume {} is below 1e-6 grain diameters cubed", w.bridge_volume));
    demand(
        rupture_distance <= edge / 4,
        fmt::format(
            "a bridge of volume {:.3g} d^3 ruptures at a gap of {:.3g} d, more than a quarter "
            "of the box, {:.3g} d (d: grain diameter): use more grains or a smaller bridge volume",
            w.bridge_volume, rupture_distance, edge / 4));
}

}  // namespace

// The limits are chosen against mistyped numbers. They are wider than the range in which the solver
// was compared with other codes (docs/validation.md).
void check_run_parameters(const RunParameters& p, const GrainEffects& effects) {
    demand(p.friction >= 0 && p.friction <= 2,
           fmt::format("friction {} is not between 0 and 2", p.friction));
    demand(p.inertial_number >= 1e-5 && p.inertial_number <= largest_inertial_number,
           fmt::format("inertial number {} is not between 1e-5 and {}", p.inertial_number,
                       largest_inertial_number));
    demand(p.stiffness_number >= 100 && p.stiffness_number <= 1e6,
           fmt::format("stiffness number {} is not between 100 and 1e6", p.stiffness_number));
    demand(p.poisson_ratio > -1 && p.poisson_ratio <= 0.5,
           fmt::format("Poisson ratio {} is not between -1 and 0.5", p.poisson_ratio));
    demand(p.damping >= 0 && p.damping <= 10,
           fmt::format("damping {} is not between 0 and 10", p.damping));
    demand(p.grains >= ShearCell::fewest_grains && p.grains <= 10'000'000,
           fmt::format("{} grains: a sample needs {} to 10000000", p.grains,
                       ShearCell::fewest_grains));
    demand(
        p.strain >= 0.5 && p.strain <= 1e4,
        fmt::format(
            "averaged strain {} is not between 0.5 and 10000; solid fractions decorrelate over a "
            "strain of 0.1 to 0.2",
            p.strain));
    for (const Precision& wanted : p.precision) {
        const auto name = observable_names[static_cast<std::size_t>(wanted.which)];
        demand(wanted.standard_error > 0,
               fmt::format("precision {} of {} is not above 0", wanted.standard_error, name));
        demand(p.wetting || !needs_bridges(wanted.which),
               fmt::format("precision of {}: it needs liquid bridges", name));
    }
    if (p.wetting) {
        check_wetting(*p.wetting, effects.changed(BridgeLaw(*p.wetting)).rupture_distance,
                      ShearCell::edge(p.grains));
    }
    demand(
        p.start == 0 || effects.diameters(2, 1).empty(),
        "a run cannot start from the state of another where its grains are to be of other sizes");
}

Precision precision_named(std::string_view text) {
    const auto equals = std::min(text.find('='), text.size());
    const auto error = parse_number(text.substr(std::min(equals + 1, text.size())));
    demand(error.has_value(),
           "an observable and its standard error are needed, as in stress_ratio=0.003");
    return {observable_named(text.substr(0, equals)), *error};
}

}  // namespace pendular::dem
