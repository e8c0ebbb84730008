#include "analysis/ladder.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <utility>

namespace pendular {
namespace {

std::vector<std::string> sorted(std::vector<std::string> names) {
    std::ranges::sort(names);
    return names;
}

/// Whether two rungs are of the same study, up to what fresh runs may change.
bool same_study(const Rung& a, const Rung& b) {
    return sorted(a.effects) == sorted(b.effects) && a.dof == b.dof &&
           std::abs(a.chi2 - b.chi2) <= 0.05 * (std::max(a.chi2, b.chi2) + a.dof);
}

}  // namespace

const RungParameter* Rung::find(const std::string& name) const {
    const auto found = std::ranges::find(parameters, name, &RungParameter::name);
    return found == parameters.end() ? nullptr : &*found;
}

Rung rung_of(const Calibration& c, const Comparison& comparison,
             const std::optional<LeftOut>& left_out) {
    Rung rung;
    for (const auto& listed : c.model.effects) {
        rung.effects.push_back(listed.name);
    }
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        rung.parameters.push_back({c.parameters[k].name, c.parameters[k].unit, c.fit.parameters(i),
                                   c.fit.standard_error(i)});
    }
    rung.chi2 = comparison.total.chi2;
    rung.dof = comparison.total.dof;
    rung.rms_percent = comparison.rms_percent;
    if (left_out) {
        rung.left_out_percent = left_out->rms_percent;
    }
    return rung;
}

void climb(Ladder& ladder, Rung before, Rung after) {
    const auto append = [&](Rung& rung) {
        rung.step = ladder.empty() ? 0 : ladder.back().step + 1;
        ladder.push_back(std::move(rung));
    };
    if (ladder.empty() || !same_study(ladder.back(), before)) {
        before.change = "start";
        before.effect.clear();
        append(before);
    }
    append(after);
}

bool fell_by_chance(const Rung& from, const Rung& to) {
    // Where nothing more is fitted, chi2 may still change, as with a switch: as by one parameter.
    const boost::math::chi_squared law(std::max(1, from.dof - to.dof));
    return from.chi2 - to.chi2 <= boost::math::quantile(law, 0.95);
}

}  // namespace pendular
