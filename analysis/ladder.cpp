#include "analysis/ladder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

std::vector<std::string> sorted(std::vector<std::string> names) {
    std::ranges::sort(names);
    return names;
}

/// Whether two ladder steps describe the same model of a study: equal effects and degrees of
/// freedom, and chi2 equal up to the change that new runs may cause.
bool same_study(const LadderStep& a, const LadderStep& b) {
    return sorted(a.effects) == sorted(b.effects) && a.dof == b.dof &&
           std::abs(a.chi2 - b.chi2) <= 0.05 * (std::max(a.chi2, b.chi2) + a.dof);
}

}  // namespace

const LadderParameter* LadderStep::find(const std::string& name) const {
    const auto found = std::ranges::find(parameters, name, &LadderParameter::name);
    return found == parameters.end() ? nullptr : &*found;
}

LadderStep ladder_step_of(const Calibration& c, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out) {
    LadderStep ladder_step;
    for (const auto& listed : c.model.effects) {
        ladder_step.effects.push_back(listed.name);
    }
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        ladder_step.parameters.push_back({c.parameters[k].name, c.parameters[k].unit,
                                          c.fit.parameters(i), c.fit.standard_error(i),
                                          c.fit.width(i), static_cast<bool>(c.fit.at_bound[k])});
    }
    ladder_step.chi2 = comparison.total.chi2;
    ladder_step.dof = comparison.total.dof;
    ladder_step.rms_percent = comparison.rms_percent;
    if (left_out) {
        ladder_step.left_out_percent = left_out->rms_percent;
    }
    return ladder_step;
}

void add_step(Ladder& ladder, LadderStep before, LadderStep after) {
    const auto append = [&](LadderStep& ladder_step) {
        ladder_step.step = ladder.empty() ? 0 : ladder.back().step + 1;
        ladder.push_back(std::move(ladder_step));
    };
    if (ladder.empty() || !same_study(ladder.back(), before)) {
        before.change = "start";
        before.effect.clear();
        append(before);
    }
    append(after);
}

Reduction reduction_of(const LadderStep& from, const LadderStep& to) {
    constexpr double confidence = 1 - significant_p;
    // A switch changes chi2 without a further fitted parameter: it counts as one parameter.
    const int added = std::max(1, from.dof - to.dof);
    const double reduction = from.chi2 - to.chi2;
    if (reduction <= chi_squared_quantile(confidence, added)) return Reduction::by_chance;
    const bool misfit = to.dof > 0 && to.chi2 > chi_squared_quantile(confidence, to.dof);
    if (misfit &&
        reduction / added <= to.chi2_per_dof() * fisher_f_quantile(confidence, added, to.dof))
        return Reduction::beside_misfit;
    return Reduction::significant;
}

}  // namespace pendular
